/// The plane in which a contact patch is gridded, and the direction in which gaps are measured.
///
/// Two conventions:
///  - `tangent`: origin on the rail; longitudinal along the track's x, lateral along the tangent
///    at the contact angle, normal = the angle's normal. Right for contacts of any steepness.
///  - `vertical`: the wheelset frame's own x, y and z, as the paper measures (steps a to f of its
///    section 2.2). Right only for small contact angles; kept to reproduce the paper.
/// Both frames are given in the track frame of the side, left-hand side (geometry/frames.hpp).
/// Units mm and rad.
#pragma once

#include "geometry/frames.hpp"

namespace wrc {

enum class GapConvention { vertical, tangent };

struct ContactFrame {
  Vector3 origin;
  Vector3 longitudinal{1.0, 0.0, 0.0};
  Vector3 lateral{0.0, 1.0, 0.0}; ///< towards the field side
  Vector3 normal{0.0, 0.0, 1.0};  ///< from the rail to the wheel
  bool tangent = false;           ///< by that convention

  [[nodiscard]] Vector3 to_track(double longitudinal_position, double lateral_position,
                                 double normal_position) const;
  /// Inclination of the lateral axis against the track plane, rad, > 0: rises to the field side.
  [[nodiscard]] double angle() const;
};

ContactFrame tangent_frame(Vector3 origin, double contact_angle);
ContactFrame vertical_frame(Vector3 origin, const Rotation& wheelset_rotation);

} // namespace wrc
