#include "patches/plane_area.hpp"

#include <gtest/gtest.h>

namespace wrc::test::plane_area_test {
namespace {

TEST(PlaneArea, GridFillsTheAreaWithEqualElements) {
  const Grid grid = grid_over({-3.0, 5.0, 1.0, 2.0}, 4, 10);
  EXPECT_DOUBLE_EQ(grid.lateral_step, 2.0);
  EXPECT_DOUBLE_EQ(grid.longitudinal_step, 0.1);
  EXPECT_DOUBLE_EQ(grid.lateral(0), -2.0);
  EXPECT_DOUBLE_EQ(grid.lateral(3), 4.0);
  EXPECT_DOUBLE_EQ(grid.longitudinal(9), 1.95);
}

/// Two and a half elements along, of which four are around the middle.
TEST(PlaneArea, RealNumbersOfElementsKeepItsMiddle) {
  const Grid grid = grid_over_real({-3.0, 5.0, 1.0, 2.0}, 4, 2.5);
  EXPECT_DOUBLE_EQ(grid.lateral(0), -2.0);
  EXPECT_DOUBLE_EQ(grid.longitudinal_step, 0.4);
  EXPECT_DOUBLE_EQ(grid.longitudinal(1), 1.3);
  EXPECT_DOUBLE_EQ(grid.longitudinal(2), 1.7);
  EXPECT_EQ(even_count(2.5), 4u);
  EXPECT_EQ(even_count(4.0), 4u);
}

TEST(PlaneArea, WidensBySharesOfItsSides) {
  const PlaneArea area = PlaneArea{-1.0, 3.0, 2.0, 4.0}.widened(0.25);
  EXPECT_DOUBLE_EQ(area.lateral_first, -2.0);
  EXPECT_DOUBLE_EQ(area.lateral_last, 4.0);
  EXPECT_DOUBLE_EQ(area.longitudinal_first, 1.5);
  EXPECT_DOUBLE_EQ(area.longitudinal_last, 4.5);
}

} // namespace
} // namespace wrc::test::plane_area_test
