/// A wheel whose steel yields: from its elastic solution to the pressures that steel carries.
///
/// The elastic solution comes first and decides. Below the onset of yield (half_space/steel.hpp) it
/// is the answer. Beyond, it gives what pressures would be without yielding, and how far its
/// section has pmax above the elements; of that, steel carries as much less as of pmax itself.
/// Stated errors are those of the law against finite elements (docs/evidence/half-space.md).
/// Units mm, MPa. Thread rule: pure functions.
#pragma once

#include <span>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "records/wheel_solution.hpp"

namespace wrc {

/// Whether any element of an elastic solution is beyond the onset.
bool yields(const GridSolution& elastic, std::span<const YieldingBody> bodies);

/// About the pressures that steel carries instead of elastic ones, to start from.
GridSolution softened(GridSolution elastic, std::span<const YieldingBody> bodies);

/// Sets Patch::elastic_peak of each patch that yields from the patches of the elastic solution
/// nearest to it, and adds to its peak what their sections add to theirs.
void set_elastic_peaks(GridSolution& solution, const GridSolution& elastic,
                       std::span<const YieldingBody> bodies);

/// Adds the error of the law to that of the model, with its warning, where steel yields.
void state_error_of_yield(WheelSolution& result);

} // namespace wrc
