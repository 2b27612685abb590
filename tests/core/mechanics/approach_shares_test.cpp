/// Elements with shares of their own in the approach, as under a rail whose surface turns.
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mechanics/normal_solver.hpp"

namespace wrc::test::approach_shares_test {
namespace {

constexpr double modulus = 115384.6;

struct Turning {
  Grid grid{48, 36, 0.25, 0.4, -5.875, -7.0};
  std::vector<double> distance;
  std::vector<double> shares;

  Turning() {
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const double x = grid.longitudinal(column);
        const double y = grid.lateral(row);
        distance.push_back(x * x / 920.0 + y * y / 400.0 - 0.03);
        shares.push_back(0.4 - 0.04 * y);
      }
    }
  }
  [[nodiscard]] PatchGap gap() const { return {grid, distance, 0.4, {}, shares}; }
};

NormalProblem problem_of(const PatchGap& gap) {
  NormalProblem problem;
  problem.patches = {&gap, 1};
  problem.combined_modulus = modulus;
  problem.load = 30000.0;
  problem.tolerance = 1e-8;
  return problem;
}

TEST(ApproachShares, FewElementsBearALoadHoweverTheirHeightsAreRounded) {
  // The first pressures lie on the lowest element alone, whose distance over its share times the
  // share may round to less than the distance.
  const Grid grid{2, 1, 0.7, 2.1, 0.0, 0.0};
  constexpr int count = 1000;
  for (int i = 0; i < count; ++i) {
    const double share = 0.2 + 0.8 * i / count;
    const std::vector<double> distance{0.048, 0.066};
    const std::vector<double> shares{share, 0.99 * share};
    const PatchGap gap{grid, distance, share, {}, shares};
    NormalProblem problem = problem_of(gap);
    problem.load = 0.1;
    const NormalSolution found = NormalSolver().solve(problem);
    ASSERT_NEAR(found.patches[0].normal_force * share, 0.1, 1e-10) << "share " << share;
    ASSERT_GT(found.approach, distance[0] / share);
  }
}

TEST(ApproachShares, BothSolversMeetTheConditionsOfEachElement) {
  const Turning turning;
  const PatchGap gap = turning.gap();
  NormalProblem problem = problem_of(gap);
  const NormalSolution found = NormalSolver().solve(problem);
  const Residuals residuals = compute_residuals(problem, found.patches[0].pressure, found.approach);
  EXPECT_LE(residuals.complementarity, 1e-7);
  EXPECT_GE(residuals.least_gap, -1e-7);
  EXPECT_LE(residuals.load_balance, 1e-10);
  problem.tolerance = 1e-10;
  const NormalSolution paper = solve_with_polonsky_keer(problem);
  EXPECT_NEAR(paper.approach, found.approach, 1e-7 * std::abs(found.approach));
  EXPECT_NEAR(paper.patches[0].normal_force, found.patches[0].normal_force,
              1e-7 * found.patches[0].normal_force);
  // One share for all is another problem.
  PatchGap even = gap;
  even.shares = {};
  const NormalSolution level = NormalSolver().solve(problem_of(even));
  EXPECT_GT(std::abs(level.patches[0].normal_force / found.patches[0].normal_force - 1.0), 1e-3);
}

/// A wheel shifted and turned is in the same place as one whose distances say so.
TEST(ApproachShares, TheSolutionIsThatOfAPrescribedApproach) {
  const Turning turning;
  const PatchGap gap = turning.gap();
  const NormalSolution loaded = NormalSolver().solve(problem_of(gap));
  NormalProblem placed = problem_of(gap);
  placed.load.reset();
  placed.approach = loaded.approach;
  const NormalSolution found = NormalSolver().solve(placed);
  for (std::size_t i = 0; i < gap.shares.size(); ++i) {
    EXPECT_NEAR(found.patches[0].pressure[i], loaded.patches[0].pressure[i], 1e-3) << i;
  }
}

TEST(ApproachShares, AreRefusedOutsideTheirRange) {
  Turning turning;
  turning.shares[7] = 0.0;
  const PatchGap gap = turning.gap();
  EXPECT_THROW(NormalSolver().solve(problem_of(gap)), Error);
  turning.shares.pop_back();
  const PatchGap shorter = turning.gap();
  EXPECT_THROW(NormalSolver().solve(problem_of(shorter)), Error);
}

} // namespace
} // namespace wrc::test::approach_shares_test
