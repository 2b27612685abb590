#include "table/error_map.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc {
namespace {

ErrorMap map_of_a_peak() {
  std::vector<double> cells(5 * 4 * 3, 0.01);
  cells[(2 * 4 + 1) * 3 + 1] = 0.2;
  return {{{{-5.0, 5.0}, {0.0, 1.0}, {-0.3, 0.3}}}, {5, 4, 3}, cells};
}

TEST(ErrorMap, IsNowhereBelowTheErrorOfItsCell) {
  const ErrorMap map = map_of_a_peak();
  for (double x = -5.0; x <= 5.0; x += 0.31) {
    for (double y = 0.0; y <= 1.0; y += 0.07) {
      for (double z = -0.3; z <= 0.3; z += 0.05) {
        EXPECT_GE(map.error_at({x, y, z}), map.cells()[map.cell_of({x, y, z})] * (1.0 - 1e-12));
      }
    }
  }
  EXPECT_NEAR(map.error_at({0.0, 0.3, 0.0}), 0.2, 1e-15);
  EXPECT_NEAR(map.error_at({4.5, 0.9, 0.25}), 0.01, 1e-15);
}

TEST(ErrorMap, CellsBeyondTheToleranceHaveTheWholeWeightAndOthersFarAwayNone) {
  ErrorMap map = map_of_a_peak();
  EXPECT_EQ(map.weight_at({0.0, 0.3, 0.0}).value, 0.0);
  map.set_tolerance(0.1);
  EXPECT_NEAR(map.weight_at({0.0, 0.3, 0.0}).value, 1.0, 1e-15);
  EXPECT_NEAR(map.weight_at({0.9, 0.49, 0.09}).value, 1.0, 1e-15);
  EXPECT_EQ(map.weight_at({4.0, 0.3, 0.0}).value, 0.0);
  EXPECT_NEAR(map.share_beyond(0.1), 1.0 / 60.0, 1e-15);
}

TEST(ErrorMap, WeightsHaveAContinuousSlope) {
  ErrorMap map = map_of_a_peak();
  map.set_tolerance(0.1);
  constexpr double step = 1e-6;
  for (double x = -4.9; x < 4.9; x += 0.05) {
    const ErrorMap::Place place{x, 0.6, 0.05};
    const ErrorMap::Weight ahead = map.weight_at({x + step, 0.6, 0.05});
    const ErrorMap::Weight behind = map.weight_at({x - step, 0.6, 0.05});
    const ErrorMap::Weight at = map.weight_at(place);
    EXPECT_NEAR((ahead.value - behind.value) / (2.0 * step), at.slope[0], 1e-5);
    EXPECT_NEAR(ahead.slope[0], behind.slope[0], 1e-5);
  }
}

TEST(ErrorMap, CellsFillTheirBox) {
  const ErrorMap map = map_of_a_peak();
  for (std::size_t cell = 0; cell < map.cells().size(); ++cell) {
    const ErrorMap::Ranges ranges = map.ranges_of(cell);
    const ErrorMap::Place middle{0.5 * (ranges[0].first + ranges[0].last),
                                 0.5 * (ranges[1].first + ranges[1].last),
                                 0.5 * (ranges[2].first + ranges[2].last)};
    EXPECT_EQ(map.cell_of(middle), cell);
  }
  EXPECT_EQ(map.cell_of({std::nan(""), 2.0, -7.0}), 9U);
}

} // namespace
} // namespace wrc
