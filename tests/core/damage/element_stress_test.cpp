// Stresses of one element against those of point loads, and what is made of a tensor.
#include "damage/element_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::element_stress_test {
namespace {

/// Under unit pressure or traction (`load`: p, q_x, q_y) on an element of a x b about the origin.
Stress stress_of(std::size_t load, double a, double b, double x, double y, double z, double nu) {
  // Corners at the offsets of the point from the element's edges; inner minus outer ones.
  constexpr std::size_t pitch = 2;
  std::vector<double> near(stress_kernels * pitch);
  std::vector<double> far(stress_kernels * pitch);
  stress_corners(x - 0.5 * a, a, 2, y + 0.5 * b, z, nu, true, near.data(), pitch);
  stress_corners(x - 0.5 * a, a, 2, y - 0.5 * b, z, nu, true, far.data(), pitch);
  Stress stress{};
  for (std::size_t c = 0; c < stress.size(); ++c) {
    const std::size_t k = kernel_of[load][c] * pitch;
    stress[c] = near[k + 1] - near[k] - far[k + 1] + far[k];
  }
  return stress;
}

/// Under a unit normal force, tension positive (Johnson, Contact Mechanics, 1985, eqs. 3.20).
Stress boussinesq(double x, double y, double z, double nu) {
  const double r2 = x * x + y * y;
  const double rho = std::sqrt(r2 + z * z);
  const double rest = 1.0 - 2.0 * nu;
  const double scale = 0.5 * std::numbers::inv_pi;
  const double rho3 = rho * rho * rho;
  const double rho5 = rho3 * rho * rho;
  const double one = (1.0 - z / rho) / r2;
  Stress s{};
  s[xx] = scale *
          (rest * (one * (x * x - y * y) / r2 + z * y * y / (rho3 * r2)) - 3.0 * z * x * x / rho5);
  s[yy] = scale *
          (rest * (one * (y * y - x * x) / r2 + z * x * x / (rho3 * r2)) - 3.0 * z * y * y / rho5);
  s[zz] = -scale * 3.0 * z * z * z / rho5;
  // In the plane cos 2t of xx goes with sin 2t here: twice what is printed there.
  s[xy] =
      scale * (rest * (2.0 * one * x * y / r2 - z * x * y / (rho3 * r2)) - 3.0 * x * y * z / rho5);
  s[xz] = -scale * 3.0 * x * z * z / rho5;
  s[yz] = -scale * 3.0 * y * z * z / rho5;
  return s;
}

double largest(const Stress& stress) {
  double most = 0.0;
  for (const double value : stress) {
    most = std::max(most, std::abs(value));
  }
  return most;
}

/// A small element acts as a point load: the error falls with the square of size over distance.
TEST(ElementStress, OfASmallPressedElementIsThatOfAPointLoad) {
  constexpr double a = 0.02;
  constexpr double b = 0.03;
  for (const double nu : {0.0, 0.28, 0.5}) {
    for (const auto& [x, y, z] : {std::array{0.7, 0.4, 0.9}, std::array{-1.1, 0.3, 0.5},
                                  std::array{0.2, -0.8, 1.4}, std::array{-0.6, -0.9, 0.7}}) {
      const Stress exact = boussinesq(x, y, z, nu);
      const Stress found = stress_of(0, a, b, x, y, z, nu);
      for (std::size_t c = 0; c < exact.size(); ++c) {
        EXPECT_NEAR(found[c] / (a * b), exact[c], 2e-3 * largest(exact)) << c << ' ' << nu;
      }
    }
  }
}

/// The body's equilibrium, of each load: div sigma = 0, by central differences.
TEST(ElementStress, IsInEquilibrium) {
  constexpr double h = 1e-4;
  constexpr std::array<std::array<StressComponent, 3>, 3> row{
      {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
  const auto at = [](std::size_t load, double x, double y, double z) {
    return stress_of(load, 1.0, 0.6, x, y, z, 0.28);
  };
  for (std::size_t load = 0; load < 3; ++load) {
    const double x = 0.35;
    const double y = 0.45;
    const double z = 0.5;
    const std::array<std::array<Stress, 2>, 3> shifted{
        {{at(load, x - h, y, z), at(load, x + h, y, z)},
         {at(load, x, y - h, z), at(load, x, y + h, z)},
         {at(load, x, y, z - h), at(load, x, y, z + h)}}};
    for (const auto& components : row) {
      double divergence = 0.0;
      double size = 0.0;
      for (std::size_t d = 0; d < 3; ++d) {
        const StressComponent c = components[d];
        const double rate = (shifted[d][1][c] - shifted[d][0][c]) / (2.0 * h);
        divergence += rate;
        size += std::abs(rate);
      }
      ASSERT_GT(size, 0.05);
      EXPECT_NEAR(divergence, 0.0, 1e-6 * size) << load;
    }
  }
}

/// Just below the middle of an element the surface carries the load itself.
TEST(ElementStress, MeetsTheLoadAtTheSurface) {
  constexpr double z = 1e-6;
  EXPECT_NEAR(stress_of(0, 1.0, 0.6, 0.1, 0.05, z, 0.28)[zz], -1.0, 1e-5);
  EXPECT_NEAR(std::abs(stress_of(1, 1.0, 0.6, 0.1, 0.05, z, 0.28)[xz]), 1.0, 1e-5);
  EXPECT_NEAR(std::abs(stress_of(2, 1.0, 0.6, 0.1, 0.05, z, 0.28)[yz]), 1.0, 1e-5);
  EXPECT_NEAR(stress_of(0, 1.0, 0.6, 0.9, 0.05, z, 0.28)[zz], 0.0, 1e-5);
}

TEST(ElementStress, IsTheSameInSinglePrecision) {
  constexpr std::size_t count = 21;
  std::vector<float> single(stress_kernels * count);
  std::vector<double> exact(stress_kernels * count);
  stress_corners(-2.5F, 0.25F, count, 0.75F, 0.5F, 0.28F, true, single.data(), count);
  stress_corners(-2.5, 0.25, count, 0.75, 0.5, 0.28, true, exact.data(), count);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(single[i], exact[i], 2e-6) << i;
  }
}

TEST(ElementStress, ComparisonStressesOfSimpleStates) {
  EXPECT_DOUBLE_EQ(von_mises({-3.0, 0.0, 0.0, 0.0, 0.0, 0.0}), 3.0);
  EXPECT_DOUBLE_EQ(von_mises({0.0, 0.0, 0.0, 0.0, 2.0, 0.0}), 2.0 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(von_mises({-5.0, -5.0, -5.0, 0.0, 0.0, 0.0}), 0.0);
  EXPECT_NEAR(greatest_shear({0.0, 0.0, 0.0, 0.0, 2.0, 0.0}), 2.0, 1e-12);
  EXPECT_NEAR(greatest_shear({-3.0, 0.0, 0.0, 0.0, 0.0, 0.0}), 1.5, 1e-12);
  EXPECT_EQ(greatest_shear({-5.0, -5.0, -5.0, 0.0, 0.0, 0.0}), 0.0);
}

/// Principal stresses have the tensor's three invariants.
TEST(ElementStress, PrincipalStressesKeepTheInvariants) {
  for (const Stress& s :
       {Stress{-900.0, -300.0, -1200.0, 40.0, 210.0, -90.0}, Stress{1.0, 2.0, 3.0, 4.0, 5.0, 6.0},
        Stress{0.0, 0.0, 0.0, -1.0, 0.5, 0.25}}) {
    const auto [first, second, third] = principal_stresses(s);
    const double size = largest(s);
    EXPECT_GE(first, second);
    EXPECT_GE(second, third);
    EXPECT_NEAR(first + second + third, s[xx] + s[yy] + s[zz], 1e-12 * size);
    EXPECT_NEAR(first * second + second * third + third * first,
                s[xx] * s[yy] + s[yy] * s[zz] + s[zz] * s[xx] - s[xy] * s[xy] - s[xz] * s[xz] -
                    s[yz] * s[yz],
                1e-12 * size * size);
    const double determinant = s[xx] * (s[yy] * s[zz] - s[yz] * s[yz]) -
                               s[xy] * (s[xy] * s[zz] - s[yz] * s[xz]) +
                               s[xz] * (s[xy] * s[yz] - s[yy] * s[xz]);
    EXPECT_NEAR(first * second * third, determinant, 1e-11 * size * size * size);
  }
}

} // namespace
} // namespace wrc::test::element_stress_test
