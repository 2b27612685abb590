/// The DC-FFT product against the dense sum over all pairs of elements.
#include "half_space/displacement_operator.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "extent.hpp"
#include "half_space/influence_coefficients.hpp"
#include "support/errors.hpp"

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
  for (const auto& [rows, columns] : some_of(sizes, 4)) {
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

/// From one direction to another by `turn`, faster in the middle as on a gauge corner.
std::vector<double> angles_of(std::size_t rows, double first, double turn) {
  std::vector<double> angles(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const double t = (static_cast<double>(row) + 0.5) / static_cast<double>(rows);
    angles[row] = first + turn * t * t * (3.0 - 2.0 * t);
  }
  return angles;
}

std::vector<double> displaced(const Grid& grid, const std::vector<double>& angles,
                              const std::vector<double>& pressure) {
  std::vector<double> displacement(pressure.size());
  DisplacementOperator(grid, modulus, Elements::smooth, angles).apply(pressure, displacement);
  return displacement;
}

double dot(const std::vector<double>& one, const std::vector<double>& other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected,
                 double turn) {
  const double size = std::sqrt(dot(expected, expected));
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], relative_tolerance * size) << turn << ", " << i;
  }
}

TEST(DisplacementOperatorAlongACurve, EqualsTheDenseSum) {
  for (const double turn : {0.1, 1.2, 3.0}) {
    const Grid grid{17, 9, 0.1, 0.25, -3.0, 4.0};
    const std::vector<double> angles = angles_of(17, 0.4, turn);
    const std::vector<double> pressure = random_pressure(grid.element_count());
    std::vector<double> expected(pressure.size());
    for (std::size_t to = 0; to < pressure.size(); ++to) {
      for (std::size_t from = 0; from < pressure.size(); ++from) {
        const double rows = static_cast<double>(to / 9) - static_cast<double>(from / 9);
        const double columns = static_cast<double>(to % 9) - static_cast<double>(from % 9);
        expected[to] +=
            std::cos(angles[to / 9] - angles[from / 9]) * pressure[from] *
            influence_coefficient(columns * 0.25, rows * 0.1, 0.25, 0.1, modulus, Elements::smooth);
      }
    }
    expect_near(displaced(grid, angles, pressure), expected, turn);
  }
}

TEST(DisplacementOperatorAlongACurve, OfRowsWithOneAngleIsThatOfAPlaneBitForBit) {
  const Grid grid{24, 13, 0.1, 0.3, 0.0, 0.0};
  const std::vector<double> pressure = random_pressure(grid.element_count());
  for (const double angle : {0.0, 0.7, -1.2}) {
    EXPECT_EQ(displaced(grid, std::vector<double>(24, angle), pressure),
              displaced(grid, {}, pressure))
        << angle;
  }
}

TEST(DisplacementOperatorAlongACurve, RefusesAnglesOfOtherRowsAndThoseThatAreNotFinite) {
  const Grid grid{3, 2, 0.1, 0.2, 0.0, 0.0};
  const auto refuses = [&grid](const std::vector<double>& angles, const char* part) {
    expect_error(
        ErrorCode::invalid_argument,
        [&] { DisplacementOperator(grid, modulus, Elements::smooth, angles); }, part);
    expect_error(
        ErrorCode::invalid_argument, [&] { check_angles(angles, grid); }, part);
  };
  refuses({0.1, 0.2}, "angles.size = 2: must be the grid's 3 rows");
  refuses({0.1, 0.2, std::nan("")}, "angles[2] = nan: must be finite");
  EXPECT_NO_THROW(check_angles({}, grid));
}

/// Also where cosines and sines have zeros and change sign: rows that face each other.
TEST(DisplacementOperatorAlongACurve, IsSymmetricAndPositiveDefinite) {
  const Grid grid{32, 12, 0.05, 0.2, 0.0, 0.0};
  std::mt19937_64 generator(3);
  const auto draw = [&generator, &grid] {
    std::vector<double> field(grid.element_count());
    for (double& value : field) {
      value = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
    }
    return field;
  };
  for (const double turn : {0.02, 1.4, 6.0}) {
    const std::vector<double> angles = angles_of(32, -0.3, turn);
    for (int i = 0; i < 20; ++i) {
      const std::vector<double> one = draw();
      const std::vector<double> other = draw();
      const std::vector<double> of_one = displaced(grid, angles, one);
      const std::vector<double> of_other = displaced(grid, angles, other);
      const double energy = dot(one, of_one);
      EXPECT_GT(energy, 0.0) << turn;
      EXPECT_NEAR(dot(other, of_one), dot(one, of_other),
                  relative_tolerance * std::sqrt(energy * dot(other, of_other)))
          << turn;
    }
  }
}

TEST(DisplacementOperatorAlongACurve, ATurnOfAllRowsChangesNothing) {
  const Grid grid{20, 8, 0.1, 0.2, 0.0, 0.0};
  const std::vector<double> pressure = random_pressure(grid.element_count());
  expect_near(displaced(grid, angles_of(20, 0.9, 0.5), pressure),
              displaced(grid, angles_of(20, 0.0, 0.5), pressure), 0.5);
}

TEST(DisplacementOperatorAlongACurve, RefusesOtherNumbersOfAnglesAndWhatIsNotFinite) {
  const Grid grid{4, 3, 0.1, 0.2, 0.0, 0.0};
  const std::vector<double> few(3, 0.0);
  const std::vector<double> broken{0.0, 0.0, std::nan(""), 0.0};
  EXPECT_THROW(DisplacementOperator(grid, modulus, Elements::smooth, few), Error);
  EXPECT_THROW(DisplacementOperator(grid, modulus, Elements::smooth, broken), Error);
}

} // namespace
} // namespace wrc::test::displacement_operator_test
