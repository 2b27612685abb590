// Load that pressures between the elements have elsewhere than the solution.
#include "pressure/moved_load.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::moved_load_test {
namespace {

/// 20 rows of 20 elements of 0.1 x 0.1 mm, middle 0.
const Grid grid{20, 20, 0.1, 0.1, -0.95, -0.95};

std::vector<double> hertzian(double half_length) {
  std::vector<double> pressure(grid.element_count());
  for (std::size_t at = 0; at < pressure.size(); ++at) {
    const double x = grid.longitudinal(at % grid.longitudinal_count) / half_length;
    const double y = grid.lateral(at / grid.longitudinal_count) / 0.8;
    pressure[at] = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
  }
  return pressure;
}

TEST(MovedLoad, IsLittleUnderAnEllipse) {
  const std::vector<double> pressure = hertzian(0.8);
  EXPECT_LT(moved_load(grid, pressure, SmoothPressure(grid, pressure), 0.0, 0.8), 0.01);
}

/// Columns of its own elements bear what elements of the same grid do.
TEST(MovedLoad, ComparesWithMeansOverElements) {
  const std::vector<double> pressure = hertzian(0.8);
  const SmoothPressure smooth(grid, pressure);
  std::vector<double> means;
  std::vector<double> covered;
  smooth.fill_means(grid, means, covered);
  const SmoothPressure::Columns columns = smooth.own_columns();
  ASSERT_NEAR(columns.first, -0.95, 0.3);
  const auto first = static_cast<std::ptrdiff_t>(std::lround((columns.first + 0.95) / 0.1));
  for (std::ptrdiff_t column = 2; column < 18; ++column) {
    double sum = 0.0;
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      sum += means[row * grid.longitudinal_count + static_cast<std::size_t>(column)];
    }
    EXPECT_NEAR(columns.sums[static_cast<std::size_t>(column - first)], sum, 0.01 * sum) << column;
  }
}

/// A tenth of the load of one column in the one beside it, in the solution: a tenth of its share
/// has moved, and counts by its distance over the mean axis beyond that.
TEST(MovedLoad, IsWhatColumnsHaveTooMuchOrTooLittle) {
  const std::vector<double> pressure = hertzian(0.8);
  const SmoothPressure smooth(grid, pressure);
  const double before = moved_load(grid, pressure, smooth, 0.0, 0.8);
  std::vector<double> moved = pressure;
  double load = 0.0;
  double part = 0.0;
  for (std::size_t at = 0; at < moved.size(); ++at) {
    load += pressure[at];
    if (at % grid.longitudinal_count == 14) { // at 0.45 and 0.55 mm
      part += 0.1 * pressure[at];
      moved[at + 1] += 0.1 * pressure[at];
      moved[at] *= 0.9;
    }
  }
  EXPECT_NEAR(moved_load(grid, moved, smooth, 0.0, 0.8), part / load, before);
  EXPECT_NEAR(moved_load(grid, moved, smooth, 0.0, 0.1), 5.0 * part / load, 8.0 * before);
}

} // namespace
} // namespace wrc::test::moved_load_test
