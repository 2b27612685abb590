/// Closed formulas of creep forces: their limits, their bounds and their signs.
#include "rolling/creep_laws.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace wrc::test::creep_laws_test {
namespace {

const RollingEllipse ellipse{6.0, 4.0, 80000.0, 0.3, 82000.0, 0.28};
const double whole = ellipse.friction * ellipse.load;

KalkerCoefficients kalker() {
  return kalker_coefficients(ellipse);
}

using Law = CreepForces (*)(const RollingEllipse&, const KalkerCoefficients&, const Creepages&);
constexpr Law polach = [](const RollingEllipse& on, const KalkerCoefficients& coefficients,
                          const Creepages& creepages) {
  return polach_forces(on, coefficients, creepages);
};

/// Forces without friction's limit, written out.
CreepForces by_hand(const Creepages& w) {
  const double square = 24.0;
  const double c = std::sqrt(square);
  const KalkerCoefficients k = kalker();
  return {-82000.0 * square * k.c11 * w.longitudinal,
          -82000.0 * square * (k.c22 * w.lateral + k.c23 * c * w.spin),
          82000.0 * square * c * (k.c23 * w.lateral - k.c33 * c * w.spin)};
}

TEST(CreepLaws, LinearForces) {
  const Creepages w{1e-4, -2e-4, 3e-5};
  const CreepForces linear = linear_forces(ellipse, kalker(), w);
  const CreepForces expected = by_hand(w);
  EXPECT_DOUBLE_EQ(linear.longitudinal, expected.longitudinal);
  EXPECT_NEAR(linear.lateral, expected.lateral, 1e-9 * std::abs(expected.lateral));
  EXPECT_NEAR(linear.spin_moment, expected.spin_moment, 1e-9 * std::abs(expected.spin_moment));
}

// The linear law is the tangent of all. (Of Polach's not where xi and phi come together: his spin
// gradient has the lateral slip only.)
TEST(CreepLaws, SmallCreepagesAreLinear) {
  constexpr double small = 1e-8;
  for (const Creepages& w : {Creepages{small, 0.0, 0.0}, Creepages{0.0, small, 0.0},
                             Creepages{0.0, 0.0, small}, Creepages{small, 0.0, small}}) {
    const CreepForces linear = linear_forces(ellipse, kalker(), w);
    for (const Law law : {Law(shen_hedrick_elkins_forces), polach}) {
      if (law == polach && w.longitudinal != 0.0 && w.spin != 0.0) {
        continue;
      }
      const CreepForces forces = law(ellipse, kalker(), w);
      const double size = std::hypot(linear.longitudinal, linear.lateral);
      EXPECT_NEAR(forces.longitudinal, linear.longitudinal, 1e-4 * size);
      EXPECT_NEAR(forces.lateral, linear.lateral, 1e-4 * size);
    }
  }
}

TEST(CreepLaws, LargeCreepageTransmitsTheFriction) {
  const Creepages w{0.3, -0.4, 0.0};
  for (const Law law : {Law(shen_hedrick_elkins_forces), polach}) {
    const CreepForces forces = law(ellipse, kalker(), w);
    EXPECT_NEAR(std::hypot(forces.longitudinal, forces.lateral), whole, 1e-3 * whole);
    EXPECT_LT(forces.longitudinal, 0.0);
    EXPECT_GT(forces.lateral, 0.0);
  }
}

// Vermeulen & Johnson's cubic: without kink where all slips, never above the friction.
TEST(CreepLaws, TheCubicEndsSmoothly) {
  const double full = 3.0 * whole / (82000.0 * 24.0 * kalker().c11);
  const auto force = [&](double share) {
    return -shen_hedrick_elkins_forces(ellipse, kalker(), {share * full, 0.0, 0.0}).longitudinal /
           whole;
  };
  EXPECT_DOUBLE_EQ(force(1.0), 1.0);
  EXPECT_NEAR(force(0.5), 1.5 - 0.75 + 0.125, 1e-12);
  constexpr double step = 1e-4;
  EXPECT_NEAR((force(1.0) - force(1.0 - step)) / step, 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(force(7.0), 1.0);
}

// Polach's force along one axis, written out.
TEST(CreepLaws, PolachWithoutSpin) {
  const double xi = -2e-3;
  const PolachReduction wet{0.6, 0.2};
  const double e = 82000.0 * std::numbers::pi * 24.0 * kalker().c11 * 2e-3 / (4.0 * whole);
  const double expected =
      2.0 * whole / std::numbers::pi * (0.6 * e / (1.0 + 0.36 * e * e) + std::atan(0.2 * e));
  const CreepForces forces = polach_forces(ellipse, kalker(), {xi, 0.0, 0.0}, wet);
  EXPECT_NEAR(forces.longitudinal, expected, 1e-9 * whole);
  EXPECT_EQ(forces.lateral, 0.0);
}

// Pure spin: from the linear force to nothing, with one sign.
TEST(CreepLaws, PolachsSpinRisesAndFalls) {
  double largest = 0.0;
  double last = 0.0;
  for (double spin = 1e-6; spin < 1e2; spin *= 1.3) {
    last = -polach_forces(ellipse, kalker(), {0.0, 0.0, spin}).lateral / whole;
    EXPECT_GT(last, 0.0) << spin;
    largest = std::max(largest, last);
  }
  EXPECT_GT(largest, 0.3);
  EXPECT_LT(largest, 1.0);
  EXPECT_LT(last, 1e-3);
}

TEST(CreepLaws, MirroredCreepagesGiveMirroredForces) {
  const Creepages w{1e-3, 8e-4, 2e-4};
  const Creepages mirrored{1e-3, -8e-4, -2e-4};
  for (const Law law : {Law(linear_forces), Law(shen_hedrick_elkins_forces), polach}) {
    const CreepForces one = law(ellipse, kalker(), w);
    const CreepForces other = law(ellipse, kalker(), mirrored);
    EXPECT_DOUBLE_EQ(one.longitudinal, other.longitudinal);
    EXPECT_DOUBLE_EQ(one.lateral, -other.lateral);
    EXPECT_DOUBLE_EQ(one.spin_moment, -other.spin_moment);
  }
}

TEST(CreepLaws, NothingWithoutCreepageOrFriction) {
  RollingEllipse smooth = ellipse;
  smooth.friction = 0.0;
  for (const Law law : {Law(shen_hedrick_elkins_forces), polach}) {
    for (const auto& [on, w] :
         {std::pair{ellipse, Creepages{}}, std::pair{smooth, Creepages{1e-3, 1e-3, 1e-4}}}) {
      const CreepForces forces = law(on, kalker(), w);
      EXPECT_EQ(forces.longitudinal, 0.0);
      EXPECT_EQ(forces.lateral, 0.0);
      EXPECT_EQ(forces.spin_moment, 0.0);
    }
  }
}

TEST(CreepLaws, RefusesEllipsesOutsideTheirRanges) {
  const auto refused = [](auto change, const std::string& name) {
    RollingEllipse changed = ellipse;
    change(changed);
    try {
      check_ellipse(changed);
      ADD_FAILURE() << name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0U) << error.what();
    }
  };
  check_ellipse(ellipse);
  refused([](RollingEllipse& e) { e.longitudinal_semi_axis = 0.0; }, "longitudinal_semi_axis");
  refused([](RollingEllipse& e) { e.lateral_semi_axis = INFINITY; }, "lateral_semi_axis");
  refused([](RollingEllipse& e) { e.load = -1.0; }, "load");
  refused([](RollingEllipse& e) { e.friction = NAN; }, "friction");
  refused([](RollingEllipse& e) { e.shear_modulus = 0.0; }, "shear_modulus");
  refused([](RollingEllipse& e) { e.poisson = 0.51; }, "poisson");
}

} // namespace
} // namespace wrc::test::creep_laws_test
