/// Sensitivities of a side's solution, and what they need of it.
///
/// The contact search and the patches are done again, with their rates
/// (derivatives/plane_rates.hpp), at the height solved for. Pairs of forces are equal
/// (make_symmetric), but where patches interact in part: their coupling weight follows from no
/// energy. Patches that interact do so here too, with the rates of their coupling weight. Against
/// central differences of whole solutions on 96 x 96 elements (each with planes, areas and grids of
/// its own): up to 3e-3 of the largest rate, half of the cases below 1e-3. Where two patches in
/// planes far apart are about to join, up to 7 per cent: contact ends there at a boundary to the
/// neighbour that moves, which is left out. Where the rail or the wheel varies planes and elements
/// stay in the track: their directions count to second order. Units mm, N, rad; track frame. Thread
/// rule: a pure function.
#pragma once

#include <optional>

#include "records/wheel_result.hpp"

namespace wrc {

/// None without contact, for an approximate model, or where a solution that has not settled gives
/// no numbers.
std::optional<WheelRates> wheel_rates_of(const WheelResult& side);

} // namespace wrc
