/// Kalker's coefficients of a patch of any shape: how its creep forces begin.
///
///   c11 = -dFx/dxi/(G a b),  c22 = -dFy/deta/(G a b),  c33 = -dMz/dphi/(G (a b)^2)
///   c23 = (dMz/deta - dFy/dphi)/2/(G (a b)^(3/2))
/// with the derivatives of the full theory at zero creepage, where all of the contact adheres,
/// about the centre of pressure, and the semi-axes a and b of the ellipse with the pressures'
/// second moments. Solved without slip on the elements in contact. What elements leave is that of
/// this ellipse on the same elements, and is taken out: found/(ellipse on elements) times the
/// ellipse's (rolling/kalker_coefficients.hpp). They do not depend on friction. Of unlike bodies
/// what pressures and tractions do to each other is left out. The same on both sides. Thread rule:
/// as the solver's.
#pragma once

#include "rolling/rolling_contact.hpp"

namespace wrc {

struct WheelResult;

/// Sets PatchResult::kalker of all patches that have pressures on elements; where several have one
/// plane, of each of them.
void find_patch_coefficients(WheelResult& wheel, double poisson, RollingSolver& solver);

} // namespace wrc
