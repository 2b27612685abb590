/// Sensitivities of a side's solution: what they need of it, and where it is kept.
///
/// The contact search and the patches are done again, with their rates (remesh/plane_rates.hpp), at
/// the height at which the distance was sampled; forces at the height at which the pressures have
/// the approach 0, which is the first touch less the depth solved for. Patches that feel each other
/// do so here too.
/// Units mm, N, rad; track frame. Thread rule: one thread at a time for a result.
#pragma once

#include "scene/side_result.hpp"

namespace wrc {

/// Computed once; none without contact.
const SideRates* sensitivities_of(SideResult& side);

} // namespace wrc
