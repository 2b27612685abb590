/// Creep forces of a patch of unlike bodies, whose tractions and pressures change each other.
///
/// Calls the plain solution for one pressure after the other (rolling/unlike_bodies.hpp), on the
/// patch's own grid, which has room for a contact that moves (creep_elements.hpp).
/// Left-hand frame of the side. Units mm, N, MPa, rad. Thread rule: as the solver's.
///
/// Not known here: derivatives by positions and by the slip beyond creepages.
#pragma once

#include "creep/creep_problem.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

/// As forces_on_patch (creep_on_patch.hpp), by the full theory; the pressures of `creep` are those
/// with tractions.
CreepForces forces_of_unlike_bodies(const PatchTask& task, RollingSolver& solver,
                                    CreepResult& creep);

} // namespace wrc
