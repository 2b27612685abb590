#include "support/solver_checks.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test {

PatchSolution solve_exactly(PatchProblem problem) {
  static NormalSolver solver(PlannerRigor::estimate, Precision::double_only);
  problem.tolerance = exact_tolerance;
  PatchSolution solution = solver.solve(problem);
  EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met) << "exact answer";
  return solution;
}

double pressure_error(const std::vector<double>& pressure, const std::vector<double>& exact) {
  double worst = 0.0;
  for (std::size_t index = 0; index < pressure.size(); ++index) {
    worst = std::max(worst, std::abs(pressure[index] - exact[index]));
  }
  const double largest = *std::max_element(exact.begin(), exact.end());
  return worst == 0.0 ? 0.0 : worst / largest;
}

void expect_answer(const PatchProblem& problem, const PatchSolution& solution,
                   const std::vector<double>& exact, const std::string& name) {
  const std::string text = name + (problem.load ? ", load" : ", approach") + ", tolerance 10^" +
                           std::to_string(std::log10(problem.tolerance));
  EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met) << text;
  EXPECT_GE(*std::min_element(solution.pressure.begin(), solution.pressure.end()), 0.0) << text;
  const Residuals residuals = compute_residuals(problem, solution.pressure, solution.approach);
  EXPECT_LE(residuals.load_balance, load_rounding) << text;
  EXPECT_LE(residuals.complementarity, gap_share * problem.tolerance) << text;
  EXPECT_GE(residuals.least_gap, -std::max(gap_share * problem.tolerance, unseen_overlap)) << text;
  EXPECT_LE(pressure_error(solution.pressure, exact) / problem.tolerance, 1.0) << text;
}

PatchSolution expect_solved(NormalSolver& solver, const Grid& grid,
                            const std::vector<double>& distance, double load,
                            const std::string& name) {
  PatchProblem by_load = with_load(grid, distance, load, exact_tolerance);
  PatchSolution loaded = solve_exactly(by_load);
  PatchProblem by_approach = with_approach(grid, distance, loaded.approach, exact_tolerance);
  const PatchSolution pressed = solve_exactly(by_approach);
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    by_load.tolerance = tolerance;
    expect_answer(by_load, solver.solve(by_load), loaded.pressure, name);
    by_approach.tolerance = tolerance;
    expect_answer(by_approach, solver.solve(by_approach), pressed.pressure, name);
  }
  return loaded;
}

} // namespace wrc::test
