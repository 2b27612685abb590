/// Grids of the cascade: what must come through exactly, and boxes.
#include "mechanics/cascade.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace wrc::test::cascade_test {
namespace {

/// Some sums of some numbers of the order of ten.
constexpr double rounding = 1e-13;

using Field = std::function<double(double, double)>;

/// Values at element centres, in the unit of an element of the finest grid.
std::vector<double> sample(const LevelSize& size, double element, const Field& field) {
  std::vector<double> values;
  for (std::size_t row = 0; row < size.rows; ++row) {
    for (std::size_t column = 0; column < size.columns; ++column) {
      values.push_back(field((static_cast<double>(column) + 0.5) * element,
                             (static_cast<double>(row) + 0.5) * element));
    }
  }
  return values;
}

Grid grid_of(const LevelSize& size, double element) {
  return {size.rows, size.columns, element, element, 0.5 * element, 0.5 * element};
}

std::vector<double> refined_from(const LevelSize& coarse, const std::vector<double>& pressure,
                                 const LevelSize& fine) {
  std::vector<double> refined;
  refine_pressure(grid_of(coarse, 2.0), pressure, grid_of(fine, 1.0), refined);
  return refined;
}

constexpr LevelSize sizes[] = {{16, 34}, {17, 34}, {34, 17}, {17, 35}, {64, 33}};

TEST(Cascade, GridsAreHalvedWhileItHelps) {
  EXPECT_FALSE(can_coarsen({32, 32}));
  EXPECT_TRUE(can_coarsen({33, 16}));
  EXPECT_TRUE(can_coarsen({16, 33}));
  EXPECT_FALSE(can_coarsen({15, 1000}));
  EXPECT_FALSE(can_coarsen({1, 1}));
  EXPECT_EQ(coarser_size({33, 16}).rows, 17U);
  EXPECT_EQ(coarser_size({33, 16}).columns, 8U);
  for (LevelSize size{4001, 301}; can_coarsen(size);) {
    const LevelSize coarser = coarser_size(size);
    EXPECT_LT(coarser.count(), size.count());
    EXPECT_GE(std::min(coarser.rows, coarser.columns), 8U);
    size = coarser;
  }
}

TEST(Cascade, PressuresKeepTheirMeansAndAreNeverNegative) {
  const LevelSize size{5, 6};
  std::vector<double> pressure(size.count(), 0.0);
  pressure[0] = 4.0;
  pressure[7] = 2.0;
  pressure[3 * 6 + 4] = 8.0; // a row after the last one would continue to -8
  std::vector<double> coarse;
  coarsen_pressure(size, pressure, coarse);
  ASSERT_EQ(coarse.size(), 9U);
  EXPECT_DOUBLE_EQ(coarse[0], 1.5);
  EXPECT_DOUBLE_EQ(coarse[1], 0.0);
  EXPECT_DOUBLE_EQ(coarse[5], 2.0);
  EXPECT_DOUBLE_EQ(coarse[8], 0.0);
}

TEST(Cascade, LinearDistancesStayLinear) {
  const Field plane = [](double x, double y) { return 3.0 - 0.25 * x + 0.125 * y; };
  for (const LevelSize& fine : sizes) {
    std::vector<double> coarse;
    coarsen_distance(fine, sample(fine, 1.0, plane), coarse);
    const LevelSize size = coarser_size(fine);
    ASSERT_EQ(coarse.size(), size.count());
    // Lengths are counted in elements of the grid itself: half as many of twice the size.
    const std::vector<double> expected = sample(size, 2.0, plane);
    for (std::size_t index = 0; index < coarse.size(); ++index) {
      ASSERT_NEAR(coarse[index], 0.5 * expected[index], rounding);
    }
  }
}

TEST(Cascade, CoarserDistancesAreMeans) {
  const LevelSize fine{18, 36};
  std::vector<double> distance(fine.count(), 0.0);
  distance[4 * 36 + 7] = 8.0; // in element (2, 3) of the coarser grid
  std::vector<double> coarse{1.0, 2.0};
  coarsen_distance(fine, distance, coarse);
  EXPECT_EQ(coarse[2 * 18 + 3], 1.0);
  EXPECT_EQ(std::count(coarse.begin(), coarse.end(), 0.0), 9 * 18 - 1);
}

TEST(Cascade, LinearSquaresOfPressureStayLinear) {
  // An edge of contact across the grid: the new edge is where the line crosses zero. Exact away
  // from the grid's own edges, where a partner for the interpolation or continuation is missing.
  const Field square = [](double x, double) { return 12.25 - x; };
  for (const LevelSize& fine : sizes) {
    const LevelSize coarse = coarser_size(fine);
    std::vector<double> pressure = sample(coarse, 2.0, square);
    for (double& value : pressure) {
      value = std::sqrt(std::max(0.0, value));
    }
    const std::vector<double> refined = refined_from(coarse, pressure, fine);
    ASSERT_EQ(refined.size(), fine.count());
    const std::vector<double> expected = sample(fine, 1.0, square);
    for (std::size_t index = 0; index < refined.size(); ++index) {
      const std::size_t row = index / fine.columns;
      const std::size_t column = index % fine.columns;
      if (row >= 5 && row + 5 < fine.rows && column > 0 && column + 2 < fine.columns) {
        ASSERT_NEAR(refined[index] * refined[index], std::max(0.0, expected[index]), rounding)
            << "row " << row << ", column " << column << " of " << fine.rows << " x "
            << fine.columns;
      }
    }
  }
}

TEST(Cascade, EvenPressureStaysEven) {
  for (const LevelSize& fine : sizes) {
    const LevelSize coarse = coarser_size(fine);
    for (const double value :
         refined_from(coarse, std::vector<double>(coarse.count(), 2.0), fine)) {
      ASSERT_NEAR(value, 2.0, rounding);
    }
    EXPECT_EQ(refined_from(coarse, std::vector<double>(coarse.count(), 0.0), fine),
              std::vector<double>(fine.count(), 0.0));
  }
}

TEST(Cascade, ASinglePressedElementIsNotLost) {
  const LevelSize fine{20, 40};
  const LevelSize coarse = coarser_size(fine);
  for (const std::size_t place : {std::size_t{0}, std::size_t{5 * 20 + 7}, coarse.count() - 1}) {
    std::vector<double> pressure(coarse.count(), 0.0);
    pressure[place] = 4.0;
    const std::vector<double> refined = refined_from(coarse, pressure, fine);
    const std::size_t row = 2 * (place / coarse.columns);
    const std::size_t column = 2 * (place % coarse.columns);
    for (std::size_t index = 0; index < refined.size(); ++index) {
      const bool inside = index / 40 / 2 * 2 == row && index % 40 / 2 * 2 == column;
      ASSERT_GE(refined[index], 0.0);
      ASSERT_EQ(refined[index] > 0.0, inside) << index;
    }
  }
}

TEST(Cascade, RefinedPressuresOfAnEllipsoidAreClose) {
  const Field hertz = [](double x, double y) {
    return std::sqrt(
        std::max(0.0, 1.0 - std::pow((x - 32.0) / 20.0, 2) - std::pow((y - 32.0) / 15.0, 2)));
  };
  const LevelSize fine{64, 64};
  const std::vector<double> refined = refined_from({32, 32}, sample({32, 32}, 2.0, hertz), fine);
  const std::vector<double> expected = sample(fine, 1.0, hertz);
  double worst_square = 0.0;
  for (std::size_t index = 0; index < refined.size(); ++index) {
    worst_square = std::max(worst_square, std::abs(refined[index] * refined[index] -
                                                   expected[index] * expected[index]));
  }
  // Interpolation of a parabola at a quarter of a step: 3/32 h^2 f''. A continued value is off by
  // h^2 f'' and has a weight of 7/16 at the most; both directions add up.
  constexpr double step = 2.0;
  EXPECT_LE(worst_square, (3.0 / 32.0 + 7.0 / 16.0) * step * step * (2.0 / 400.0 + 2.0 / 225.0));
}

TEST(Cascade, PressuresMoveToAnyGrid) {
  // p^2 linear both ways: exact wherever it is interpolated, and nothing beyond the old grid.
  const Field square = [](double x, double y) { return 60.0 + x - 0.5 * y; };
  const LevelSize old{20, 16};
  std::vector<double> pressure = sample(old, 2.0, square);
  for (double& value : pressure) {
    value = std::sqrt(value);
  }
  const Grid finer{31, 70, 0.7, 0.6, 3.3, -1.1};
  std::vector<double> moved;
  refine_pressure(grid_of(old, 2.0), pressure, finer, moved);
  for (std::size_t row = 0; row < finer.lateral_count; ++row) {
    for (std::size_t column = 0; column < finer.longitudinal_count; ++column) {
      const double x = finer.longitudinal(column);
      const double value = moved[row * finer.longitudinal_count + column];
      if (x < 0.0 || x > 32.0) {
        ASSERT_EQ(value, 0.0);
      } else if (x >= 1.0 && x <= 31.0) {
        ASSERT_NEAR(value * value, square(x, finer.lateral(row)), 1e3 * rounding);
      }
    }
  }
}

TEST(Cascade, BoxesHoldAllPressure) {
  const LevelSize size{12, 17};
  ElementBox box;
  std::vector<double> pressure(size.count(), 0.0);
  EXPECT_FALSE(find_pressure_box(size, pressure, 2, box));
  pressure[3 * 17 + 5] = 1.0;
  ASSERT_TRUE(find_pressure_box(size, pressure, 0, box));
  EXPECT_EQ(box.rows(), 1U);
  EXPECT_EQ(box.columns(), 1U);
  EXPECT_TRUE(box.holds(3, 5));
  EXPECT_FALSE(box.holds(3, 6));
  EXPECT_FALSE(box.holds(2, 5));
  pressure[9 * 17 + 1] = 1e-300;
  ASSERT_TRUE(find_pressure_box(size, pressure, 2, box));
  EXPECT_EQ(box.first_row, 1U);
  EXPECT_EQ(box.last_row, 11U);
  EXPECT_EQ(box.first_column, 0U);
  EXPECT_EQ(box.last_column, 7U);
  // Margins end at the grid.
  pressure.front() = 1.0;
  pressure.back() = 1.0;
  ASSERT_TRUE(find_pressure_box(size, pressure, 100, box));
  EXPECT_EQ(box.first_row, 0U);
  EXPECT_EQ(box.last_row, 11U);
  EXPECT_EQ(box.first_column, 0U);
  EXPECT_EQ(box.last_column, 16U);
}

} // namespace
} // namespace wrc::test::cascade_test
