/// How the forces of a solved tangential problem change with its pressures and its grid.
///
/// Elements move with the grid, and tractions keep their fraction of the bound at first,
///   q' = q g'/g,  s' = w' + B q' + B' q;
/// what this does to slips is undone by z with the equations as linearised at the solution
/// (traction_loops.hpp): dq = q' + z, P (B z + s') + ratio z = 0. In slip q' = g' n, so z has but
/// the part that turns n. w' by the positions that move in the spin and by the rate of the slip
/// given for each element; B depends on the grid by the ratio of its steps, and on where leading
/// edges are in their elements (leading_edge.hpp). Thread rule: as the solver's. Not known here:
/// what moves pressures and grid.
#pragma once

#include <array>
#include <vector>

#include "rolling/rolling_problem.hpp"
#include "rolling/scaled_tractions.hpp"
#include "rolling/traction_newton.hpp"

namespace wrc {

/// Rates of Fx, Fy (N), Mz (N mm) and the weighted force (N), for each of the problem's rates.
template <typename Real>
std::vector<std::array<double, 4>> rates_of_forces(const RollingProblem& problem,
                                                   const ScaledTractions& scaled,
                                                   TractionNewton<Real>& solved, LinePlans& plans);

} // namespace wrc
