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

/// Of 0.7 mm over 8, between two at a quarter of it; of 0.3 mm over 1, between two in the middle.
/// The outermost centres are inside, the next ones are not.
TEST(PlaneArea, ElementsOfGivenSizesKeepTheirOffsetFromTheMiddle) {
  const PlaneArea area{-3.0, 5.0, 1.0, 2.0};
  const Grid grid = grid_with_sizes(area, 0.7, 0.3, 0.25);
  EXPECT_EQ(grid.lateral_step, 0.7);
  EXPECT_EQ(grid.longitudinal_step, 0.3);
  EXPECT_EQ(grid.lateral_count, 12u);
  EXPECT_EQ(grid.longitudinal_count, 4u);
  EXPECT_NEAR(0.5 * (grid.lateral(2) + grid.lateral(3)), -1.0, 1e-12);
  EXPECT_NEAR(0.5 * (grid.longitudinal(1) + grid.longitudinal(2)), 1.5, 1e-12);
  EXPECT_GT(grid.lateral(0), area.lateral_first);
  EXPECT_LT(grid.lateral(0) - grid.lateral_step, area.lateral_first);
  EXPECT_LT(grid.lateral(11), area.lateral_last);
  EXPECT_GT(grid.lateral(11) + grid.lateral_step, area.lateral_last);
}

TEST(PlaneArea, LargeElementsStillHaveOneOnEachSide) {
  const Grid grid = grid_with_sizes({-3.0, 5.0, 1.0, 2.0}, 100.0, 100.0, 0.25);
  EXPECT_EQ(grid.lateral_count, 2u);
  EXPECT_EQ(grid.longitudinal_count, 2u);
}

TEST(PlaneArea, NextEvenNumber) {
  EXPECT_EQ(even_count(2.5), 4u);
  EXPECT_EQ(even_count(4.0), 4u);
}

TEST(PlaneArea, WidensByFractionsOfItsSides) {
  const PlaneArea area = PlaneArea{-1.0, 3.0, 2.0, 4.0}.widened(0.25);
  EXPECT_DOUBLE_EQ(area.lateral_first, -2.0);
  EXPECT_DOUBLE_EQ(area.lateral_last, 4.0);
  EXPECT_DOUBLE_EQ(area.longitudinal_first, 1.5);
  EXPECT_DOUBLE_EQ(area.longitudinal_last, 4.5);
}

} // namespace
} // namespace wrc::test::plane_area_test
