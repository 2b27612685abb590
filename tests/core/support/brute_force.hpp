/// A second way to find where a left wheel meets a left rail, as reference only.
///
/// Two-dimensional: points of the wheel's surface over its profile arc and the angle about the
/// axle are compared with the rail below them, on a grid that shrinks around the best ones. It
/// uses neither the contact locus nor tangents nor Newton's method.
/// Units mm, rad; track frame, left side, wheelset's centre at height 0.
#pragma once

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"

namespace wrc::test {

struct BruteForceContact {
  double distance = 0.0; ///< least vertical distance
  Vector3 position;      ///< of the wheel point
  double arc = 0.0;      ///< on the wheel profile
  double angle = 0.0;    ///< about the axle
};

BruteForceContact brute_force_contact(const WheelSurface& wheel, const RailSurface& rail,
                                      const Pose& pose);

/// Height of the rail over y by bisection on the arc length; NaN beside the rail.
double rail_height(const RailSurface& rail, double y);

} // namespace wrc::test
