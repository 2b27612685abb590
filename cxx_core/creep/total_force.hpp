/// All contact forces of a wheel together, normal and tangential.
///
/// Those of the rail on the wheel, summed over the patches, with their moments and the spin moments
/// about the wheelset's centre as the wheel has it: each wheel approaches the rail by its own
/// depth. Track frame (geometry/frames.hpp), both sides alike. Units N, N mm. Thread rule: pure
/// functions of their arguments.
#pragma once

#include "records/wheel_result.hpp"

namespace wrc {

WheelForce total_force(const WheelResult& wheel);
/// Fills in PatchResult::total_force of all patches and their parts: without creep forces that of
/// the pressures, bit for bit.
void add_up_forces(WheelResult& wheel);

} // namespace wrc
