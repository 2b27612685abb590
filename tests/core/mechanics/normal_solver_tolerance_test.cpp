/// `tolerance` is what it says: the largest error of p, relative to the largest p, on the same
/// grid.
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "support/solver_checks.hpp"

namespace wrc::test::normal_solver_tolerance_test {
namespace {

constexpr double greatest_tolerance = 0.1;
constexpr double min_tolerance = 1e-9;

/// Circle, 8:1 ellipse, two lobes, wedge, noise and punch in 6 mm x 6 mm.
std::vector<ContactCase> sweep_cases(std::size_t rows, std::size_t columns) {
  std::vector<ContactCase> cases;
  for (ContactCase& example : contact_cases(rows, columns, 1.0)) {
    if (example.name != "hertz" && example.name != "ending body") {
      cases.push_back(std::move(example));
    }
  }
  const Grid grid = cases.front().grid;
  cases.push_back({"circle", grid, hertz_gap(grid, 1.0 / 200.0, 1.0 / 200.0)});
  cases.push_back({"8:1 ellipse", grid, hertz_gap(grid, 1.0 / 1000.0, 1.0 / 40.0)});
  return cases;
}

/// Loads and approaches in turn, in both precisions in turn, so that each meets every decade.
void sweep(std::size_t rows, std::size_t columns, int per_decade) {
  NormalSolver mixed;
  NormalSolver precise(PlannerRigor::estimate, Precision::double_only);
  for (const ContactCase& example : sweep_cases(rows, columns)) {
    PatchProblem by_load = with_load(example.grid, example.distance, case_load, exact_tolerance);
    const PatchSolution loaded = solve_exactly(by_load);
    PatchProblem by_approach =
        with_approach(example.grid, example.distance, loaded.approach, exact_tolerance);
    const PatchSolution pressed = solve_exactly(by_approach);
    const int count =
        static_cast<int>(std::lround(std::log10(greatest_tolerance / min_tolerance))) * per_decade;
    for (int step = 0; step <= count; ++step) {
      const double tolerance = greatest_tolerance * std::pow(10.0, -1.0 * step / per_decade);
      NormalSolver& solver = step % 4 < 2 ? mixed : precise;
      PatchProblem& problem = step % 2 == 0 ? by_load : by_approach;
      problem.tolerance = tolerance;
      const PatchSolution solution = solver.solve(problem);
      EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met);
      EXPECT_LE(
          pressure_error(solution.pressure, step % 2 == 0 ? loaded.pressure : pressed.pressure) /
              tolerance,
          1.0)
          << example.name << ", " << rows << " x " << columns << ", tolerance " << tolerance
          << (step % 2 == 0 ? ", load" : ", approach");
    }
  }
}

TEST(NormalSolverTolerance, KeptOn24x24) {
  sweep(24, 24, 16);
}

TEST(NormalSolverTolerance, KeptOn64x32) {
  sweep(64, 32, 8);
}

TEST(NormalSolverTolerance, KeptOn130x70) {
  sweep(130, 70, 4);
}

TEST(NormalSolverTolerance, KeptOn256x128) {
  sweep(256, 128, 2);
}

} // namespace
} // namespace wrc::test::normal_solver_tolerance_test
