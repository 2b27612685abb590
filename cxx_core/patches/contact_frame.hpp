/// The plane in which a contact patch is gridded, and the direction in which gaps are measured.
///
/// Two conventions:
///  - `tangent`: origin on the rail; longitudinal where the tangent plane meets a plane through the
///    track's x and z, which is x on a rail that does not rise; lateral across it, normal that of
///    the plane. Right for contacts of any steepness. The wheel's material turns in planes of x and
///    z, so that a rail that rises evenly is a level one on a track turned about y.
///  - `vertical`: the wheelset frame's own x, y and z, as the paper measures (steps a to f of its
///    section 2.2). Right only for small contact angles; kept to reproduce the paper.
/// Both frames are given in the track frame of the side, left-hand side (geometry/frames.hpp).
///
/// Where the surface turns, the rows of a patch may lie along a curve in place of the plane
/// (patches/contact_curve.hpp). Lateral positions are then arcs of the curve, and normal positions
/// count along its normals; `lateral` and `normal` remain those of the plane.
/// Units mm and rad.
#pragma once

#include <memory>
#include <vector>

#include "base/grid.hpp"
#include "geometry/frames.hpp"
#include "patches/contact_curve.hpp"

namespace wrc {

enum class GapConvention { vertical, tangent };

struct ContactFrame {
  Vector3 origin;
  Vector3 longitudinal{1.0, 0.0, 0.0};
  Vector3 lateral{0.0, 1.0, 0.0};                      ///< towards the field side
  Vector3 normal{0.0, 0.0, 1.0};                       ///< from the rail to the wheel
  bool tangent = false;                                ///< by that convention
  std::shared_ptr<const ContactCurve> curve = nullptr; ///< none: rows lie in the plane

  [[nodiscard]] Vector3 to_track(double longitudinal_position, double lateral_position,
                                 double normal_position) const;
  /// Where a row crosses x = 0, from the origin, and its own axes.
  struct Row {
    Vector3 place;
    Vector3 lateral;
    Vector3 normal;
  };
  [[nodiscard]] Row row_at(double lateral_position) const;
  /// Lateral position of a place that lies by a vector from the origin.
  [[nodiscard]] double lateral_of(const Vector3& from_origin) const;
  /// The same plane, and curve, from another origin.
  [[nodiscard]] ContactFrame seen_from(const Vector3& new_origin) const;
  /// Inclination of the plane's section across the track (by the other convention: of the lateral
  /// axis against the track plane), rad, > 0: rises to the field side.
  [[nodiscard]] double angle() const;
};

/// Inclinations of the rows to the plane, rad, > 0: rise to the field side; none without a curve.
std::vector<double> row_angles(const ContactFrame& frame, const Grid& grid);

/// `rise`: by how much the rail rises along the track, over the length in the plane across that.
ContactFrame tangent_frame(Vector3 origin, double contact_angle, double rise = 0.0);
ContactFrame vertical_frame(Vector3 origin, const Rotation& wheelset_rotation);

} // namespace wrc
