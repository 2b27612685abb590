// Rates of creep forces: moved grids, transfers between places, mirror images, and the derivatives
// by load and friction of laws in closed form.
#include "creep/creep_rates.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "creep/creep_forces.hpp"
#include "creep/rolling_frame.hpp"

namespace wrc::test::creep_rates_test {
namespace {

constexpr double friction = 0.3;
constexpr double normal_force = 8e4;

/// Any full matrix.
CreepDerivatives some_derivatives() {
  CreepDerivatives derivatives;
  for (std::size_t i = 0; i < 9; ++i) {
    derivatives.by_creepage[i] = 1.0 + std::sin(1.0 + 2.0 * static_cast<double>(i));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    derivatives.by_load[i] = 0.2 + 0.1 * static_cast<double>(i);
    derivatives.by_friction[i] = -3.0 + static_cast<double>(i);
  }
  return derivatives;
}

/// All slides: F = -mu N w/|w| without spin. Both derivatives are F over the factor.
TEST(CreepRates, ForcesOfFullSlidingGrowWithLoadAndFriction) {
  const Creepages at{0.03, -0.04, 0.0};
  const double whole = friction * normal_force;
  const CreepForces forces{-0.6 * whole, 0.8 * whole, 0.0};
  CreepDerivatives derivatives;
  // d(w/|w|) = (1 - n n^t)/|w|.
  derivatives.by_creepage = {-whole * 0.64 / 0.05,
                             -whole * 0.48 / 0.05,
                             0.0,
                             -whole * 0.48 / 0.05,
                             -whole * 0.36 / 0.05,
                             0.0,
                             0.0,
                             0.0,
                             0.0};
  complete(derivatives, forces, at, friction, normal_force);
  EXPECT_NEAR(derivatives.by_load[0], forces.longitudinal / normal_force, 1e-12);
  EXPECT_NEAR(derivatives.by_load[1], forces.lateral / normal_force, 1e-12);
  EXPECT_NEAR(derivatives.by_friction[0], forces.longitudinal / friction, 1e-7);
  EXPECT_NEAR(derivatives.by_friction[1], forces.lateral / friction, 1e-7);
}

/// Kalker's linear law, -G a b C w: a b grows with N^(2/3), friction does nothing.
TEST(CreepRates, LinearForcesGrowWithTheContactAlone) {
  const Creepages at{1e-4, 2e-4, 0.0};
  CreepDerivatives derivatives;
  derivatives.by_creepage = {-5e7, 0.0, 0.0, 0.0, -4e7, 0.0, 0.0, 0.0, 0.0};
  const CreepForces forces{-5e7 * at.longitudinal, -4e7 * at.lateral, 0.0};
  complete(derivatives, forces, at, friction, normal_force);
  EXPECT_NEAR(derivatives.by_load[0], 2.0 / 3.0 * forces.longitudinal / normal_force, 1e-12);
  EXPECT_NEAR(derivatives.by_load[1], 2.0 / 3.0 * forces.lateral / normal_force, 1e-12);
  EXPECT_NEAR(derivatives.by_friction[0], 0.0, 1e-9);
  EXPECT_NEAR(derivatives.by_friction[1], 0.0, 1e-9);
}

/// In the mirror lateral forces and creepages, spin and the spin moment change their signs: F' = S
/// F, w' = S w with S = diag(1, m, m).
TEST(CreepRates, MirroredDerivativesAreThoseOfMirroredForces) {
  const CreepDerivatives before = some_derivatives();
  const RollingFrame right(-1.0);
  const CreepDerivatives after = right.mirrored(before);
  constexpr std::array<double, 3> sign{1.0, -1.0, -1.0};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      EXPECT_EQ(after.by_creepage[3 * row + column],
                sign[row] * sign[column] * before.by_creepage[3 * row + column]);
    }
    EXPECT_EQ(after.by_load[row], sign[row] * before.by_load[row]);
    EXPECT_EQ(after.by_friction[row], sign[row] * before.by_friction[row]);
  }
  EXPECT_EQ(right.mirrored(after).by_creepage, before.by_creepage);
}

