/// The coefficient of friction by place and by the speed of slip, against its formula.
#include "creep/friction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/value_with_rates.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::friction_test {
namespace {

TEST(Friction, IsLinearBetweenPositionsAndConstantBeyond) {
  const FrictionLaw law{.coefficient = 0.5, .places = {{-30.0, 0.1}, {-10.0, 0.3}, {20.0, 0.36}}};
  EXPECT_EQ(friction_of(law, -50.0, 0.0), 0.1);
  EXPECT_EQ(friction_of(law, -30.0, 0.0), 0.1);
  EXPECT_DOUBLE_EQ(friction_of(law, -20.0, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(friction_of(law, -10.0, 0.0), 0.3);
  EXPECT_DOUBLE_EQ(friction_of(law, 5.0, 0.0), 0.33);
  EXPECT_EQ(friction_of(law, 60.0, 0.0), 0.36);
  EXPECT_EQ(greatest_friction(law), 0.36);
  EXPECT_EQ(friction_of(FrictionLaw{.coefficient = 0.5}, 3.0, 1e9), 0.5);
}

TEST(Friction, FallsWithTheSpeedOfSlipToItsLimit) {
  const FrictionLaw law{.coefficient = 0.4, .limit_ratio = 0.25, .decay = 6e-4};
  EXPECT_EQ(friction_of(law, 0.0, 0.0), 0.4);
  EXPECT_DOUBLE_EQ(friction_of(law, 0.0, 1000.0), 0.4 * (0.75 * std::exp(-0.6) + 0.25));
  EXPECT_DOUBLE_EQ(friction_of(law, 0.0, 1e9), 0.1);
}

TEST(Friction, HasTheDerivativesOfItsFormula) {
  using Rated = WithRates<2>;
  const FrictionLaw law{.places = {{-30.0, 0.1}, {-10.0, 0.3}}, .limit_ratio = 0.25, .decay = 6e-4};
  const Rated rated = friction_of(law, Rated::variable(-16.0, 0), Rated::variable(1000.0, 1));
  const double share = 0.75 * std::exp(-0.6) + 0.25;
  EXPECT_DOUBLE_EQ(rated.value, 0.24 * share);
  EXPECT_DOUBLE_EQ(rated.rates[0], 0.01 * share);
  EXPECT_DOUBLE_EQ(rated.rates[1], -0.24 * 0.75 * 6e-4 * std::exp(-0.6));
}

// Two patches of a wheel, on tread and flange, with the coefficients of their places.
TEST(Friction, OfAPatchIsTakenAtItsReference) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "56E1";
  scene.lateral = 6.15;
  scene.side = SideChoice::left;
  scene.accuracy = 1e-2;
  scene.left.friction.places = {{-25.0, 0.1}, {-10.0, 0.4}};
  scene.motion = Motion{.speed = 2e4, .pitch = 0.0};
  scene.creep = CreepModel::polach;
  const SceneResult result = solve_scene(scene);
  ASSERT_EQ(result.left->patches.size(), 2U);
  for (const PatchResult& patch : result.left->patches) {
    const double friction = friction_of(scene.left.friction, patch.reference.s_wheel, 0.0);
    EXPECT_EQ(patch.creep->friction, friction);
    // Blocked, it slides.
    EXPECT_NEAR(std::hypot(patch.creep->longitudinal_force, patch.creep->lateral_force) /
                    (friction * patch.normal_force),
                1.0, 0.02);
  }
  EXPECT_GT(
      std::abs(result.left->patches[0].creep->friction - result.left->patches[1].creep->friction),
      0.1);
}

} // namespace
} // namespace wrc::test::friction_test
