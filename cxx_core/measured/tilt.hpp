/// Whether a wheel was measured with a tilt: by its flange back and field face, which are planes
/// across the axle, and by wheels that are built in.
///
/// A tilt of 0.1 degrees changes pmax of S1002 by 15 to 20 %, one of 1 degree by 70 %. Both faces
/// together are a clear reference if they are parallel; then the points are turned back. One face
/// is none, which is a warning. On measured wheels flange backs are tilted by up to 0.5 degrees,
/// and less than 0.7 changes nothing. Without faces, a wheel that lies on a built-in one after it
/// has been turned has a warning, too. Units mm and rad; tilts are positive anticlockwise in
/// (lateral, height). Thread rule: no state.
#pragma once

#include <optional>
#include <span>

#include "measured/reader_lines.hpp"
#include "profile/curve.hpp"

namespace wrc::reading {

/// A straight and almost vertical part at an end of a profile.
struct Face {
  double tilt = 0.0;
  double length = 0.0;
};
/// Points in the order of profile.hpp.
std::optional<Face> flange_back_of(std::span<const Position> points);
std::optional<Face> field_face_of(std::span<const Position> points);

/// The rotation that a clear reference asks for, which is reported as a guess; 0 if there is none
/// or no need. Warns of a tilt that is not sure enough.
double untilting_rotation(std::span<const Position> points, Log& log);

} // namespace wrc::reading
