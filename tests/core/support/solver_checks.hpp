/// What tests of the default normal solver share: exact answers, the error of p, and the conditions
/// every answer must meet, recomputed from the pressures alone.
#pragma once

#include <string>
#include <vector>

#include "mechanics/normal_solver.hpp"
#include "support/patch_problem.hpp"

namespace wrc::test {

/// Tolerance of the answers that count as exact: a hundredth of the least one asked in the tests.
inline constexpr double exact_tolerance = 1e-11;
/// Overlap outside the rectangle of the iteration that counts as contact, in largest displacements,
/// whatever the tolerance (normal_solver.cpp); the rest is rounding of single precision.
inline constexpr double unseen_overlap = 2.1e-6;
/// Gaps inside contact, in largest displacements, over the tolerance of pressures: largest seen 1.1
/// (noise in elongated elements), 0.1 to 0.5 in smooth contacts.
inline constexpr double gap_share = 1.5;
/// Sum of some ten thousand pressures against the load.
inline constexpr double load_rounding = 1e-12;

/// The same problem in double precision with `exact_tolerance`.
PatchSolution solve_exactly(PatchProblem problem);

/// Largest difference of pressures relative to the largest exact one.
double pressure_error(const std::vector<double>& pressure, const std::vector<double>& exact);

/// p >= 0, gaps, load and the error of p, all within what the problem's tolerance promises.
void expect_answer(const PatchProblem& problem, const PatchSolution& solution,
                   const std::vector<double>& exact, const std::string& name);

/// Solves for this load, then for the approach that belongs to it, at 1e-2, 1e-4, 1e-6 and 1e-8,
/// and expects every answer to be right. Returns the exact answer for the load.
PatchSolution expect_solved(NormalSolver& solver, const Grid& grid,
                            const std::vector<double>& distance, double load,
                            const std::string& name);

/// Uniform in 0 to 1, the same on every platform.
template <typename Generator> double uniform(Generator& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

} // namespace wrc::test
