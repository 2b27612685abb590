/// What a wheel computes when it is first read, and keeps.
#include "scene/scene_wheel.hpp"

#include <gtest/gtest.h>

#include "scene/solve_scene.hpp"

namespace wrc::test::scene_wheel_test {
namespace {

SceneWheel solved_wheel() {
  Scene scene;
  scene.grid = {{24, 20}};
  scene.tolerance = 1e-6;
  scene.side = SideChoice::left;
  return *solve_scene(scene).left;
}

TEST(SceneWheel, ResidualsAreComputedOnce) {
  SceneWheel wheel = solved_wheel();
  const Residuals& residuals = wheel.residuals();
  EXPECT_GT(residuals.complementarity, 0.0);
  EXPECT_LT(residuals.complementarity, 1e-5);
  const double load_balance = residuals.load_balance;
  wheel.patches.front().force = {};
  EXPECT_EQ(wheel.residuals().load_balance, load_balance);
}

TEST(SceneWheel, DerivativesAreComputedOnce) {
  SceneWheel wheel = solved_wheel();
  const WheelRates* rates = wheel.sensitivities();
  ASSERT_NE(rates, nullptr);
  const double stiffness = rates->force.vertical.force.z;
  EXPECT_LT(stiffness, 0.0);
  wheel.patches.clear();
  EXPECT_EQ(wheel.sensitivities(), rates);
  ASSERT_NE(wheel.jacobian(), nullptr);
  EXPECT_EQ((*wheel.jacobian())[2][1], stiffness);
}

TEST(SceneWheel, LobesOfAPatchAreFoundOnce) {
  SceneWheel wheel = solved_wheel();
  const std::vector<PressureLobe> found = pressure_lobes(wheel.patches.front(), wheel.details);
  ASSERT_FALSE(found.empty());
  const std::vector<PressureLobe>& lobes = wheel.lobes(0, {});
  ASSERT_EQ(lobes.size(), found.size());
  EXPECT_EQ(lobes.front().centroid.y, found.front().centroid.y);
  wheel.patches.front().pressure.clear();
  EXPECT_EQ(&wheel.lobes(0, {}), &lobes);
  EXPECT_EQ(lobes.size(), found.size());
}

TEST(SceneWheel, ComputesAgainForANewResult) {
  SceneWheel wheel = solved_wheel();
  ASSERT_NE(wheel.sensitivities(), nullptr);
  wheel = SceneWheel(WheelResult(wheel));
  wheel.patches.clear();
  EXPECT_EQ(wheel.sensitivities(), nullptr);
}

} // namespace
} // namespace wrc::test::scene_wheel_test
