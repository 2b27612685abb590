/// Rolling contact of unlike bodies: pressures and tractions in turn.
///
/// Pressures displace unlike bodies along the surface, tractions across it. The normal problem with
/// the gap that tractions open, and the tangential one with the slip that pressures add, are solved
/// alternately until the pressures stay (Panagiotopoulos; Kalker, Three-Dimensional Elastic Bodies
/// in Rolling Contact, 1990, ch. 4.1). The change that tractions cause is taken from two normal
/// solutions on one grid, with and without it, and added to the pressures given: so these may come
/// from another grid, or from patches that interact.
/// Units mm, N, MPa. Thread rule: as the solvers'.
/// Not known here: that the fraction of the load on a patch changes, and its plane.
#pragma once

#include <vector>

#include "mechanics/normal_solver.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

struct UnlikeSolution {
  RollingSolution rolling;
  std::vector<double> pressure; ///< MPa per element, of the same sum as those given
  double pressure_change = 0.0; ///< sum of changes by tractions over the sum of pressures
  int alternations = 0;
  bool converged = false;
};

/// `problem` holds the pressures of the normal problem without tractions, `distance` the undeformed
/// distance on its grid, which must have room around the contact. Ends when forces change by less
/// than `tolerance` times friction times load.
/// Throws Error(invalid_argument) like the solvers.
UnlikeSolution solve_unlike(const RollingProblem& problem, std::span<const double> distance,
                            double combined_modulus, double tolerance, RollingSolver& rolling);

} // namespace wrc
