/// The surface through the slices of a profile: of a rail that varies along the track, or of a
/// wheel that varies around its circumference.
///
/// It consists of sheets (surface_sheet.hpp), which begin and end where its parts do. A wheel has
///   r(theta, u) = r_0 + w(u, theta) + sum_n a_n cos(n theta - phase_n)
/// at the lateral place s(u, theta), with (s, w) a sheet that is periodic over 2 pi: flats by
/// slices, polygons and eccentricity by harmonics. Where a list leaves a part of the revolution
/// out, the surface goes straight in theta from its last slice to its first.
///
/// Frame of the profile: lateral to the field side, height upwards (of a wheel: its radius less
/// r_0). Along is forward from the origin of the slices file in mm, or theta in rad in the sense of
/// that file. Not yet inclined or placed in the track, or turned.
/// Not covered: what is before a rail's first and beyond its last slice: no rail is there.
/// Thread rule: immutable after construction, safe to share.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/sliced_sheets.hpp"

namespace wrc {

struct RadiusHarmonic {
  int order = 1;          ///< waves around the wheel; 1: eccentricity
  double amplitude = 0.0; ///< mm
  double phase = 0.0;     ///< rad
  bool operator==(const RadiusHarmonic&) const = default;
};

/// An end of a part along the track or around the wheel.
struct PartEnd {
  double place = 0.0;
  double distance = 0.0; ///< from where it was asked for
};

/// Where a surface does not vary.
struct ConstantStretch {
  Stretch along;
  double rise = 0.0; ///< of the surface elsewhere over the section here, mm
};

class SlicedSurface {
public:
  /// `period` 0, or that of a wheel.
  SlicedSurface(std::vector<SurfaceSheet> sheets, double period,
                std::vector<RadiusHarmonic> harmonics);

  [[nodiscard]] std::span<const SurfaceSheet> sheets() const { return sheets_; }
  /// From the begin of the first part to the end of the last.
  [[nodiscard]] Stretch along() const;
  /// How far it is along to the nearest part, 0 at one.
  [[nodiscard]] double distance_to_part(double along) const;
  /// Where one part alone is, and its sections are the same to 1e-9 mm.
  [[nodiscard]] std::vector<ConstantStretch> constant_stretches() const;
  /// Its steepest rise or fall along; infinite with ends of parts, where contact has any slope.
  [[nodiscard]] double steepest_along() const { return steepest_along_; }
  /// None if all parts are closed around the wheel.
  [[nodiscard]] std::optional<PartEnd> nearest_end(double along) const;

  /// The highest point over a place, of all parts; none where there is no part.
  [[nodiscard]] std::optional<GraphPoint> over(double along, double lateral) const;
  /// Heights of one section over lateral places in ascending order, without harmonics; minus
  /// infinity where there is no part, or it is steep.
  void heights(double along, std::span<const double> laterals, std::span<double> heights) const;
  /// The widest part at a place, or in a gap of those nearest to it.
  [[nodiscard]] Curve section(double along) const;
  /// All parts at a place, without harmonics.
  [[nodiscard]] std::vector<Curve> sections(double along) const;

private:
  struct Wave {
    double value = 0.0;
    double first = 0.0; ///< by theta
    double second = 0.0;
  };
  [[nodiscard]] Wave wave(double theta) const;

  std::vector<SurfaceSheet> sheets_;
  double period_;
  std::vector<RadiusHarmonic> harmonics_;
  double steepest_along_ = 0.0;
};

/// `smoothing_length`: waves along the track of this length in mm are halved, 0: the surface passes
/// through the slices; none: as the list says. Throws Error(invalid_argument), for a folded surface
/// with the numbers of the slices.
std::shared_ptr<const SlicedSurface> sliced_rail(const SlicedProfile& profile,
                                                 std::optional<double> smoothing_length = {});
/// `smoothing_length` on the circumference, mm. Throws also for radii that are not positive, and
/// for harmonics of an order below 1 or above 1000, or that are not finite.
std::shared_ptr<const SlicedSurface> sliced_wheel(const SlicedProfile& profile, double radius,
                                                  std::vector<RadiusHarmonic> harmonics = {},
                                                  std::optional<double> smoothing_length = {});
/// The same profile everywhere except for the harmonics.
std::shared_ptr<const SlicedSurface> sliced_wheel(const Curve& profile, double radius,
                                                  std::vector<RadiusHarmonic> harmonics);

} // namespace wrc
