/// Kalker's coefficients of a patch of any shape: how its creep forces begin.
///
///   c11 = -dFx/dxi/(G a b),  c22 = -dFy/deta/(G a b),  c33 = -dMz/dphi/(G (a b)^2)
///   c23 = (dMz/deta - dFy/dphi)/2/(G (a b)^(3/2))
/// with the derivatives of the full theory at zero creepage, where all of the contact adheres,
/// about the centre of pressure, and the semi-axes a and b of the ellipse with the pressures'
/// second moments. Found with the elements of creep forces for the accuracy of `options` and with
/// such of twice the size, and continued to none, as errors fall with the size. They do not depend
/// on friction. The same on both sides. Thread rule: as the solver's.
/// Not known here: what pressures and tractions of unlike bodies do to each other, and couplings
/// that symmetric contacts do not have (dFx/dphi and the like): CreepDerivatives has them.
#pragma once

#include "creep/creep_request.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

struct WheelResult;

/// Sets PatchResult::kalker of all patches that have pressures; where several have one plane, of
/// each of them. `options`: of the scene, without creepages or a motion.
void find_patch_coefficients(WheelResult& wheel, const CreepRequest& options,
                             RollingSolver& solver);

} // namespace wrc
