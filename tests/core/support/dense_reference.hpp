/// Reference solution of the normal contact problem by dense Cholesky factors, for small grids.
///
/// Block principal pivoting on the linear complementarity problem (Judice & Pires, Computers &
/// Operations Research 21 (1994) 587-596): all elements of the wrong sign change sides at once;
/// when that stops helping, only the last of them does (Murty's rule, finite for a prescribed
/// approach). Shares with the core only the influence coefficients.
#pragma once

#include <vector>

#include "support/patch_problem.hpp"

namespace wrc::test {

struct DenseSolution {
  std::vector<double> pressure;
  double approach = 0.0;
};

/// Throws std::runtime_error when LAPACK fails or the exchange does not end.
DenseSolution solve_densely(const PatchProblem& problem);

} // namespace wrc::test
