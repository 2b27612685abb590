/// Sensitivities of a side's solution: what they need of it, and where it is kept.
///
/// The contact search and the patches are done again, with their rates
/// (derivatives/plane_rates.hpp), at the height solved for. Pairs of forces are equal
/// (make_symmetric), but where patches interact in part: how much they do is no matter of an
/// energy. Patches that interact do so here too, and by as much more or less as their coupling
/// weight changes. Against central differences of whole solutions on 96 x 96 elements (each with
/// planes, areas and grids of its own): up to 3e-3 of the largest rate, half of the cases below
/// 1e-3. Where two patches in planes far apart are about to join, up to 7 per cent: contact ends
/// there at a boundary to the neighbour that moves, which is left out. Units mm, N, rad; track
/// frame. Thread rule: one thread at a time for a result.
#pragma once

#include "records/wheel_result.hpp"

namespace wrc {

/// Computed once; none without contact, for an approximate model, or where a solution that has not
/// settled gives no numbers.
const WheelRates* sensitivities_of(WheelResult& side);

} // namespace wrc
