/// Influence coefficients against integrals in long double that share no formula with the core.
#include "half_space/influence_coefficients.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "extent.hpp"

namespace wrc::test::influence_coefficients_test {
namespace {

/// What influence_coefficients.hpp promises: rounding times the distance in elements plus the
/// first neglected term of the expansion.
constexpr double relative_tolerance = 1e-12;

const std::vector<double> aspect_ratios{1.0 / 200.0, 1.0 / 30.0, 0.5, 1.0, 3.0, 30.0, 100.0};

long double primitive(long double x, long double y) {
  const long double first = x == 0.0L ? 0.0L : x * std::asinh(y / std::abs(x));
  const long double second = y == 0.0L ? 0.0L : y * std::asinh(x / std::abs(y));
  return first + second;
}

/// Love's closed form as printed: exact, but it cancels far from the element.
long double closed_form(long double x, long double y, long double a, long double b) {
  return primitive(x + a / 2, y + b / 2) - primitive(x - a / 2, y + b / 2) -
         primitive(x + a / 2, y - b / 2) + primitive(x - a / 2, y - b / 2);
}

/// Midpoint-free quadrature of 1/distance over squarish pieces, five Gauss points each way.
long double quadrature(long double x, long double y, long double a, long double b) {
  constexpr std::array<long double, 3> node{0.0L, 0.538469310105683091036314420700208805L,
                                            0.906179845938663992797626878299392965L};
  constexpr std::array<long double, 3> weight{0.568888888888888888888888888888888889L,
                                              0.478628670499366468041291514835638193L,
                                              0.236926885056189087514264040719917363L};
  const int pieces_x = static_cast<int>(std::ceil(std::max(1.0L, a / b)));
  const int pieces_y = static_cast<int>(std::ceil(std::max(1.0L, b / a)));
  const long double piece_a = a / static_cast<long double>(pieces_x);
  const long double piece_b = b / static_cast<long double>(pieces_y);
  long double sum = 0.0L;
  for (int i = 0; i < pieces_x; ++i) {
    for (int j = 0; j < pieces_y; ++j) {
      const long double centre_x = -a / 2 + (static_cast<long double>(i) + 0.5L) * piece_a;
      const long double centre_y = -b / 2 + (static_cast<long double>(j) + 0.5L) * piece_b;
      for (int m = -2; m <= 2; ++m) {
        for (int n = -2; n <= 2; ++n) {
          const auto at = [&](int k) {
            const long double value = node[static_cast<std::size_t>(std::abs(k))];
            return (k < 0 ? -value : value) / 2;
          };
          const long double distance =
              std::hypot(x - centre_x - at(m) * piece_a, y - centre_y - at(n) * piece_b);
          sum += weight[static_cast<std::size_t>(std::abs(m))] *
                 weight[static_cast<std::size_t>(std::abs(n))] / distance;
        }
      }
    }
  }
  return sum / 4 * piece_a * piece_b;
}

/// Closed form near, quadrature where that is at its own rounding (beyond 30 short sides).
long double reference(long double x, long double y, long double a, long double b) {
  return std::hypot(x, y) < 30.0L * std::min(a, b) + std::max(a, b) ? closed_form(x, y, a, b)
                                                                    : quadrature(x, y, a, b);
}

TEST(InfluenceCoefficients, EqualTheReferenceAtElementCentres) {
  for (const double aspect : aspect_ratios) {
    for (const double column : {0.0, 1.0, 2.0, 7.0, 15.0, 16.0, 23.0, 24.0, 100.0, 1600.0}) {
      for (const double row : {0.0, 1.0, 3.0, 15.0, 16.0, 25.0, 321.0, 3199.0, 3201.0}) {
        const double x = column * aspect;
        const double expected = static_cast<double>(reference(x, row, aspect, 1.0L));
        EXPECT_NEAR(influence_integral(x, row, aspect, 1.0) / expected, 1.0, relative_tolerance)
            << "aspect " << aspect << " column " << column << " row " << row;
      }
    }
  }
}

TEST(InfluenceCoefficients, EqualTheReferenceBetweenElementCentres) {
  for (const double aspect : aspect_ratios) {
    for (const double column : {0.0, 0.2, 0.5, 0.7, 1.5, 9.3}) {
      for (const double row : {0.0, 0.3, 0.5, 0.9, 2.5, 11.1}) {
        const double x = column * aspect;
        const double expected = static_cast<double>(reference(x, row, aspect, 1.0L));
        EXPECT_NEAR(influence_integral(x, row, aspect, 1.0) / expected, 1.0, relative_tolerance)
            << "aspect " << aspect << " column " << column << " row " << row;
      }
    }
  }
}

TEST(InfluenceCoefficients, JoinSmoothlyWhereTheExpansionTakesOver) {
  for (const double aspect : aspect_ratios) {
    for (const double angle : {0.0, 0.3, 0.8, 1.2, 0.5 * std::numbers::pi}) {
      const double radius = far_field_distance * std::fmax(aspect, 1.0);
      const double inside = radius * (1.0 - 1e-9);
      const double outside = radius * (1.0 + 1e-9);
      const double ratio =
          influence_integral(outside * std::cos(angle), outside * std::sin(angle), aspect, 1.0) *
          outside /
          (influence_integral(inside * std::cos(angle), inside * std::sin(angle), aspect, 1.0) *
           inside);
      // Times the distance the integral changes only by the quadrupole, 2e-9/16^2 of it here.
      EXPECT_NEAR(ratio, 1.0, 2.0 * relative_tolerance) << aspect << " " << angle;
    }
  }
}

/// What the header promises: rounding times the distance in elements, which is in the thousands for
/// the longest ones, and the error of the expansion.
double tolerance_at(double x, double y, double aspect) {
  return 4.0 * std::numeric_limits<double>::epsilon() *
             (1.0 + std::hypot(x, y) / std::fmin(1.0, aspect)) +
         3e-13;
}

/// The coefficient of a smooth element from those of constant ones, as the header has it.
long double smooth_reference(long double x, long double y, long double a, long double b) {
  const long double here = reference(x, y, a, b);
  return here - (reference(x - a, y, a, b) + reference(x + a, y, a, b) + reference(x, y - b, a, b) +
                 reference(x, y + b, a, b) - 4.0L * here) /
                    24.0L;
}

TEST(InfluenceCoefficients, TablesEqualTheReference) {
  constexpr std::size_t near_columns = 40;
  for (const double aspect : some_of(aspect_ratios, 3)) {
    // Longer than the near field along one of the sides.
    const std::size_t columns = aspect > 1.0 ? static_cast<std::size_t>(18.0 * aspect) : 20;
    const std::size_t rows = aspect < 1.0 ? static_cast<std::size_t>(18.0 / aspect) : 20;
    std::vector<double> constant(rows * columns);
    std::vector<double> smooth(rows * columns);
    fill_influence_table({aspect, Elements::constant}, rows, columns, constant);
    fill_influence_table({aspect, Elements::smooth}, rows, columns, smooth);
    for (std::size_t row = 0; row < rows; row += row < near_columns ? 1 : 101) {
      for (std::size_t column = 0; column < columns; column += column < near_columns ? 1 : 101) {
        const auto x = static_cast<long double>(column);
        const long double y = static_cast<long double>(row) * static_cast<long double>(aspect);
        const auto expected = static_cast<double>(reference(x, y, 1.0L, aspect));
        const auto expected_smooth = static_cast<double>(smooth_reference(x, y, 1.0L, aspect));
        const std::size_t index = row * columns + column;
        // The sum of the weights of smooth elements, 7/6 and four times 1/24, is 4/3.
        const double tolerance =
            tolerance_at(static_cast<double>(x), static_cast<double>(y), aspect);
        ASSERT_NEAR(constant[index] / expected, 1.0, tolerance)
            << row << ", " << column << ", aspect " << aspect;
        ASSERT_NEAR(smooth[index] / expected_smooth, 1.0, 4.0 / 3.0 * tolerance)
            << row << ", " << column << ", aspect " << aspect;
      }
    }
  }
}

TEST(InfluenceCoefficients, TablesEqualTheIntegral) {
  constexpr std::size_t size = 40;
  // Another order of rounding: some units of it times the distance in elements, twice as many for
  // smooth elements, which add up five coefficients.
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon() * size;
  std::vector<double> constant(size * size);
  std::vector<double> smooth(size * size);
  for (double aspect = 1.0 / 200.0; aspect <= 100.0; aspect *= 1.37) {
    fill_influence_table({aspect, Elements::constant}, size, size, constant);
    fill_influence_table({aspect, Elements::smooth}, size, size, smooth);
    for (std::size_t index = 0; index < size * size; ++index) {
      const auto x = static_cast<double>(index % size);
      const double y = static_cast<double>(index / size) * aspect;
      ASSERT_NEAR(constant[index] / influence_integral(x, y, 1.0, aspect), 1.0, rounding)
          << x << ", " << y << ", aspect " << aspect;
      const double expected =
          influence_coefficient(x, y, 1.0, aspect, 1.0 / std::numbers::pi, Elements::smooth);
      ASSERT_NEAR(smooth[index] / expected, 1.0, rounding)
          << x << ", " << y << ", aspect " << aspect;
    }
  }
}

TEST(InfluenceCoefficients, CentreOfASquare) {
  // Johnson (1985), section 3.3: 4 a ln(1 + sqrt 2) for a square of side a.
  EXPECT_NEAR(influence_integral(0.0, 0.0, 2.0, 2.0), 8.0 * std::log(1.0 + std::sqrt(2.0)),
              8.0 * relative_tolerance);
  EXPECT_DOUBLE_EQ(influence_coefficient(0.3, -0.4, 1.0, 2.0, 5.0),
                   influence_integral(0.3, 0.4, 1.0, 2.0) / (std::numbers::pi * 5.0));
}

} // namespace
} // namespace wrc::test::influence_coefficients_test
