/// What must hold for every scene that can be solved, whatever it is. Each check returns what is
/// wrong, in one line, or nothing.
#pragma once

#include <string>

#include "drawn_scene.hpp"
#include "outcome.hpp"

namespace properties {

/// No pressure is negative, pressures sum up to the forces, the forces to the load, and the bodies
/// neither overlap nor part where there is pressure (Karush, Kuhn, Tucker).
std::string check_equilibrium(const DrawnScene& scene, const Outcome& outcome);
/// y -> -y exchanges left and right, exactly.
std::string check_mirror(const DrawnScene& scene, const Outcome& outcome);
/// In m, N, Pa the same comes out; `most` is the relative difference.
std::string check_units(const DrawnScene& scene);
/// Moduli and loads times 2^k multiply pressures and leave lengths as they are.
std::string check_stiffness(const DrawnScene& scene, const Outcome& outcome);
/// More load, more depth; more depth, more force.
std::string check_monotony(const DrawnScene& scene, const Outcome& outcome);
/// After another scene the solver gives the same bits.
std::string check_solver(const DrawnScene& scene, const Outcome& outcome);
/// Among others in a batch on two threads, bit for bit the same.
std::string check_batch(const DrawnScene& scene, const Outcome& outcome);

/// Solves a scene by itself.
Outcome solved(const DrawnScene& scene, bool with_fields = false);

} // namespace properties
