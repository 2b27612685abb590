#include "table/error_map.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace wrc {
namespace {

/// In the middle of the box.
ErrorMap map_of_a_peak() {
  ErrorMap map({{{-5.0, 5.0}, {0.0, 1.0}}}, {4, 4});
  for (ErrorMap::Errors& vertex : map.vertices()) {
    vertex.fill(0.01);
  }
  map.vertices()[map.vertices_of(map.cell_of({-0.1, 0.4}))[3]] = {0.5, 0.2, 0.3};
  return map;
}

TEST(ErrorMap, HasTheErrorsOfItsVerticesAndNoneBeyondThemBetween) {
  const ErrorMap map = map_of_a_peak();
  const ErrorMap::Errors peak = map.at({0.0, 0.5});
  EXPECT_NEAR(peak[bound_of_force], 0.5, 1e-15);
  EXPECT_NEAR(peak[likely_of_force], 0.2, 1e-15);
  EXPECT_NEAR(peak[likely_of_derivatives], 0.3, 1e-15);
  EXPECT_NEAR(map.at({1.25, 0.5})[likely_of_force], 0.105, 1e-15); // half way down
  EXPECT_NEAR(map.at({4.5, 0.9})[bound_of_force], 0.01, 1e-15);
}

TEST(ErrorMap, VerticesBeyondTheToleranceHaveTheWholeWeightAndOthersNone) {
  const ErrorMap map = map_of_a_peak();
  EXPECT_NEAR(map.weight_at({0.0, 0.5}, 0.1).value, 1.0, 1e-15);
  EXPECT_NEAR(map.weight_at({1.25, 0.5}, 0.1).value, 0.5, 1e-15);
  EXPECT_EQ(map.weight_at({4.0, 0.5}, 0.1).value, 0.0);
  EXPECT_EQ(map.weight_at({0.0, 0.5}, 0.3).value, 0.0); // the bound does not count
  EXPECT_NEAR(map.share_beyond(0.1), 1.0 / 25.0, 1e-15);
}

TEST(ErrorMap, WeightsHaveAContinuousSlope) {
  const ErrorMap map = map_of_a_peak();
  constexpr double step = 1e-6;
  for (double x = -4.9; x < 4.9; x += 0.05) {
    const ErrorMap::Place place{x, 0.6};
    const ErrorMap::Weight ahead = map.weight_at({x + step, 0.6}, 0.1);
    const ErrorMap::Weight behind = map.weight_at({x - step, 0.6}, 0.1);
    const ErrorMap::Weight at = map.weight_at(place, 0.1);
    EXPECT_NEAR((ahead.value - behind.value) / (2.0 * step), at.slope[0], 1e-5);
    EXPECT_NEAR(ahead.slope[0], behind.slope[0], 1e-5);
  }
}

TEST(ErrorMap, CellsFillTheirBox) {
  const ErrorMap map = map_of_a_peak();
  for (std::size_t cell = 0; cell < map.cell_count(); ++cell) {
    const ErrorMap::Ranges ranges = map.ranges_of(cell);
    const ErrorMap::Place middle{0.5 * (ranges[0].first + ranges[0].last),
                                 0.5 * (ranges[1].first + ranges[1].last)};
    EXPECT_EQ(map.cell_of(middle), cell);
    const auto vertices = map.vertices_of(cell);
    EXPECT_LT(*std::max_element(vertices.begin(), vertices.end()), map.vertices().size());
  }
  EXPECT_EQ(map.cell_of({std::nan(""), 2.0}), 3U);
}

} // namespace
} // namespace wrc
