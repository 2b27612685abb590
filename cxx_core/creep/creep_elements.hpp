/// Elements of the creep forces of a wheel: those of its patches, within the limit for all of them.
///
/// If the patches together need more than the limit, each gets the same fraction of its need.
/// Thread rule: pure functions.
#pragma once

#include "creep/creep_grid.hpp"
#include "creep/creep_request.hpp"

namespace wrc {

struct PatchResult;
struct WheelResult;

/// Whether tractions are found on the pressures of patches, on grids of their own.
bool on_own_pressures(const CreepRequest& request);
/// Whether tractions and pressures change each other.
bool unlike_bodies(const CreepRequest& request);

/// Elements of a patch, of unlike bodies with the room that these need.
CreepGrid grid_of_patch(const PatchResult& patch, const SmoothPressure& pressure,
                        const CreepRequest& request);

/// Fraction of the elements needed by the patches of a wheel that the limit permits; 1: all.
double share_of_elements(const WheelResult& wheel, const CreepRequest& request);

/// The request with that share, and with the accuracy that this wheel permits: where the end of a
/// body cuts the contact, forces are no more accurate than its place.
CreepRequest with_elements(CreepRequest request, const WheelResult& wheel);

} // namespace wrc
