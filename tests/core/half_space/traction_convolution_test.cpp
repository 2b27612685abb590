/// Tangential displacements: the coefficients against quadrature of Cerruti's solution, the
/// convolution against sums over all pairs of elements.
#include "half_space/traction_convolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::traction_convolution_test {
namespace {

/// Integrals of x^2/r^3, y^2/r^3 and x y/r^3 over the element at (x, y), by Gauss's rule with four
/// points in each of many parts.
std::array<double, 3> quadrature(double x, double y, double aspect) {
  constexpr std::array<double, 4> places{-0.8611363115940526, -0.3399810435848563,
                                         0.3399810435848563, 0.8611363115940526};
  constexpr std::array<double, 4> weights{0.3478548451374538, 0.6521451548625461,
                                          0.6521451548625461, 0.3478548451374538};
  constexpr int parts = 40;
  std::array<double, 3> sums{};
  for (int part = 0; part < parts * parts; ++part) {
    for (int point = 0; point < 16; ++point) {
      const auto at = [&](int index, int of_point) {
        return (index + 0.5 + 0.5 * places[static_cast<std::size_t>(of_point)]) / parts - 0.5;
      };
      const double u = x + at(part % parts, point % 4);
      const double v = y + aspect * at(part / parts, point / 4);
      const double weight = weights[static_cast<std::size_t>(point % 4)] *
                            weights[static_cast<std::size_t>(point / 4)] * aspect /
                            (4.0 * parts * parts);
      const double cube = std::pow(u * u + v * v, -1.5);
      sums[0] += weight * u * u * cube;
      sums[1] += weight * v * v * cube;
      sums[2] += weight * u * v * cube;
    }
  }
  return sums;
}

TEST(TractionTable, IsCerrutisIntegralOverTheElement) {
  for (const double aspect : {0.2, 1.0, 3.0}) {
    const TractionTable table = traction_table(aspect, 3, 40);
    for (std::size_t row = 0; row < 3; ++row) {
      for (const std::size_t column : {std::size_t{0}, std::size_t{1}, std::size_t{39}}) {
        if (row == 0 && column == 0) {
          continue; // the integrand is singular there
        }
        const auto expected =
            quadrature(static_cast<double>(column), static_cast<double>(row) * aspect, aspect);
        SCOPED_TRACE(testing::Message() << aspect << " row " << row << " column " << column);
        EXPECT_NEAR(table.longitudinal(row)[column], expected[0], 1e-9);
        EXPECT_NEAR(table.lateral(row)[column], expected[1], 1e-9);
        EXPECT_NEAR(table.mixed(row)[column], expected[2], 1e-9);
      }
    }
  }
}

TEST(TractionTable, TheTwoPartsAreTheNormalCoefficient) {
  const double aspect = 0.7;
  const TractionTable table = traction_table(aspect, 30, 30);
  for (std::size_t row = 0; row < 30; ++row) {
    for (std::size_t column = 0; column < 30; ++column) {
      const double whole = influence_integral(static_cast<double>(column),
                                              static_cast<double>(row) * aspect, 1.0, aspect);
      EXPECT_NEAR(table.longitudinal(row)[column] + table.lateral(row)[column], whole,
                  1e-12 * whole);
    }
  }
}

/// Displacement of one component under a unit traction, elements apart; x grows upstream.
double coefficient(const TractionTable& table, double poisson, int component, std::ptrdiff_t x,
                   std::ptrdiff_t y) {
  const auto i = static_cast<std::size_t>(std::abs(x));
  const auto j = static_cast<std::size_t>(std::abs(y));
  const double along = table.longitudinal(j)[i];
  const double across = table.lateral(j)[i];
  const double mixed = table.mixed(j)[i] * (x < 0 ? -1.0 : 1.0) * (y < 0 ? -1.0 : 1.0);
  return (component == 0   ? along + (1.0 - poisson) * across
          : component == 1 ? across + (1.0 - poisson) * along
                           : poisson * mixed) /
         std::numbers::pi;
}

template <typename Real>
void expect_dense_sum(const TractionShape& shape, const DifferenceWeights& weights) {
  const double poisson = 0.3;
  const TractionTable table = traction_table(1.4, shape.table_rows(), shape.table_columns());
  LinePlans plans;
  const std::size_t pitch = aligned_pitch<Real>(shape.columns);
  const TractionConvolution<Real> convolution(shape, pitch, poisson, weights, table, plans);
  const std::size_t count = shape.rows * pitch;
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> values(-1.0, 1.0);
  std::vector<Real> in(2 * count);
  std::generate(in.begin(), in.end(), [&] { return static_cast<Real>(values(generator)); });
  std::vector<Real> out(2 * count);
  ConvolutionWorkspace<Real> workspace;
  convolution.apply(in.data(), in.data() + count, out.data(), out.data() + count, workspace);

  double largest = 0.0;
  double worst = 0.0;
  for (std::size_t row = 0; row < shape.rows; ++row) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      double x = 0.0;
      double y = 0.0;
      for (std::size_t from_row = 0; from_row < shape.rows; ++from_row) {
        for (std::size_t from = 0; from < shape.columns; ++from) {
          for (std::size_t m = 0; m < weights.size(); ++m) {
            // Rows are counted downstream: the place m - 1 upstream of this row.
            const auto dx =
                static_cast<std::ptrdiff_t>(from_row + m) - 1 - static_cast<std::ptrdiff_t>(row);
            const auto dy = static_cast<std::ptrdiff_t>(column) - static_cast<std::ptrdiff_t>(from);
            const double qx = in[from_row * pitch + from];
            const double qy = in[count + from_row * pitch + from];
            const double xy = coefficient(table, poisson, 2, dx, dy);
            x += weights[m] * (coefficient(table, poisson, 0, dx, dy) * qx + xy * qy);
            y += weights[m] * (xy * qx + coefficient(table, poisson, 1, dx, dy) * qy);
          }
        }
      }
      largest = std::max({largest, std::abs(x), std::abs(y)});
      worst = std::max({worst, std::abs(x - out[row * pitch + column]),
                        std::abs(y - out[count + row * pitch + column])});
    }
  }
  SCOPED_TRACE(testing::Message() << shape.rows << " x " << shape.columns);
  EXPECT_LE(worst, 40.0 * std::numeric_limits<Real>::epsilon() * largest);
}

TEST(TractionConvolution, IsTheSumOverAllPairs) {
  for (const TractionShape shape : {TractionShape{1, 1}, TractionShape{1, 7}, TractionShape{9, 1},
                                    TractionShape{16, 8}, TractionShape{30, 26}}) {
    expect_dense_sum<float>(shape, {0.0, 1.0, 0.0, 0.0});
    expect_dense_sum<double>(shape, {0.08, 1.16, -1.56, 0.32});
    expect_dense_sum<float>(shape, {0.08, 1.16, -1.56, 0.32});
  }
}

} // namespace
} // namespace wrc::test::traction_convolution_test
