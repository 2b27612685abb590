// Indices of rolling contact fatigue at textbook points and by hand.
#include "damage/fatigue.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace fatigue_test {
namespace {

using namespace wrc;

constexpr double map_tolerance = 0.01; // of p0/k: step of the scan

TEST(Fatigue, LimitsOfTheShakedownMapAreThoseOfTheTextbook) {
  // Johnson 1985, 4.2 and 9.1: line contact, von Mises, nu = 0.3.
  const ShakedownLimits frictionless = shakedown_limits(0.0);
  EXPECT_NEAR(frictionless.shakedown, 4.0, map_tolerance);
  EXPECT_NEAR(frictionless.elastic, 3.1, 0.1);
  // Below the surface up to a friction of 0.367, on it beyond.
  EXPECT_LT(shakedown_limits(0.36).shakedown, 1.0 / 0.36 - map_tolerance);
  for (const double friction : {0.37, 0.5, 1.0}) {
    EXPECT_NEAR(shakedown_limits(friction).shakedown, 1.0 / friction, map_tolerance);
  }
  double before = frictionless.shakedown;
  for (double friction = 0.05; friction < 1.0; friction += 0.05) {
    const ShakedownLimits limits = shakedown_limits(friction);
    EXPECT_LT(limits.shakedown, before);
    EXPECT_LE(limits.elastic, limits.shakedown + map_tolerance);
    before = limits.shakedown;
  }
  EXPECT_THROW(shakedown_limits(-0.1), Error);
}

TEST(Fatigue, SurfaceIndexByHand) {
  // f = 0.35, p0 = 1200 MPa, k = 300 MPa: 0.35 - 0.25.
  EXPECT_DOUBLE_EQ(surface_fatigue_index(0.35, 1200.0, 300.0), 0.35 - 0.25);
  EXPECT_LT(surface_fatigue_index(0.1, 1200.0, 300.0), 0.0);
  EXPECT_EQ(surface_fatigue_index(0.3, 0.0, 300.0), 0.0);
}

TEST(Fatigue, DamageOfTheWholeLifeRailModelByHand) {
  EXPECT_EQ(rail_damage(0.0), 0.0);
  EXPECT_EQ(rail_damage(15.0), 0.0);
  EXPECT_DOUBLE_EQ(rail_damage(40.0), 0.5e-5); // half of the way to 65 N
  EXPECT_DOUBLE_EQ(rail_damage(65.0), 1e-5);
  EXPECT_DOUBLE_EQ(rail_damage(120.0), 0.5e-5);
  EXPECT_NEAR(rail_damage(175.0), 0.0, 1e-20);
  EXPECT_DOUBLE_EQ(rail_damage(285.0), -1e-5); // wear beyond, on the same line
}

} // namespace
} // namespace fatigue_test
