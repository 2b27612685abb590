/// From a solution in the left-hand frame of its side to the result in the track frame.
///
/// Units mm, N, N mm, MPa, rad. Thread rule: pure functions.
#pragma once

#include <memory>

#include "geometry/side_frame.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "records/wheel_result.hpp"
#include "records/wheel_solution.hpp"

namespace wrc {

/// Where the normal through a point of a patch's plane meets rail and wheel.
ContactPoint point_on(const PosedPair& pair, const ContactFrame& frame, double longitudinal,
                      double lateral, const SideFrame& side);

/// `mirror`: as WheelDetails.
WheelResult make_wheel_result(WheelSolution solution,
                              const std::shared_ptr<const WheelSurface>& wheel,
                              const std::shared_ptr<const RailSurface>& rail,
                              const SideEquilibrium& equilibrium, double mirror);

} // namespace wrc
