/// A wheel whose steel yields: from its elastic solution to the pressures that steel carries.
///
/// The elastic solution comes first and decides. Below the onset of yield (half_space/steel.hpp) it
/// is the answer. Beyond, it gives what pressures would be without yielding, and which elements
/// resolve their crests; with these, steel yields.
/// Stated errors are those of the law against finite elements (docs/evidence/half-space.md).
/// Units mm, MPa. Thread rule: pure functions.
#pragma once

#include <span>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "accuracy/resolution.hpp"
#include "records/wheel_solution.hpp"

namespace wrc {

/// Whether any element of an elastic solution is beyond the onset.
bool yields(const GridSolution& elastic, std::span<const YieldingBody> bodies);

/// About the pressures that steel carries instead of elastic ones, to start from.
GridSolution softened(GridSolution elastic, std::span<const YieldingBody> bodies);

/// Of an elastic solution: its largest pressures go to Patch::elastic_peak, and what its section
/// added to its elements becomes an error, since no section knows steel that yields.
void take_back_sections(GridSolution& elastic);

/// Makes elements as small as the nearest ones of such a solution; with an accuracy of pressures as
/// small as its crests need, since these remain where steel yields.
void refine_for_yield(const GridSolution& elastic, const AccuracyGoal& goal,
                      std::vector<PatchElements>& elements);

/// Sets Patch::elastic_peak of each patch from the patches of an elastic solution without sections
/// nearest to it, and what is missing of a crest on its smaller elements as the error of its peak.
/// No peak is more than the elastic one; what a parabola adds to the elements at a flat crest is
/// uncertain. Sets Patch::bend, too.
void set_elastic_peaks(GridSolution& solution, const GridSolution& elastic,
                       const AccuracyGoal& goal, std::span<const YieldingBody> bodies);

/// Adds the error of the law to that of the model, with its warning, where steel yields and the
/// iteration has converged.
void state_error_of_yield(WheelSolution& result);

} // namespace wrc
