/// Pressures between elements, and scales without values far beyond the others.
#include <cmath>

#include <gtest/gtest.h>

#include "support/gnuplot.hpp"
#include "support/refined_map.hpp"

namespace picture_maps_test {
namespace {

constexpr std::size_t rows = 16;
constexpr std::size_t columns = 12;

/// 1 - (x/a)^2 - (y/b)^2 of an ellipse that fits no element.
double height(double row, double column) {
  return 1.0 - std::pow((row - 7.3) / 5.8, 2) - std::pow((column - 5.4) / 3.9, 2);
}

// Hertz's pressures are drawn within 3 % of the largest where p^2 is above 0.15 (blocks: 20 %), and
// nothing is drawn further than a quarter of an element outside.
TEST(PictureMaps, AnEllipseIsDrawnBetweenItsElements) {
  std::vector<double> pressure;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      pressure.push_back(
          std::sqrt(std::max(height(static_cast<double>(i), static_cast<double>(j)), 0.0)));
    }
  }
  const driver::RefinedMap map(rows, columns);
  const std::vector<double> fine = map.pressure(pressure);
  ASSERT_EQ(fine.size(), map.rows() * map.columns());
  const double step = 15.0 / static_cast<double>(map.rows() - 1);
  EXPECT_LE(step, 0.2);
  for (std::size_t i = 0; i < map.rows(); ++i) {
    for (std::size_t j = 0; j < map.columns(); ++j) {
      const double exact = height(step * static_cast<double>(i), step * static_cast<double>(j));
      const double drawn = fine[i * map.columns() + j];
      if (exact > 0.15) {
        EXPECT_NEAR(drawn, std::sqrt(exact), 0.03) << i << ' ' << j;
      } else if (exact < -0.12) { // a quarter of an element: 2 * 0.25 / 3.9
        EXPECT_EQ(drawn, 0.0) << i << ' ' << j;
      }
    }
  }
}

TEST(PictureMaps, PlacesAreLinearBetweenElements) {
  const driver::RefinedMap map(2, 3);
  const std::vector<double> fine = map.linear({0.0, 1.0, 2.0, 10.0, 11.0, 12.0});
  EXPECT_DOUBLE_EQ(fine[4], 0.5);
  EXPECT_DOUBLE_EQ(fine.back(), 12.0);
  EXPECT_DOUBLE_EQ(fine[4 * map.columns() + 8], 6.0);
}

// Else a patch of 106 rows and 22 columns has stripes.
TEST(PictureMaps, EachDirectionIsRefinedByItsOwnElements) {
  const driver::RefinedMap map(106, 22);
  EXPECT_EQ(map.rows(), 2U * 105 + 1);
  EXPECT_EQ(map.columns(), 8U * 21 + 1);
}

// Two flange contacts among twenty on the tread do not set the scale; a value twice as large does.
TEST(PictureMaps, AFlangeDoesNotSetTheScale) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) {
    values.push_back(1000.0 + 20.0 * i);
  }
  values.push_back(std::nan(""));
  EXPECT_EQ(driver::range_of_most(values).greatest, 1380.0);
  values.push_back(1600.0);
  EXPECT_EQ(driver::range_of_most(values).greatest, 1600.0);
  values.push_back(9000.0);
  EXPECT_EQ(driver::range_of_most(values).greatest, 1600.0);
  EXPECT_EQ(driver::range_of_most(values).least, 1000.0);
}

TEST(PictureMaps, OfFewValuesAllCount) {
  EXPECT_EQ(driver::range_of_most({1.0, 1.1, 1.2, 50.0}).greatest, 50.0);
}

} // namespace
} // namespace picture_maps_test
