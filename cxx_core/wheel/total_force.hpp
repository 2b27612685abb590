/// All contact forces of a wheel together, normal and tangential.
///
/// Those of the rail on the wheel, summed over the patches, with their moments and the spin moments
/// about the wheelset's centre as the wheel has it: each wheel approaches the rail by its own
/// depth. Track frame (geometry/frames.hpp), both sides alike. Units N, N mm. Thread rule: pure
/// function.
#pragma once

#include "wheel/wheel_result.hpp"

namespace wrc {

TotalForce total_force(const WheelResult& wheel);

} // namespace wrc