/// The power F.w is the same at both places: C' = T^t C T, by its quadratic form.
TEST(CreepRates, DerivativesOfAPartKeepItsPower) {
  constexpr double x = 3.0;
  constexpr double y = -7.0;
  const CreepDerivatives part = some_derivatives();
  CreepDerivatives whole;
  add_derivatives(whole, part, 0.25, x, y);
  const auto power = [](const CreepDerivatives& c, const std::array<double, 3>& w) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        sum += w[i] * c.by_creepage[3 * i + j] * w[j];
      }
    }
    return sum;
  };
  for (const auto& w : {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0},
                        std::array{0.0, 0.0, 1.0}, std::array{0.4, -1.1, 0.7}}) {
    const std::array<double, 3> there{w[0] - w[2] * y, w[1] + w[2] * x, w[2]};
    EXPECT_NEAR(power(whole, w), power(part, there), 1e-10);
  }
  EXPECT_NEAR(whole.by_load[0], 0.25 * part.by_load[0], 1e-15);
  EXPECT_NEAR(whole.by_load[2],
              0.25 * (part.by_load[2] + x * part.by_load[1] - y * part.by_load[0]), 1e-12);
  EXPECT_NEAR(whole.by_friction[1], part.by_friction[1], 1e-15) << "friction is not shared out";
  add_derivatives(whole, part, 0.25, x, y);
  EXPECT_NEAR(power(whole, {1.0, 0.0, 0.0}), 2.0 * power(part, {1.0, 0.0, 0.0}), 1e-12);
}

TEST(CreepRates, ElementsMoveWithTheirGrid) {
  const Grid grid{10, 20, 0.5, 0.25, -2.0, -3.0};
  ElementMotion motion;
  motion.along = 0.1;
  motion.across = -0.2;
  motion.longitudinal_growth = 0.03;
  motion.lateral_growth = -0.01;
  const Grid moved = moved_grid(grid, motion);
  for (const std::size_t i : {0U, 7U, 9U}) {
    EXPECT_NEAR(moved.longitudinal(i), 1.03 * grid.longitudinal(i) + 0.1, 1e-14);
    EXPECT_NEAR(moved.lateral(i), 0.99 * grid.lateral(i) - 0.2, 1e-14);
  }
  EXPECT_EQ(moved.lateral_count, grid.lateral_count);
}

TEST(CreepRates, RatesBetweenProblemsAreDifferencesOverTheStep) {
  const std::vector<double> pressure{100.0, 200.0, 0.0, 50.0};
  RollingProblem now;
  now.grid = {2, 2, 0.5, 0.25, -2.0, -3.0};
  now.pressure = pressure;
  Grid grid = now.grid;
  grid.lateral_step += 0.002;
  grid.longitudinal_first -= 0.03;
  ProblemFields later;
  later.pressure = {101.0, 198.0, 0.0, 50.5};
  const ProblemRate rate = rate_between(now, grid, later, 0.5);
  EXPECT_NEAR(rate.lateral_step, 0.004, 1e-15);
  EXPECT_NEAR(rate.longitudinal_first, -0.06, 1e-15);
  EXPECT_EQ(rate.longitudinal_step, 0.0);
  const std::vector<double> expected{2.0, -4.0, 0.0, 1.0};
  EXPECT_EQ(rate.pressure, expected);
  EXPECT_TRUE(rate.slip_x.empty());
}

TEST(CreepRates, DifferencesAreOverTheWayBetweenBothMoves) {
  ByMotion<PatchMove> moves;
  for (std::size_t i = 0; i < position_count; ++i) {
    moves[i].ahead.normal_force = 1.0 + static_cast<double>(i);
    moves[i].behind.normal_force = -1.0;
    moves[i].apart = 0.5;
  }
  const ForcesByPosition by = differences_of(moves, [](const MovedPatch& patch) {
    return CreepForces{2.0 * patch.normal_force, -patch.normal_force, 5.0};
  });
  for (std::size_t i = 0; i < position_count; ++i) {
    const double apart = 2.0 + static_cast<double>(i);
    EXPECT_NEAR(by[i], 2.0 * apart / 0.5, 1e-12);
    EXPECT_NEAR(by[position_count + i], -apart / 0.5, 1e-12);
    EXPECT_EQ(by[2 * position_count + i], 0.0);
  }
}

} // namespace
} // namespace wrc::test::creep_rates_test
