/// The DC-FFT product against the dense sum over all pairs of elements.
#include "half_space/displacement_operator.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "half_space/influence_coefficients.hpp"

namespace wrc::test::displacement_operator_test {
namespace {

/// Rounding of a transform grows like the logarithm of its length; this leaves a factor of 100.
constexpr double relative_tolerance = 1e-12;
constexpr double modulus = 115384.6;

std::vector<double> random_pressure(std::size_t count) {
  std::mt19937_64 generator(7);
  std::vector<double> pressure(count);
  for (double& value : pressure) {
    value = static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  return pressure;
}

std::vector<double> dense_product(const Grid& grid, const std::vector<double>& pressure,
                                  Elements elements) {
  std::vector<double> displacement(pressure.size(), 0.0);
  const std::size_t columns = grid.longitudinal_count;
  for (std::size_t to = 0; to < pressure.size(); ++to) {
    for (std::size_t from = 0; from < pressure.size(); ++from) {
      const double rows_between =
          static_cast<double>(to / columns) - static_cast<double>(from / columns);
      const double columns_between =
          static_cast<double>(to % columns) - static_cast<double>(from % columns);
      displacement[to] +=
          pressure[from] * influence_coefficient(columns_between * grid.longitudinal_step,
                                                 rows_between * grid.lateral_step,
                                                 grid.longitudinal_step, grid.lateral_step, modulus,
                                                 elements);
    }
  }
  return displacement;
}

TEST(DisplacementOperator, EqualsTheDenseSum) {
  const std::vector<std::pair<std::size_t, std::size_t>> sizes{
      {1, 1}, {1, 7}, {13, 1}, {2, 3}, {16, 16}, {17, 31}, {40, 9}, {37, 29}};
  for (const auto& [rows, columns] : sizes) {
    for (const double aspect : {1.0 / 200.0, 1.0, 2.5, 100.0}) {
      const Grid grid{rows, columns, 0.1, 0.1 * aspect, -3.0, 4.0};
      const std::vector<double> pressure = random_pressure(grid.element_count());
      for (const Elements elements : {Elements::constant, Elements::smooth}) {
        const std::vector<double> expected = dense_product(grid, pressure, elements);
        std::vector<double> found(pressure.size());
        DisplacementOperator(grid, modulus, elements).apply(pressure, found);
        for (std::size_t index = 0; index < found.size(); ++index) {
          ASSERT_NEAR(found[index] / expected[index], 1.0, relative_tolerance)
              << rows << " x " << columns << " aspect " << aspect << " element " << index;
        }
      }
    }
  }
}

/// Largest error at the centre and beside it, relative to u(0), of a Gaussian pressure of unit
/// standard deviation with this many elements over it: u(r) = sqrt(2 pi)/E* exp(-r^2/4) I0(r^2/4).
double gaussian_error(double elements_over_deviation, double aspect, Elements elements) {
  const double step = 1.0 / elements_over_deviation;
  const auto half = static_cast<std::size_t>(std::ceil(8.0 / step));
  const auto half_rows = static_cast<std::size_t>(std::ceil(8.0 / (step * aspect)));
  const Grid grid{2 * half_rows + 1,
                  2 * half + 1,
                  step * aspect,
                  step,
                  -step * aspect * static_cast<double>(half_rows),
                  -step * static_cast<double>(half)};
  std::vector<double> pressure;
  for (std::size_t index = 0; index < grid.element_count(); ++index) {
    const double x = grid.longitudinal(index % grid.longitudinal_count);
    const double y = grid.lateral(index / grid.longitudinal_count);
    pressure.push_back(std::exp(-0.5 * (x * x + y * y)));
  }
  std::vector<double> found(pressure.size());
  DisplacementOperator(grid, 1.0, elements).apply(pressure, found);
  const double deepest = std::sqrt(2.0 * std::numbers::pi);
  double error = 0.0;
  for (std::size_t column = half; column <= 2 * half; ++column) {
    const double x = grid.longitudinal(column);
    const double exact = deepest * std::exp(-0.25 * x * x) * std::cyl_bessel_i(0.0, 0.25 * x * x);
    error = std::max(error, std::abs(found[half_rows * grid.longitudinal_count + column] - exact) /
                                deepest);
  }
  return error;
}

TEST(DisplacementOperator, ElementsOfSmoothPressureGainAnOrder) {
  for (const double aspect : {0.5, 1.0, 2.0}) {
    const double constant = gaussian_error(8.0, aspect, Elements::constant);
    EXPECT_NEAR(constant / gaussian_error(16.0, aspect, Elements::constant), 4.0, 0.4) << aspect;
    const double smooth = gaussian_error(8.0, aspect, Elements::smooth);
    EXPECT_NEAR(smooth / gaussian_error(16.0, aspect, Elements::smooth), 8.0, 0.5) << aspect;
    EXPECT_LT(smooth, 0.15 * constant) << aspect;
  }
}

TEST(DisplacementOperator, WorksInPlaceAndRepeatsBitForBit) {
  const Grid grid{11, 23, 0.2, 0.3, 0.0, 0.0};
  const std::vector<double> pressure = random_pressure(grid.element_count());
  std::vector<double> first(pressure.size());
  DisplacementOperator displacement(grid, modulus);
  displacement.apply(pressure, first);
  std::vector<double> second = pressure;
  displacement.apply(second, second);
  EXPECT_EQ(first, second);
}

TEST(DisplacementOperator, RefusesBadInput) {
  const Grid good{2, 2, 1.0, 1.0, 0.0, 0.0};
  const std::vector<Grid> bad{{0, 2, 1.0, 1.0, 0.0, 0.0},
                              {2, 0, 1.0, 1.0, 0.0, 0.0},
                              {2, 2, 0.0, 1.0, 0.0, 0.0},
                              {2, 2, 1.0, std::nan(""), 0.0, 0.0}};
  for (const Grid& grid : bad) {
    EXPECT_THROW(DisplacementOperator(grid, modulus), Error);
  }
  EXPECT_THROW(DisplacementOperator(good, 0.0), Error);
  DisplacementOperator displacement(good, modulus);
  std::vector<double> four(4);
  std::vector<double> five(5);
  EXPECT_THROW(displacement.apply(five, four), Error);
  EXPECT_THROW(displacement.apply(four, five), Error);
}

} // namespace
} // namespace wrc::test::displacement_operator_test
