// The march inverts the product of its two factors exactly, as long as the quadrature does.
#include "rolling/traction_march.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::traction_march_test {
namespace {

/// Rows for which the mean of exponentials is exact: eleven terms of the series (march_terms).
constexpr std::size_t rows = 11;
constexpr std::size_t pitch = 16;
constexpr double step_over_width = 0.15;

/// Coefficients of (1 - rho E)^-1/2.
std::vector<double> root_series(double rho) {
  std::vector<double> f(rows, 1.0);
  for (std::size_t m = 1; m < rows; ++m) {
    f[m] = f[m - 1] * rho * (static_cast<double>(m) - 0.5) / static_cast<double>(m);
  }
  return f;
}

/// Of the upstream factor l(E).
std::vector<double> upstream_series(double rho, double upstream) {
  std::vector<double> l = root_series(rho);
  for (std::size_t m = rows; --m > 0;) {
    l[m] -= upstream * l[m - 1];
  }
  return l;
}

template <typename Real> class TractionMarchTest : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(TractionMarchTest, Precisions);

/// All elements stick: D (1 - rho/E)^-1/2 l(E) z = r.
TYPED_TEST(TractionMarchTest, InvertsBothFactorsInAdhesion) {
  const double rho = std::exp(-march_decay * step_over_width);
  const ElementScales scales{1.0, 1.7, 2.3, 0.0};
  constexpr std::size_t count = rows * pitch;
  for (const double upstream : {1.0, 0.3, 0.0}) {
    TractionMarch<TypeParam> march(rows, pitch, step_over_width, upstream);
    std::vector<TypeParam> fields(7 * count, TypeParam{0});
    TypeParam* v = fields.data();
    const LinearisedElements<TypeParam> elements{
        v, v + count, v + 2 * count, v + 3 * count, v + 4 * count, v + 5 * count, v + 6 * count};
    std::vector<TypeParam> r(2 * count);
    std::vector<TypeParam> z(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
      elements.inverse_xx[i] = static_cast<TypeParam>(1.0 / scales.diagonal_x);
      elements.inverse_yy[i] = static_cast<TypeParam>(1.0 / scales.diagonal_y);
      r[i] = static_cast<TypeParam>(std::sin(1.0 + 0.7 * static_cast<double>(i)));
      r[count + i] = static_cast<TypeParam>(std::cos(0.3 * static_cast<double>(i)));
    }
    march.apply(elements, scales, r.data(), z.data());
    const std::vector<double> f = root_series(rho);
    const std::vector<double> l = upstream_series(rho, upstream);
    for (std::size_t component = 0; component < 2; ++component) {
      const double diagonal = component == 0 ? scales.diagonal_x : scales.diagonal_y;
      const TypeParam* z_here = z.data() + component * count;
      for (std::size_t j = 0; j < pitch; ++j) {
        std::vector<double> up(rows, 0.0);
        for (std::size_t i = 0; i < rows; ++i) {
          for (std::size_t m = 0; m <= i; ++m) {
            up[i] += diagonal * l[m] * static_cast<double>(z_here[(i - m) * pitch + j]);
          }
        }
        for (std::size_t i = 0; i < rows; ++i) {
          double back = 0.0;
          for (std::size_t m = 0; i + m < rows; ++m) {
            back += f[m] * up[i + m];
          }
          const double tolerance = sizeof(TypeParam) == 4 ? 2e-5 : 1e-12;
          EXPECT_NEAR(back, r[component * count + i * pitch + j], tolerance)
              << upstream << ' ' << i;
        }
      }
    }
  }
}

/// The product of both factors has sum_m l_m f_m on its diagonal.
TYPED_TEST(TractionMarchTest, DiagonalIsThatOfTheProduct) {
  const double rho = std::exp(-march_decay * step_over_width);
  for (const double upstream : {1.0, 0.3, 0.0}) {
    const std::vector<double> f = root_series(rho);
    const std::vector<double> l = upstream_series(rho, upstream);
    double diagonal = 0.0;
    for (std::size_t m = 0; m < rows; ++m) {
      diagonal += l[m] * f[m];
    }
    const TractionMarch<TypeParam> march(rows, pitch, step_over_width, upstream);
    EXPECT_NEAR(march.diagonal(), march_scale / diagonal, 1e-12);
  }
}

/// Elements outside contact transmit nothing.
TYPED_TEST(TractionMarchTest, IsZeroWhereNothingMayChange) {
  constexpr std::size_t count = rows * pitch;
  TractionMarch<TypeParam> march(rows, pitch, step_over_width, 1.0);
  std::vector<TypeParam> fields(7 * count, TypeParam{0});
  TypeParam* v = fields.data();
  const LinearisedElements<TypeParam> elements{
      v, v + count, v + 2 * count, v + 3 * count, v + 4 * count, v + 5 * count, v + 6 * count};
  elements.inverse_xx[3 * pitch + 2] = TypeParam{1};
  const std::vector<TypeParam> r(2 * count, TypeParam{1});
  std::vector<TypeParam> z(2 * count);
  march.apply(elements, {}, r.data(), z.data());
  for (std::size_t i = 0; i < 2 * count; ++i) {
    EXPECT_EQ(z[i] != TypeParam{0}, i == 3 * pitch + 2) << i;
  }
}

} // namespace
} // namespace wrc::test::traction_march_test
