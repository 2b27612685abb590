// Elements for an accuracy, and the error of a solution on them: each rule at a place where it
// decides.
#include "accuracy/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "accuracy/constants.hpp"
#include "pressure/contact_scale.hpp"
#include "pressure/edge_rows.hpp"
#include "remesh/constants.hpp"

namespace wrc::test::resolution_test {
namespace {

constexpr double rounding = 1e-12;

/// A patch of 40 x 20 elements of 0.2 x 0.5 mm under even pressure from row 10 to 29 and from
/// column 5 to 14: second differences over two of its rows have a total variation of 2 p/0.2 mm, so
/// that its scale is sqrt(24 x 20/2) rows wide and sqrt(20 x 100/12) columns long.
GridSolution block_contact() {
  GridSolution solution;
  Patch& patch = solution.patches.emplace_back();
  patch.penetration.mean_y = 750.0;
  patch.grid = {40, 20, 0.2, 0.5, 0.0, 0.0};
  patch.pressure.assign(800, 0.0);
  for (std::size_t row = 10; row < 30; ++row) {
    std::fill_n(patch.pressure.begin() + static_cast<std::ptrdiff_t>(20 * row + 5), 10, 1000.0);
  }
  patch.contact = summarise_pressure(patch.grid, patch.pressure);
  return solution;
}
const double rows_across = std::sqrt(240.0);
const double columns_along = std::sqrt(20.0 * 100.0 / 12.0);

double law(double rows) {
  return 0.2231 / (rows * rows) + 12.125 / (rows * rows * rows * rows);
}

/// In a potential contact area of 8 x 10 mm.
const ExpectedContact expected{5.0, 750.0, 8.0, 10.0, {3.0, 6.0}, 0.4};

PatchElements elements_for(const AccuracyGoal& goal) {
  return final_elements({&expected, 1}, goal).front();
}

/// Rows over the contact for an accuracy.
double rows_of(const AccuracyGoal& goal) {
  return 3.0 / elements_for(goal).lateral_step;
}

/// Columns over the contact.
double columns_of(const AccuracyGoal& goal) {
  return 6.0 / elements_for(goal).longitudinal_step;
}

TEST(Resolution, RowsKeepTheirErrorWithinItsAllowance) {
  for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
    EXPECT_NEAR(law(rows_of({.accuracy = accuracy})), 0.5335 * accuracy, rounding);
  }
  EXPECT_NEAR(rows_of({.accuracy = 0.1}), rows_of({.accuracy = 1e-2}), 1e-9);
}

/// 0.64 for each row: 5.5, 13.8 and 41.7 of them.
TEST(Resolution, ColumnsAreAnEvenNumber) {
  EXPECT_NEAR(columns_of({.accuracy = 1e-2}), 6.0, 1e-9);
  EXPECT_NEAR(columns_of({.accuracy = 1e-3}), 14.0, 1e-9);
  EXPECT_NEAR(columns_of({.accuracy = 1e-4}), 42.0, 1e-9);
}

/// As for an accuracy that is 1.25, or 3 times as fine.
TEST(Resolution, ForcesAtAPositionConstantElementsAndStressesTakeMoreRows) {
  EXPECT_NEAR(1.25 * law(rows_of({.position_is_prescribed = true})), 0.5335e-3, rounding);
  EXPECT_NEAR(3.0 * law(rows_of({.elements = Elements::constant})), 0.5335e-3, rounding);
  EXPECT_NEAR(3.0 * law(rows_of({.stresses = true})), 0.5335e-3, rounding);
}

/// By laws of their own: sqrt(3/1e-2) over the contact and sqrt(0.7/1e-2) along it, the latter
/// times the ratio of sides of 2 to the power of 0.35. In the whole grid 8/3 and 10/6 times as
/// many.
TEST(Resolution, CreepForcesTakeMoreElements) {
  const PatchElements elements = elements_for({.accuracy = 1e-2, .creep_forces = true});
  EXPECT_NEAR(elements.lateral_step, 8.0 / 48.0, rounding);       // 46.2
  EXPECT_NEAR(elements.longitudinal_step, 10.0 / 20.0, rounding); // 19.7
  EXPECT_EQ(elements.middle, 0.5);
}

/// Rows are as many as otherwise.
TEST(Resolution, BentGapsTakeMoreColumns) {
  ExpectedContact bent = expected;
  for (const double bend : {0.0, 0.5, 1.0}) {
    bent.bend = bend;
    const PatchElements elements = final_elements({&bent, 1}, {}).front();
    EXPECT_EQ(elements.lateral_step, elements_for({}).lateral_step);
    EXPECT_NEAR(elements.longitudinal_step * (1.0 + (bent_columns - 1.0) * bend),
                elements_for({}).longitudinal_step, rounding);
  }
}

/// Elsewhere a contact that is shorter than wide takes fewer columns for creep forces.
TEST(Resolution, ShortContactsOfBentGapsKeepTheirColumns) {
  constexpr AccuracyGoal goal{.accuracy = 1e-2, .creep_forces = true};
  const double least = std::sqrt(creep_column_law / goal.accuracy);
  ExpectedContact shorter = expected;
  shorter.length = 2.5;
  shorter.scale = {3.0, 1.5};
  EXPECT_LT(1.5 / final_elements({&shorter, 1}, goal).front().longitudinal_step, least);
  shorter.bend = 1.0;
  EXPECT_GE(1.5 / final_elements({&shorter, 1}, goal).front().longitudinal_step,
            bent_columns * least);
}

TEST(Resolution, ElementsStayAnchoredAtTheMiddle) {
  EXPECT_EQ(elements_for({}).mean_x, 5.0);
  EXPECT_EQ(elements_for({}).mean_y, 750.0);
  EXPECT_EQ(elements_for({}).middle, 0.4);
}

/// By rows here; with three times as many of these by columns.
TEST(Resolution, ErrorsFollowTheFewerElements) {
  GridSolution solution = block_contact();
  const ErrorEstimate error = estimate_error(solution, {});
  EXPECT_NEAR(error.elements, law(rows_across), rounding);
  EXPECT_NEAR(estimate_error(solution, {.position_is_prescribed = true}).elements,
              1.25 * error.elements, rounding);
  EXPECT_NEAR(estimate_error(solution, {.elements = Elements::constant}).elements,
              3.0 * error.elements, rounding);
  Patch& patch = solution.patches[0];
  patch.grid.lateral_step = 0.6;
  EXPECT_NEAR(estimate_error(solution, {}).elements, law(rows_across), rounding);
  patch.grid = {120, 20, 0.2, 0.5, 0.0, 0.0};
  patch.pressure.assign(2400, 0.0);
  for (std::size_t row = 10; row < 100; ++row) {
    std::fill_n(patch.pressure.begin() + static_cast<std::ptrdiff_t>(20 * row + 5), 10, 1000.0);
  }
  EXPECT_NEAR(estimate_error(solution, {}).elements, law(columns_along / 0.64), rounding);
  // A place is off by more than elements of creep forces are.
  constexpr AccuracyGoal coarse{.accuracy = 1e-2};
  EXPECT_EQ(estimate_error(solution, coarse).elements, least_error * coarse.of_contact());
}

/// A patch about to lift has few rows left; the largest pressure may still be its own.
TEST(Resolution, ErrorsOfForcesCountByTheShareOfTheLoad) {
  GridSolution solution = block_contact();
  solution.patches[0].normal_force = 999.0;
  Patch& dying = solution.patches.emplace_back(solution.patches[0]);
  dying.normal_force = 1.0;
  dying.grid.lateral_step *= 10.0; // a tenth of the rows over the same width
  dying.pressure.assign(800, 0.0);
  for (std::size_t row = 10; row < 12; ++row) {
    std::fill_n(dying.pressure.begin() + static_cast<std::ptrdiff_t>(20 * row + 5), 10, 1000.0);
  }
  const double few = estimate_error(solution, {}).elements; // the greatest
  EXPECT_GT(few, 50.0 * law(rows_across));
  EXPECT_NEAR(estimate_error(solution, {.forces_only = true}).elements,
              0.999 * law(rows_across) + 0.001 * few, rounding);
  solution.patches.pop_back();
  EXPECT_EQ(estimate_error(solution, {.forces_only = true}).elements,
            estimate_error(solution, {}).elements);
}

/// In proportion to the angle and the width of a row, over the overlap of 0.05 mm.
/// Of a contact whose last row bears half of the others': moments are less certain, which no second
/// grid is for.
TEST(Resolution, EdgesThatDifferAddAnErrorOfPlace) {
  GridSolution solution = block_contact();
  EXPECT_NEAR(estimate_error(solution, {}).edges, 0.0, rounding);
  Patch& patch = solution.patches.front();
  for (std::size_t column = 5; column < 15; ++column) {
    patch.pressure[20 * 29 + column] = 500.0;
  }
  const AccuracyGoal of_forces{.forces_only = true};
  const ErrorEstimate error = estimate_error(solution, of_forces);
  const ContactScale scale = contact_scale(patch.grid, patch.pressure);
  const double rows = std::min(scale.across / 0.2, scale.along / (0.64 * 0.5));
  EXPECT_NEAR(error.edges,
              error_by_edges * (law(rows) * rows * rows / 0.2231) *
                  edge_error(contact_rows(patch.grid, patch.pressure)),
              rounding);
  EXPECT_GT(error.edges, 1e-4);
  EXPECT_NEAR(error.total(), std::hypot(error.reducible(), error.edges), rounding);
  EXPECT_NEAR(error.reducible(), error.elements + error.crest, rounding);
  EXPECT_EQ(error.of_forces(), error.elements);
  // With a second one that has equal edges, by its share of the load.
  patch.normal_force = 1.0;
  solution.patches.push_back(block_contact().patches.front());
  solution.patches.back().normal_force = 3.0;
  EXPECT_NEAR(estimate_error(solution, of_forces).edges, 0.25 * error.edges, rounding);
  EXPECT_EQ(estimate_error(solution, {}).edges, error.edges);
}

TEST(Resolution, AKinkAddsAFirstOrderErrorToForces) {
  GridSolution solution = block_contact();
  solution.patches[0].undeformed_distance.assign(800, -0.05);
  const double smooth = estimate_error(solution, {}).total();
  EXPECT_EQ(estimate_error(solution, {}).ridge, 0.0);
  solution.patches[0].ridge = 0.5;
  EXPECT_NEAR(estimate_error(solution, {}).ridge, error_by_ridge * 0.5 * 0.2 / 0.05, rounding);
  EXPECT_NEAR(estimate_error(solution, {}).total(), smooth + error_by_ridge * 2.0, rounding);
}

/// By what a row e times as narrow would add to the largest pressure; no element lessens that.
TEST(Resolution, AKinkMakesPressuresUnbounded) {
  GridSolution solution = block_contact();
  const double smooth = estimate_error(solution, {}).total();
  solution.patches[0].growth = 30.0;
  const ErrorEstimate error = estimate_error(solution, {});
  EXPECT_NEAR(error.ridge, 0.03, rounding);
  EXPECT_NEAR(error.total(), smooth + 0.03, rounding);
  EXPECT_EQ(error.reducible(), smooth);
}

/// Only what may exceed the largest pressure of all is an error of it.
TEST(Resolution, ACrestCountsByItsPossibleExcessOverTheLargestPressure) {
  GridSolution solution = block_contact();
  solution.patches.push_back(solution.patches.front());
  solution.patches[1].contact.peak_pressure = 900.0;
  solution.patches[1].peak_error = 50.0;
  solution.pressure_error = 2e-4;
  EXPECT_EQ(estimate_error(solution, {}).crest, 0.0);
  solution.patches[1].peak_error = 150.0;
  const ErrorEstimate error = estimate_error(solution, {});
  EXPECT_NEAR(error.crest, 0.05, rounding);
  EXPECT_NEAR(error.total(), std::hypot(error.along + 0.05, 2e-4), rounding);
}

/// A row of a semi-ellipse, with one element raised by a tenth: its second difference is larger by
/// a fifth.
TEST(Resolution, ACrestAlongTheRailCountsByItsSecondDifference) {
  GridSolution solution = block_contact();
  Patch& patch = solution.patches.front();
  patch.pressure.assign(800, 0.0);
  const double half = 7.0; // columns
  for (std::size_t j = 3; j < 17; ++j) {
    const double x = (static_cast<double>(j) - 9.5) / half;
    patch.pressure[20 * 20 + j] = 1000.0 * std::sqrt(1.0 - x * x);
  }
  EXPECT_LT(estimate_error(solution, {}).along, 1e-3);
  patch.pressure[20 * 20 + 9] *= 1.1;
  EXPECT_NEAR(estimate_error(solution, {}).along, error_by_second_difference * 0.2, 1e-3);
  EXPECT_EQ(estimate_error(solution, {.forces_only = true}).along, 0.0);
  patch.undeformed_distance.assign(800, -0.05);
  EXPECT_GT(estimate_error(solution, {}).along, 0.01);
  patch.undeformed_distance[20 * 20 + 10] = no_material_distance; // an end of a part
  EXPECT_EQ(estimate_error(solution, {}).along, 0.0);
  const auto columns = [&](double along) {
    return 0.5 /
           finer_elements(solution, {.along = along}, {.accuracy = 1e-2}).front().longitudinal_step;
  };
  EXPECT_EQ(columns(9e-3), columns(0.0));
  EXPECT_NEAR(columns(2e-2), 2.0, rounding);
  EXPECT_NEAR(columns(1.0), 8.0, rounding); // 160 at most
}

/// By powers of the root of 2, one more than 1/n asks for. Elements and iteration leave a crest
/// 4.3e-3; 160 rows at most.
TEST(Resolution, RefinesRowsForACrest) {
  const auto step = [](double crest) {
    return finer_elements(block_contact(), {.iteration = 2e-4, .crest = crest}, {.accuracy = 1e-2})
        .front()
        .lateral_step;
  };
  EXPECT_EQ(step(1e-3), 0.2);
  EXPECT_NEAR(step(8e-3), 0.2 / std::pow(2.0, 1.5), rounding); // 1.9 times
  EXPECT_NEAR(step(1.0), 0.05, rounding);
}

/// 15.5 rows where an accuracy of 1e-3 takes 21.4 of them, as many as 13.7 columns: there are 12.9.
TEST(Resolution, RefinesTheDirectionThatNeedsIt) {
  const GridSolution solution = block_contact();
  const PatchElements both = finer_elements(solution, {.elements = 2e-3}, {}).front();
  EXPECT_NEAR(both.lateral_step, 0.2 / std::numbers::sqrt2, rounding);
  EXPECT_NEAR(both.longitudinal_step, 0.5 / std::numbers::sqrt2, rounding);
  EXPECT_EQ(
      finer_elements(solution, {.elements = 2e-3}, {.accuracy = 1e-2}).front().longitudinal_step,
      0.5);
}

} // namespace
} // namespace wrc::test::resolution_test
