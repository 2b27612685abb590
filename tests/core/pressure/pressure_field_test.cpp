/// Peak, patches and extents against fields whose figures are known.
#include "pressure/pressure_field.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "models/hertz.hpp"

namespace wrc::test::pressure_field_test {
namespace {

/// Fields of moderate numbers, summed in double precision.
constexpr double rounding = 1e-12;

TEST(PressureField, FitIsExactForAQuadraticAndNeverBelowTheLargestElement) {
  const Grid grid{5, 5, 0.5, 2.0, 0.0, 0.0};
  std::vector<double> pressure(25);
  const auto fill = [&](double row0, double column0) {
    for (std::size_t row = 0; row < 5; ++row) {
      for (std::size_t column = 0; column < 5; ++column) {
        const double y = static_cast<double>(row) - row0;
        const double x = static_cast<double>(column) - column0;
        pressure[row * 5 + column] = 1000.0 - 3.0 * y * y - 5.0 * x * x + 1.5 * x * y;
      }
    }
  };
  fill(2.3, 1.8);
  EXPECT_NEAR(peak_pressure(grid, pressure), 1000.0, 1000.0 * rounding);
  // Largest element on the edge: nothing to fit.
  fill(0.1, 2.0);
  EXPECT_EQ(peak_pressure(grid, pressure), *std::max_element(pressure.begin(), pressure.end()));
  // A neighbour without pressure.
  fill(2.3, 1.8);
  pressure[1 * 5 + 1] = 0.0;
  EXPECT_EQ(peak_pressure(grid, pressure), *std::max_element(pressure.begin(), pressure.end()));
  // A lone spike: the smooth fit lies below it.
  std::fill(pressure.begin(), pressure.end(), 1.0);
  pressure[12] = 9.0;
  EXPECT_EQ(peak_pressure(grid, pressure), 9.0);
}

TEST(PressureField, PeakOfASampledHertzPressureConvergesWithOrderTwo) {
  const HertzContact contact = solve_hertz(1.0 / 300.0, 1.0 / 300.0, 1e5, 1e4);
  std::vector<double> errors;
  for (const std::size_t count : {15U, 30U, 60U}) {
    const double step = 2.0 * contact.semi_axis_lateral / static_cast<double>(count);
    const Grid grid{count,
                    count,
                    step,
                    step,
                    -0.5 * step * static_cast<double>(count) + 0.8 * step,
                    -0.5 * step * static_cast<double>(count) + 0.8 * step};
    std::vector<double> pressure;
    for (std::size_t index = 0; index < grid.element_count(); ++index) {
      pressure.push_back(
          hertz_pressure(contact, grid.longitudinal(index % count), grid.lateral(index / count)));
    }
    errors.push_back(std::abs(peak_pressure(grid, pressure) / contact.peak_pressure - 1.0));
  }
  // Point values of a smooth top: at least order two between doublings, and small from the start.
  EXPECT_LT(errors[0], 1.0 / (15.0 * 15.0));
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.7);
}

TEST(PressureField, RegionsAreFoundSortedAndMeasured) {
  const Grid grid{6, 8, 0.5, 2.0, 10.0, -20.0};
  std::vector<double> pressure(48, 0.0);
  // Two elements that share only a corner are one patch.
  pressure[1 * 8 + 1] = 2.0;
  pressure[2 * 8 + 2] = 4.0;
  // A heavier one on two edges of the grid.
  pressure[4 * 8 + 7] = 3.0;
  pressure[5 * 8 + 7] = 7.0;
  const std::vector<PressureRegion> regions = pressure_regions(grid, pressure);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].element_count, 2U);
  EXPECT_DOUBLE_EQ(regions[0].normal_force, 10.0);
  EXPECT_DOUBLE_EQ(regions[0].area, 2.0);
  EXPECT_DOUBLE_EQ(regions[0].peak_pressure, 7.0);
  EXPECT_DOUBLE_EQ(regions[0].largest_element_pressure, 7.0);
  EXPECT_DOUBLE_EQ(regions[0].centroid_lateral, 12.0 + 0.7 * 0.5);
  EXPECT_DOUBLE_EQ(regions[0].centroid_longitudinal, -6.0);
  EXPECT_TRUE(regions[0].touches_edge.lateral_last);
  EXPECT_TRUE(regions[0].touches_edge.longitudinal_last);
  EXPECT_FALSE(regions[0].touches_edge.lateral_first);
  EXPECT_FALSE(regions[0].touches_edge.longitudinal_first);
  EXPECT_EQ(regions[0].semi_axis_longitudinal, 0.0);
  // <y^2> about the centroid is 0.21 steps^2.
  EXPECT_NEAR(regions[0].semi_axis_lateral, 0.5 * std::sqrt(5.0 * 0.21), rounding);
  EXPECT_DOUBLE_EQ(regions[1].normal_force, 6.0);
  EXPECT_FALSE(regions[1].touches_edge.any());
  EXPECT_EQ(regions[1].box.lateral_first, 1U);
  EXPECT_EQ(regions[1].box.lateral_last, 2U);
  EXPECT_EQ(regions[1].box.longitudinal_first, 1U);
  EXPECT_EQ(regions[1].box.longitudinal_last, 2U);

  const PressureRegion whole = summarise_pressure(grid, pressure);
  EXPECT_EQ(whole.element_count, 4U);
  EXPECT_DOUBLE_EQ(whole.normal_force, 16.0);
  EXPECT_EQ(whole.box.lateral_first, 1U);
  EXPECT_EQ(whole.box.longitudinal_last, 7U);
  EXPECT_TRUE(whole.touches_edge.lateral_last && whole.touches_edge.longitudinal_last);
  EXPECT_FALSE(whole.touches_edge.lateral_first || whole.touches_edge.longitudinal_first);
}

