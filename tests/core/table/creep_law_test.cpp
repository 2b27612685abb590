#include "table/creep_law.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rolling/creep_laws.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {
namespace {

constexpr double poisson = 0.28;

const CreepLaw& law() {
  static const CreepLaw made = CreepLaw::make(poisson, {}, 2, {});
  return made;
}

/// Rounding of the spline, whose nodes are mirror images.
constexpr double law_rounding = 1e-5;

TEST(CreepLaw, IsLinearForSmallCreepages) {
  constexpr double small = 0.01;
  for (const double ratio : {-1.0, 0.0, 0.7}) {
    // The cubic's own curvature, 0.3 % here, and what the spline leaves of the law's.
    constexpr double tolerance = 0.01 * small;
    EXPECT_NEAR(law().forces(small, 0.0, 0.0, ratio)[0], -small, tolerance);
    EXPECT_NEAR(law().forces(0.0, small, 0.0, ratio)[1], -small, tolerance);
    // The kink of forces by spin alone is another than the cubic's.
    constexpr double of_spin = 0.07 * small;
    EXPECT_NEAR(law().forces(0.0, 0.0, small, ratio)[1], -small, of_spin);
  }
}

TEST(CreepLaw, SlidesAtLargeCreepagesAgainstThem) {
  const auto along = law().forces(1e6, 0.0, 0.1, 0.0);
  EXPECT_NEAR(along[0], -1.0, 1e-3);
  EXPECT_NEAR(along[1], 0.0, 1e-3);
  const auto across = law().forces(0.0, -1e6, 0.1, 0.0);
  EXPECT_NEAR(across[1], 1.0, 1e-3);
}

TEST(CreepLaw, TurnsItsForcesWithTheSigns) {
  const auto f = law().forces(0.8, 0.5, 0.3, 0.2);
  const auto mirrored = law().forces(-0.8, 0.5, 0.3, 0.2);
  const auto turned = law().forces(0.8, -0.5, -0.3, 0.2);
  EXPECT_NEAR(mirrored[0], -f[0], law_rounding);
  EXPECT_NEAR(mirrored[1], f[1], law_rounding);
  EXPECT_NEAR(turned[0], f[0], law_rounding);
  EXPECT_NEAR(turned[1], -f[1], law_rounding);
  EXPECT_NEAR(turned[2], -f[2], law_rounding);
}

/// Between nodes, against a solution of its own on a finer grid with Kalker's coefficients.
TEST(CreepLaw, MeetsTheFullTheory) {
  constexpr std::size_t elements = 48;
  constexpr double ratio = 1.7;
  const double a = std::sqrt(ratio);
  const double b = 1.0 / a;
  RollingProblem problem;
  problem.grid = {elements,
                  elements,
                  2.0 * b / elements,
                  2.0 * a / elements,
                  b * (1.0 / elements - 1.0),
                  a * (1.0 / elements - 1.0)};
  std::vector<double> pressure;
  for (std::size_t row = 0; row < elements; ++row) {
    for (std::size_t i = 0; i < elements; ++i) {
      const double x = problem.grid.longitudinal(i) / a;
      const double y = problem.grid.lateral(row) / b;
      pressure.push_back(1.5 / std::numbers::pi * std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  problem.pressure = pressure;
  problem.friction = 1.0;
  problem.shear_modulus = 1.0;
  problem.poisson = poisson;
  const KalkerCoefficients kalker = kalker_coefficients(ratio, poisson);
  RollingSolver solver;
  for (const std::array<double, 3>& linear :
       {std::array{0.5, 0.3, 0.2}, {1.2, -0.7, 0.6}, {0.1, 2.5, -0.4}, {0.2, 0.1, 2.0}}) {
    problem.creepages = {linear[0] / kalker.c11, linear[1] / kalker.c22, linear[2] / kalker.c23};
    const RollingSolution exact = solver.solve(problem);
    const auto f = law().forces(linear[0], linear[1], linear[2], std::log(ratio));
    // 1 % of mu N from each: spline, grid, coefficients
    constexpr double tolerance = 0.02;
    EXPECT_NEAR(f[0], exact.longitudinal_force, tolerance);
    EXPECT_NEAR(f[1], exact.lateral_force, tolerance);
    EXPECT_NEAR(f[2], exact.spin_moment, tolerance);
  }
}

} // namespace
} // namespace wrc
