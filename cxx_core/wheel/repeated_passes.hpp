/// The groove that a wheel whose steel yields leaves on its rows, from pass to pass.
///
/// Each row of a wheel and rail that roll passes under the whole length of a contact. Afterwards it
/// is deeper by the largest indentation along that length, and has carried the largest pressure.
/// The next pass of the same wheel over the same place finds the groove in its distances, and
/// steel that takes only what it has not taken before (mechanics/yielding.hpp).
/// Units mm, MPa. Thread rule: pure functions.
#pragma once

#include <span>

#include "accuracy/grid_solution.hpp"
#include "base/warning.hpp"

namespace wrc {

/// Adds to a patch, whose distances are those of the profiles, what the passes up to a solution
/// have left. Patches of both have nearly the same planes where they overlap.
void take_groove(const GridSolution& before, Patch& patch);

/// Whether a pass is to follow this one: not beyond `passes`, where the groove is settled, or where
/// this one has not converged, of which it warns.
bool another_pass(const GridSolution& solution, int pass, int passes, Warnings& warnings);

/// Adds what this pass leaves, once the patch is solved: the indentation of each body that yields,
/// as its solver has it.
void leave_groove(std::span<const YieldingBody> bodies,
                  std::span<const std::vector<double>> indentation, Patch& patch);

} // namespace wrc
