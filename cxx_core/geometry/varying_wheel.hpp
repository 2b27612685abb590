/// A wheel whose profile varies around its circumference: flats by slices, polygons and
/// eccentricity by harmonics.
///
///   r(theta, u) = r_0 + w(u, theta) + sum_n a_n cos(n theta - phase_n)
/// at the lateral place s(u, theta), with (s, w) a sheet that is periodic over 2 pi
/// (surface_sheet.hpp). Where a list of slices leaves a part of the revolution out, the surface
/// goes straight in theta from its last slice to its first. Units mm, rad; frame of the wheel's
/// profile, theta in the sense of its slices file. Thread rule: immutable
/// after construction, safe to share.
#pragma once

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

class VaryingWheel {
public:
  /// `smoothing_length` on the circumference, mm, as of VaryingRail. Throws
  /// Error(invalid_argument): a folded surface, with the numbers of the slices; radii that are not
  /// positive; harmonics of an order below 1 or above 1000, or that are not finite.
  VaryingWheel(const SlicedProfile& profile, double radius,
               std::vector<RadiusHarmonic> harmonics = {},
               std::optional<double> smoothing_length = {});
  /// The same profile everywhere except for the harmonics.
  VaryingWheel(const Curve& profile, double radius, std::vector<RadiusHarmonic> harmonics);

  [[nodiscard]] std::span<const SurfaceSheet> sheets() const { return sheets_; }
  [[nodiscard]] std::span<const RadiusHarmonic> harmonics() const { return harmonics_; }
  [[nodiscard]] double radius() const { return radius_; }
  /// On the circumference, mm.
  [[nodiscard]] double smoothing_length() const { return smoothing_length_; }
  /// A point of a sheet, with the harmonics: lateral place and radius less r_0; along is theta.
  [[nodiscard]] SheetPoint at(std::size_t sheet, double across, double theta) const;
  /// The profile's outermost point at a lateral place, with the harmonics: radius less r_0 over
  /// (theta, lateral); none where the wheel has none.
  [[nodiscard]] std::optional<GraphPoint> over(double theta, double lateral) const;
  /// The profile at an angle, with the harmonics: of the sheet that is widest there.
  [[nodiscard]] Curve section(double theta) const;

private:
  struct Wave {
    double value = 0.0;
    double first = 0.0; ///< by theta
    double second = 0.0;
  };
  [[nodiscard]] Wave wave(double theta) const;
  void check() const;

  double radius_;
  double smoothing_length_;
  std::vector<RadiusHarmonic> harmonics_;
  std::vector<SurfaceSheet> sheets_;
};

} // namespace wrc
