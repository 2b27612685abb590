/// How little a gap is a parabola along the rail, on gaps in closed form.
#include "remesh/bend_along.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "remesh/constants.hpp"

namespace wrc::test::bend_along_test {
namespace {

constexpr Grid grid{3, 33, 2.0, 0.5, -2.0, -8.0};

double bend_of(const std::function<double(double, double)>& gap) {
  std::vector<double> distance;
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
      distance.push_back(gap(grid.longitudinal(j), grid.lateral(i)));
    }
  }
  return bend_along(grid, distance, std::vector<double>(distance.size()));
}

double parabola(double x, double y) {
  return x * x / 920.0 + y * y / 600.0 - 0.05;
}

/// Rows that are staggered, by yaw, and of different height are parabolas all the same.
TEST(BendAlong, ParabolasHaveNone) {
  EXPECT_LT(bend_of(parabola), 1e-10);
  EXPECT_LT(bend_of([](double x, double y) { return parabola(x - 0.7 * y + 1.0, y); }), 1e-10);
}

/// Half of the wheel is flat: f less its parabola is known, a tenth of the depth in the middle.
TEST(BendAlong, TheEndOfAFlatIsBentInFull) {
  EXPECT_EQ(bend_of([](double x, double y) { return parabola(std::max(x, 0.0), y); }), 1.0);
}

/// It grows in proportion to the difference, and not with the size of the gap.
TEST(BendAlong, GrowsWithTheDifference) {
  const auto wavy = [](double height, double factor) {
    return bend_of(
        [=](double x, double y) { return factor * (parabola(x, y) + height * std::cos(2.0 * x)); });
  };
  const double small = wavy(2e-4, 1.0);
  EXPECT_GT(small, 0.05);
  EXPECT_LT(small, 0.3);
  EXPECT_NEAR(wavy(4e-4, 1.0), 2.0 * small, 0.05 * small);
  EXPECT_NEAR(wavy(2e-4, 3.0), small, 1e-9);
}

TEST(BendAlong, WithoutPenetrationThereIsNone) {
  EXPECT_EQ(bend_of([](double x, double y) { return parabola(x, y) + 1.0; }), 0.0);
}

} // namespace
} // namespace wrc::test::bend_along_test
