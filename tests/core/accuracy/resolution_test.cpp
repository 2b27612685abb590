// Elements for an accuracy, and the error of a solution on them: each rule at a place where it
// decides.
#include "accuracy/resolution.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace wrc::test::resolution_test {
namespace {

constexpr double rounding = 1e-12;

void expect_counts(const ElementCounts& counts, std::size_t lateral, std::size_t longitudinal) {
  EXPECT_EQ(counts.lateral, lateral);
  EXPECT_EQ(counts.longitudinal, longitudinal);
}

TEST(Resolution, RowsGrowWithThePowerMeasured) {
  expect_counts(counts_for({.accuracy = 1e-2}), 21, 10);
  expect_counts(counts_for({.accuracy = 1e-3}), 48, 22); // 21 x 10^0.355 = 47.6
}

/// sqrt(1.5 / (0.7 x 1e-4)) = 146.4, where 21 x 100^0.355 = 107.7.
TEST(Resolution, TheLawOfTheErrorKeepsToItsShareOfTheAccuracy) {
  expect_counts(counts_for({.accuracy = 1e-4}), 147, 66);
}

TEST(Resolution, TheFewestElementsStillHoldAPatch) {
  expect_counts(counts_for({.accuracy = 0.1}), 10, 8);
  expect_counts(coarse_counts(1e-2), 11, 8);
}

TEST(Resolution, CoarseGridsHaveHalfTheRows) {
  expect_counts(coarse_counts(1e-3), 24, 11);
}

/// As for an accuracy that is 1.5, or 3 times as fine.
TEST(Resolution, ForcesAtAPositionAndConstantElementsTakeMoreRows) {
  expect_counts(counts_for({.accuracy = 1e-2, .position_is_prescribed = true}), 25, 11);
  expect_counts(counts_for({.accuracy = 1e-2, .elements = Elements::constant}), 32, 14);
}

/// By laws of their own, and more along where a patch is long: (16)^0.35 = 2.639 times as many.
TEST(Resolution, CreepForcesTakeMoreElements) {
  const ElementCounts counts = counts_for({.accuracy = 1e-2, .creep_forces = true});
  expect_counts(counts, 38, 18); // sqrt(14 / 1e-2) = 37.4, sqrt(3.2 / 1e-2) = 17.9
  const Grid grid = grid_over({-1.0, 1.0, -16.0, 16.0}, counts);
  EXPECT_EQ(grid.lateral_count, 38u);
  EXPECT_EQ(grid.longitudinal_count, 48u); // 47.5
  EXPECT_NEAR(grid.longitudinal_step, 32.0 / (18.0 * std::pow(16.0, 0.35)), rounding);
  EXPECT_NEAR(grid.longitudinal(23) + grid.longitudinal(24), 0.0, rounding);
  EXPECT_EQ(grid_over({-16.0, 16.0, -0.1, 0.1}, counts).longitudinal_count, 8u);
  // As many as are given by hand.
  EXPECT_EQ(grid_over({-1.0, 1.0, -16.0, 16.0}, ElementCounts{5, 3}).longitudinal_count, 3u);
}

/// 40 x 20 elements, of which the longest row has seven under pressure.
GridSolution askew_contact() {
  GridSolution solution;
  Patch& patch = solution.patches.emplace_back();
  patch.grid.lateral_count = 40;
  patch.grid.longitudinal_count = 20;
  patch.pressure.assign(800, 0.0);
  std::fill_n(patch.pressure.begin() + 105, 5, 1.0);
  std::fill_n(patch.pressure.begin() + 208, 7, 1.0);
  patch.contact.element_count = 12;
  patch.contact.peak_pressure = 1000.0;
  return solution;
}

TEST(Resolution, ErrorsFollowRowsAndTheColumnsInUse) {
  const GridSolution solution = askew_contact();
  const ErrorEstimate error = estimate_error(solution, {});
  EXPECT_NEAR(error.rows, 1.5 / (40.0 * 40.0), rounding);
  const double rows_of_columns = 7.0 / 0.7 / 0.45;
  EXPECT_NEAR(error.columns, 1.5 / (rows_of_columns * rows_of_columns), rounding);
  EXPECT_NEAR(estimate_error(solution, {.position_is_prescribed = true}).rows, 1.5 * error.rows,
              rounding);
  EXPECT_NEAR(estimate_error(solution, {.elements = Elements::constant}).rows, 3.0 * error.rows,
              rounding);
}

/// Only what may exceed the largest pressure of all is an error of it.
TEST(Resolution, ACrestCountsByWhatItMayExceedTheLargestPressure) {
  GridSolution solution = askew_contact();
  solution.patches.push_back(solution.patches.front());
  solution.patches[1].contact.peak_pressure = 900.0;
  solution.patches[1].peak_error = 50.0;
  solution.pressure_error = 2e-4;
  EXPECT_EQ(estimate_error(solution, {}).crest, 0.0);
  solution.patches[1].peak_error = 150.0;
  const ErrorEstimate error = estimate_error(solution, {});
  EXPECT_NEAR(error.crest, 0.05, rounding);
  EXPECT_NEAR(error.total(), error.columns + 2e-4 + 0.05, rounding);
}

/// By powers of the root of 2, and four times at most.
TEST(Resolution, RefinesTheDirectionThatNeedsIt) {
  const ElementCounts counts{40, 20};
  expect_counts(refined_counts(counts, {.rows = 0.0013, .columns = 1e-4}, 1e-3), 57, 20);
  expect_counts(refined_counts(counts, {.rows = 1e-4, .columns = 0.0015}, 1e-3), 40, 40);
  expect_counts(refined_counts(counts, {.rows = 1.0, .columns = 1.0}, 1e-3), 160, 80);
  // What rows and iteration leave, 0.7e-3, a crest may have: about twice as much takes twice as
  // many.
  expect_counts(refined_counts(counts,
                               {.rows = 1e-4, .columns = 1e-4, .iteration = 2e-4, .crest = 1.3e-3},
                               1e-3),
                80, 20);
}

} // namespace
} // namespace wrc::test::resolution_test
