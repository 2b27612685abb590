/// States of a wheel in scenes that have them, and the warning of pressures beyond steel.
#include "results/wheel_state.hpp"

#include <gtest/gtest.h>

#include "half_space/constants.hpp"
#include "results/constants.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::wheel_state_test {
namespace {

/// The left wheel at this lateral position, without roll.
Scene scene_at(double lateral) {
  Scene scene;
  scene.side = SideChoice::left;
  scene.roll = 0.0;
  scene.lateral = lateral;
  scene.accuracy = 1e-1;
  return scene;
}

int state_at(double lateral) {
  return *solve_scene(scene_at(lateral)).left->state;
}

TEST(WheelStates, ARunningWheelHasNoSpecialState) {
  for (const double lateral : {-10.0, -5.0, 0.0, 5.0, 6.5, 7.5}) {
    EXPECT_EQ(state_at(lateral), 0) << lateral;
  }
}

TEST(WheelStates, ContactOnTheFlangeTipIsDerailment) {
  for (const double lateral : {20.0, 30.0}) {
    EXPECT_EQ(state_at(lateral), on_flange_tip) << lateral;
  }
}

TEST(WheelStates, ContactOnTheChamferIsOffTheTread) {
  EXPECT_EQ(state_at(-70.0), 0);
  EXPECT_EQ(state_at(-90.0), on_chamfer);
}

TEST(WheelStates, ExceedingTheOnsetOfTheSofterBodyIsAState) {
  Scene scene = scene_at(0.0);
  const double pmax = solve_scene(scene).left->pmax;
  scene.wheel_steel.yield_stress = scene.rail_steel.yield_stress = 2.0 * pmax;
  for (Steel Scene::*const softer : {&Scene::rail_steel, &Scene::wheel_steel}) {
    const Steel before = scene.*softer;
    (scene.*softer).yield_stress = 1.01 * pmax / yield_onset;
    EXPECT_EQ(*solve_scene(scene).left->state, 0);
    (scene.*softer).yield_stress = 0.99 * pmax / yield_onset;
    EXPECT_EQ(*solve_scene(scene).left->state, beyond_yield);
    scene.*softer = before;
  }
}

TEST(WheelStates, LiftedMeansNoContactAndGeometryAloneHasNoState) {
  Scene scene = scene_at(0.0);
  scene.vertical = 470.0;
  EXPECT_EQ(*solve_scene(scene).left->state, lifted);
  scene.until = Module::geometry;
  EXPECT_FALSE(solve_scene(scene).left->state.has_value());
}

TEST(WheelWarnings, SeveralPatchesAreNumbered) {
  WheelResult wheel;
  wheel.patches.resize(1);
  EXPECT_EQ(of_patch(wheel, 0), "");
  wheel.patches.resize(2);
  EXPECT_EQ(of_patch(wheel, 1), "patch 1: ");
}

TEST(WheelWarnings, PressuresBeyondSteelAreReportedWithTheirPatch) {
  WheelResult wheel;
  wheel.details.request.combined_modulus = 115e3;
  wheel.patches.resize(2);
  wheel.patches[1].pmax = wheel.pmax = 0.999 * hardest_steel;
  warn_of_pressure(wheel);
  EXPECT_TRUE(wheel.warnings.empty());
  wheel.patches[1].pmax = wheel.pmax = 1.001 * hardest_steel;
  warn_of_pressure(wheel);
  ASSERT_EQ(wheel.warnings.size(), 1U);
  EXPECT_EQ(wheel.warnings.front().kind, WarningClass::pressure);
  EXPECT_TRUE(wheel.warnings.front().text.starts_with("patch 1: "));
  wheel.warnings.clear();
  wheel.details.request.combined_modulus = 1.001 * stiffest_steel;
  warn_of_pressure(wheel);
  EXPECT_TRUE(wheel.warnings.empty()) << "stiffer than steel";
  wheel.pmax = 1.001 * hardest_ceramic;
  warn_of_pressure(wheel);
  ASSERT_EQ(wheel.warnings.size(), 1U);
  EXPECT_NE(wheel.warnings.front().text.find("hard ceramics flow at 10000 MPa"), std::string::npos);
}

} // namespace
} // namespace wrc::test::wheel_state_test
