// The rectangle of the projected CG: reached sides, and displacements after pressures are cut at 0.
#include "mechanics/iteration_box.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::iteration_box_test {
namespace {

constexpr std::size_t rows = 12;
constexpr std::size_t columns = 20;

TEST(IterationBox, ReportsContactAtOpenSidesOnly) {
  IterationBox box;
  box.rows = 4;
  box.columns = 5;
  std::vector<double> contact(box.count(), 0.0);
  contact[0 * 5 + 2] = 1.0; // first row
  contact[1 * 5 + 4] = 1.0; // last column
  EXPECT_FALSE(reached_sides(box, contact.data()).any());
  box.open_first_row = box.open_last_row = box.open_first_column = box.open_last_column = true;
  const ReachedSides reached = reached_sides(box, contact.data());
  EXPECT_TRUE(reached.first_row);
  EXPECT_FALSE(reached.last_row);
  EXPECT_FALSE(reached.first_column);
  EXPECT_TRUE(reached.last_column);
  contact.assign(box.count(), 0.0);
  contact[3 * 5 + 0] = 1.0; // a corner belongs to two sides
  const ReachedSides corner = reached_sides(box, contact.data());
  EXPECT_FALSE(corner.first_row);
  EXPECT_TRUE(corner.last_row);
  EXPECT_TRUE(corner.first_column);
  EXPECT_FALSE(corner.last_column);
}

/// sum over all elements of K p, straight from the table.
std::vector<double> displaced_by(const std::vector<double>& pressure, const InfluenceKernel& kernel,
                                 InfluenceCache& cache) {
  const auto table = cache.table(kernel, rows, columns);
  std::vector<double> displacement(pressure.size(), 0.0);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    for (std::size_t j = 0; j < pressure.size(); ++j) {
      const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
      displacement[i] +=
          table->row(apart(i / columns, j / columns))[apart(i % columns, j % columns)] *
          pressure[j];
    }
  }
  return displacement;
}

/// Negative pressures at every `spacing`-th element, few of them or many.
template <typename Real> void expect_consistent(std::size_t spacing, double tolerance) {
  InfluenceCache cache;
  ConvolutionWorkspace<Real> workspace;
  const InfluenceKernel kernel{0.7, Elements::smooth};
  std::vector<double> pressure(rows * columns);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    pressure[i] = 1.0 + std::sin(static_cast<double>(i));
    pressure[i] = i % spacing == 3 ? -0.5 - pressure[i] : pressure[i];
  }
  const std::vector<double> before = pressure;
  IterationBox box;
  box.rows = rows;
  box.columns = columns;
  box.kernel = kernel;
  box.pressure = pressure;
  BoxFields<Real> fields;
  fields.convolution =
      BoxConvolution<Real>::linear({rows, columns, rows, columns, 0, 0}, kernel, cache);
  provide(fields.displacement, box.count());
  provide(fields.response, box.count());
  const std::vector<double> start = displaced_by(before, kernel, cache);
  std::copy(start.begin(), start.end(), fields.displacement.data());
  fields.cut = static_cast<double>(
      std::count_if(before.begin(), before.end(), [](double p) { return p < 0.0; }));
  ASSERT_GT(fields.cut, 0.0);
  clip_negative(box, fields, cache, workspace);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(pressure[i], std::max(before[i], 0.0)) << i;
  }
  const std::vector<double> expected = displaced_by(pressure, kernel, cache);
  const double largest = *std::max_element(expected.begin(), expected.end());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(fields.displacement.data()[i], expected[i], tolerance * largest) << i;
  }
}

TEST(IterationBox, DisplacementsFollowAFewCutPressures) {
  expect_consistent<float>(60, 1e-6);
  expect_consistent<double>(60, 1e-13);
}

TEST(IterationBox, DisplacementsFollowManyCutPressures) {
  expect_consistent<float>(5, 1e-5);
  expect_consistent<double>(5, 1e-13);
}

} // namespace
} // namespace wrc::test::iteration_box_test