TEST(PressureField, EqualForcesStayInTheOrderOfTheirFirstElement) {
  const Grid grid{1, 5, 1.0, 1.0, 0.0, 0.0};
  const std::vector<PressureRegion> regions =
      pressure_regions(grid, std::vector<double>{2.0, 0.0, 3.0, 0.0, 2.0});
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(regions[0].centroid_longitudinal, 2.0);
  EXPECT_EQ(regions[1].centroid_longitudinal, 0.0);
  EXPECT_EQ(regions[2].centroid_longitudinal, 4.0);
  EXPECT_TRUE(regions[0].touches_edge.lateral_first && regions[0].touches_edge.lateral_last);
}

TEST(PressureField, NoPressureGivesNoRegion) {
  const Grid grid{3, 2, 1.0, 1.0, 0.0, 0.0};
  const std::vector<double> none(6, 0.0);
  EXPECT_TRUE(pressure_regions(grid, none).empty());
  EXPECT_EQ(peak_pressure(grid, none), 0.0);
  EXPECT_EQ(summarise_pressure(grid, none).element_count, 0U);
  EXPECT_FALSE(summarise_pressure(grid, none).touches_edge.any());
  const std::vector<double> wrong(5, 0.0);
  EXPECT_THROW(pressure_regions(grid, wrong), Error);
  EXPECT_THROW(peak_pressure(grid, wrong), Error);
  EXPECT_THROW(summarise_pressure(grid, wrong), Error);
}

TEST(PressureField, SecondMomentsGiveTheHertzianAxes) {
  const HertzContact contact = solve_hertz(1.0 / 460.0, 1.0 / 60.0, 1e5, 5e4);
  constexpr std::size_t count = 120;
  const double step_y = 2.2 * contact.semi_axis_lateral / static_cast<double>(count);
  const double step_x = 2.2 * contact.semi_axis_longitudinal / static_cast<double>(count);
  const Grid grid{count, count, step_y, step_x, 3.0 - 59.5 * step_y, -59.5 * step_x};
  std::vector<double> pressure;
  for (std::size_t index = 0; index < grid.element_count(); ++index) {
    pressure.push_back(hertz_pressure(contact, grid.longitudinal(index % count),
                                      grid.lateral(index / count) - 3.0));
  }
  const PressureRegion region = summarise_pressure(grid, pressure);
  // Sampled at 109 elements across: about 1/n^2 in the axes, n^-3/2 of the edge in the force.
  EXPECT_NEAR(region.semi_axis_lateral / contact.semi_axis_lateral, 1.0, 5e-4);
  EXPECT_NEAR(region.semi_axis_longitudinal / contact.semi_axis_longitudinal, 1.0, 5e-4);
  EXPECT_NEAR(region.normal_force / contact.normal_force, 1.0, 1e-3);
  EXPECT_NEAR(region.centroid_lateral, 3.0, rounding * 10.0);
  // Counting elements is of order one: half an element around the rim at the most.
  const double area = std::numbers::pi * contact.semi_axis_lateral * contact.semi_axis_longitudinal;
  EXPECT_NEAR(region.area / area, 1.0, 2.0 / 109.0);
}

} // namespace
} // namespace wrc::test::pressure_field_test
