/// Where a left wheel meets a left rail when it is lowered without turning.
///
/// The vertical distance between the wheel's contact locus and the rail,
///   d(s) = z_locus(s) - z_rail(y_locus(s)),
/// is scanned over all nodes of the wheel profile; each local least place is then refined to the
/// root of the sine of the angle between wheel and rail tangent (the paper, equations 1 to 8, here
/// one-dimensional). The scan is global: no contact is missed that is wider than the node distance
/// of the profile curve (at most 0.5 mm).
/// Units mm and rad; track frame, left side (geometry/frames.hpp). Thread rule: pure functions.
#pragma once

#include <vector>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"

namespace wrc {

/// A locally least distance of wheel and rail, with the wheelset's centre at height 0.
struct ContactCandidate {
  LocusPoint wheel;
  double distance = 0.0;   ///< vertical, z_wheel - z_rail; the wheel touches at height -distance
  double rail_angle = 0.0; ///< of the rail's tangent about x, rad, > 0: rises to the left
  bool at_profile_end = false;
};

/// One sample of the scan.
struct DistanceSample {
  LocusPoint wheel;
  double distance = 0.0;   ///< vertical
  double rail_angle = 0.0; ///< rad
};

struct ContactScan {
  std::vector<DistanceSample> samples;      ///< over the rail only, from flange to field side
  std::vector<ContactCandidate> candidates; ///< least distance first
};

/// Scans and refines. `near_tolerance` (mm, >= 0): a candidate is kept if its distance exceeds the
/// least one by no more. `with_samples` also keeps the scan itself.
/// Throws Error(no_contact) if no part of the wheel is over the rail.
ContactScan search_contacts(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose,
                            double near_tolerance, bool with_samples);

} // namespace wrc
