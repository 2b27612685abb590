/// Whether a side is in contact at the depth found, and what is said where it cannot be trusted.
///
/// Rounding: places of the wheel are told to the rounding of its radius, eps R. An overlap of n
/// such roundings has pressures that scatter by about 30/n (by measurement, n = 1e4 to 1e5:
/// docs/stability.md). Units mm, N. Thread rule: pure functions.
#pragma once

#include <string>
#include <vector>

#include "scene/side_request.hpp"
#include "scene/trial.hpp"

namespace wrc {

/// Whether there is contact at a depth found from the request. If not, a warning says why: loads
/// too small to tell from none are taken for none. An absurd overlap throws
/// Error(invalid_argument).
bool is_in_contact(const SideRequest& request, double depth, std::vector<std::string>& warnings);

/// Throws Error(no_contact) if the depth that a load asked for in the end is no overlap of wheel
/// and rail. `depth` is vertical, from the first touch.
void check_depth_found(const SideRequest& request, double depth);

/// A trial after which the search gives up, though it is in contact: not converged, and a warning
/// tells after how many solutions.
void mark_unsettled(Trial& trial, int solutions, std::vector<std::string>& warnings);

/// Warns of overlaps so small that rounding of positions is felt in the pressures.
void warn_of_rounding(const Trial& trial, double wheel_radius, std::vector<std::string>& warnings);

} // namespace wrc
