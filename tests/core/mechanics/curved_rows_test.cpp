/// Contacts whose rows lie along a curve against dense solutions, and as limits of a plane.
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mechanics/normal_solver.hpp"
#include "support/dense_reference.hpp"
#include "support/patch_problem.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::curved_rows_test {
namespace {

/// An arc across with its rows' angles; elliptic along it.
struct Curved {
  Grid grid;
  std::vector<double> distance;
  std::vector<double> angles;

  Curved(const Grid& elements, double turn) : grid(elements) {
    const double width = grid.lateral_step * static_cast<double>(grid.lateral_count);
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      angles.push_back(0.3 + turn * grid.lateral(row) / width);
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const double x = grid.longitudinal(column);
        const double y = grid.lateral(row);
        distance.push_back(x * x / 500.0 + y * y / 300.0 + 1e-5 * y);
      }
    }
  }
  [[nodiscard]] PatchProblem problem(double load, double tolerance) const {
    PatchProblem made = with_load(grid, distance, load, tolerance);
    made.patch.angles = angles;
    return made;
  }
};

constexpr double load = 12000.0;
const Grid small{22, 14, 0.4, 0.6, -4.2, -3.9};
/// With a cascade of three grids, and a rectangle that leaves out much of the grid.
const Grid large{100, 90, 0.16, 0.2, -7.9, -9.0};

TEST(CurvedRows, AreSolvedLikeTheDenseProblem) {
  for (const double turn : {0.2, 1.0, 2.0}) {
    const Curved curved(small, turn);
    const PatchProblem problem = curved.problem(load, 1e-8);
    const DenseSolution exact = solve_densely(problem);
    for (const PatchSolution& found : {PatchSolution(NormalSolver().solve(problem)),
                                       PatchSolution(solve_with_polonsky_keer(problem))}) {
      EXPECT_EQ(found.stop_reason, StopReason::tolerance_met) << turn;
      EXPECT_LT(pressure_error(found.pressure, exact.pressure), 1e-6) << turn;
      EXPECT_NEAR(found.approach, exact.approach, 1e-8 * exact.approach) << turn;
    }
  }
}

TEST(CurvedRows, MeetTheConditionsOnACascade) {
  for (const double turn : {0.2, 1.0}) {
    const Curved curved(large, turn);
    for (const double tolerance : {1e-3, 1e-6}) {
      PatchProblem problem = curved.problem(load, tolerance);
      const PatchSolution found(NormalSolver().solve(problem));
      EXPECT_EQ(found.stop_reason, StopReason::tolerance_met) << turn;
      const Residuals residuals = compute_residuals(problem, found.pressure, found.approach);
      EXPECT_LT(residuals.complementarity, gap_share * tolerance) << turn << ", " << tolerance;
      EXPECT_GT(residuals.least_gap, -tolerance - unseen_overlap) << turn << ", " << tolerance;
      EXPECT_LT(residuals.load_balance, load_rounding) << turn;
      const PatchSolution exact = solve_exactly(problem);
      EXPECT_LT(pressure_error(found.pressure, exact.pressure), 1.5 * tolerance) << turn;
      // The same at the approach that belongs to it.
      problem.load.reset();
      problem.approach = exact.approach;
      const PatchSolution pressed(NormalSolver().solve(problem));
      EXPECT_LT(pressure_error(pressed.pressure, exact.pressure), 2.0 * tolerance) << turn;
    }
  }
}

TEST(CurvedRows, OfOneAngleAreAPlaneBitForBit) {
  for (const Grid& grid : {small, large}) {
    Curved curved(grid, 0.0);
    const PatchSolution found(NormalSolver().solve(curved.problem(load, 1e-4)));
    const PatchSolution plane(NormalSolver().solve(with_load(grid, curved.distance, load, 1e-4)));
    EXPECT_EQ(found.pressure, plane.pressure);
    EXPECT_EQ(found.approach, plane.approach);
  }
}

/// Rows that are inclined to each other displace each other less.
TEST(CurvedRows, SinkLessTheMoreTheyTurn) {
  double before = 1e9;
  for (const double turn : {0.0, 0.5, 1.0, 1.5}) {
    const Curved curved(small, turn);
    const PatchSolution found(NormalSolver().solve(curved.problem(load, 1e-6)));
    EXPECT_LT(found.approach, before) << turn;
    before = found.approach;
  }
}

TEST(CurvedRows, RefuseOtherNumbersOfAnglesAndWhatIsNotFinite) {
  Curved curved(small, 0.5);
  curved.angles.pop_back();
  EXPECT_THROW(NormalSolver().solve(curved.problem(load, 1e-4)), Error);
  curved.angles.push_back(std::nan(""));
  EXPECT_THROW(NormalSolver().solve(curved.problem(load, 1e-4)), Error);
}

} // namespace
} // namespace wrc::test::curved_rows_test
