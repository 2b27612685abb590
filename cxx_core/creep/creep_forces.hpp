/// Creep forces of the patches of a wheel, from the pressures found.
///
/// Each patch is solved by itself on a grid of its own over the rectangle around its contact, with
/// the pressures interpolated to it (pressure/smooth_pressure.hpp) and scaled to its normal force.
/// Elements follow from the requested accuracy and the pressures (creep_grid.hpp); where their
/// number does not change, forces are continuous functions of the scene. Patches of one plane are
/// solved one by one as well, each with the rigid slip at its position. Tractions of unlike bodies
/// change the pressures they stem from: the full model takes that into the pressures on its own
/// grid (rolling/unlike_bodies.hpp).
///
/// Results: creep_result.hpp. Units mm, N, MPa, rad. Thread rule: as the solver's.
///
/// Not known here: what the tractions of patches displace at each other, and what those of unlike
/// bodies change in the results of normal contact.
#pragma once

#include <vector>

#include "creep/creep_request.hpp"
#include "records/creep_result.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

struct PatchRates;
struct PatchResult;
struct WheelRates;
struct WheelResult;

/// Computes the creep forces of all patches, replacing earlier ones. `rates`: of the normal
/// contact, for the derivatives by positions.
void solve_creep_forces(WheelResult& wheel, const CreepRequest& request, RollingSolver& solver,
                        const WheelRates* rates = nullptr);
/// Those of one patch, and of its parts; of a request with a motion those of the wheel's motion as
/// solve_creep_forces has set it. `rates`: of the patch, or of its parts one after the other, for
/// the derivatives by positions.
CreepResult creep_of_patch(const WheelResult& wheel, const PatchResult& patch,
                           const CreepRequest& request, RollingSolver& solver,
                           std::vector<CreepResult>& parts, const PatchRates* rates = nullptr);
/// Error of the elements over mu N, of all patches, each by its share of the load: one that has
/// just formed is on few elements.
double error_of_creep_forces(const WheelResult& wheel);
/// Adds the warnings that the creep forces found give rise to.
void warn_of_creep_forces(WheelResult& wheel, const CreepRequest& request);

} // namespace wrc
