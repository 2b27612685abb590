/// Scenes with lists of slices at their limits: ends of flats and of parts, gaps, what is refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "creep/rolling_frame.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/solve_scene.hpp"
#include "scene/varying_lists.hpp"
#include "scene/vehicle_step.hpp"
#include "support/errors.hpp"

namespace wrc::test::varying_limits_test {
namespace {

/// p^2 bends within an element of the edge there, which a number of elements for ellipses misses.
TEST_F(VaryingScene, CreepForcesAtTheEndsOfAFlatStateTheirError) {
  Scene scene = scene_on("60E1", wheel_with_chord());
  scene.side = SideChoice::left;
  SceneSolver solver;
  const auto forces_at = [&](double accuracy) {
    scene.accuracy = accuracy;
    SceneResult result = solver.solve(scene);
    const auto value = [&](const char* name) { return *number_value(result, name); };
    return std::array{value("left.patches.0.creep_force.longitudinal"),
                      value("left.patches.0.creep_force.lateral"),
                      value("left.patches.0.normal_force"),
                      value("left.patches.0.creep_error_estimate")};
  };
  double worst = 0.0;
  for (const double pitch : {0.01, 0.02, 0.03, 0.04}) {
    scene.pitch = pitch;
    const auto truth = forces_at(5e-4);
    const auto found = forces_at(1e-2);
    const double error = std::hypot(found[0] - truth[0], found[1] - truth[1]) / (0.3 * truth[2]);
    EXPECT_LE(error, found[3]) << pitch;
    worst = std::max(worst, error);
  }
  EXPECT_LT(worst, 1e-2); // 0.06 without elements for gaps that bend
}

/// A crest along the rail, for which a second grid has more columns; without them pmax is 5.2 % too
/// large.
TEST_F(VaryingScene, TheLargestPressureAtTheEndsOfAFlatMeetsTheAccuracy) {
  Scene scene = scene_on("60E1", wheel_with_chord());
  scene.side = SideChoice::left;
  scene.accuracy_of = AccuracyOf::pressures;
  scene.motion.reset();
  scene.pitch = 0.01;
  SceneSolver solver;
  const auto pmax_at = [&](double accuracy) {
    scene.accuracy = accuracy;
    SceneResult result = solver.solve(scene);
    return *number_value(result, "left.pmax");
  };
  const double truth = pmax_at(1e-3);
  EXPECT_NEAR(pmax_at(1e-2), truth, 1e-2 * truth);
}

TEST_F(VaryingScene, RefusesPlacesWithoutARail) {
  Scene scene = scene_on(wavy_rail());
  scene.along = 121.0;
  expect_error(
      ErrorCode::no_contact, [&] { (void)solve_scene(scene); }, "121");
  scene.along = 119.0; // the rail ends 1 mm ahead
  EXPECT_NO_THROW((void)solve_scene(scene));
}

/// Where the path behind has no rail, the error of steady forces is known of the other wheel only.
TEST_F(VaryingScene, ErrorOfSteadyForcesNeedsTheRailBehind) {
  Scene scene = scene_on(wavy_rail());
  scene.right.rail.name = "60E1";
  scene.motion = Motion{};
  scene.motion->speed = 10000.0;
  scene.derivatives = true;
  scene.along = -119.99;
  const SceneResult at_its_end = solve_scene(scene);
  EXPECT_FALSE(at_its_end.left->patches.front().creep->steady_error);
  EXPECT_TRUE(at_its_end.right->patches.front().creep->steady_error);
  scene.along = -100.0;
  EXPECT_TRUE(solve_scene(scene).left->patches.front().creep->steady_error);
}

Scene level_on(const std::string& rail) {
  Scene scene = scene_on(rail);
  scene.lateral = scene.yaw = scene.along = 0.0;
  scene.roll = 0.0;
  return scene;
}

/// It sinks by half^2 / (2 r) between the ends.
TEST_F(VaryingScene, AWheelStandsOnBothEndsOfAShortGap) {
  const double half = 2.0;
  Scene scene = level_on("60E1");
  const double whole = solve_scene(scene).vertical;
  const std::string rail = rail_with_gap("gap.slcs", half);
  scene.left.rail.name = scene.right.rail.name = rail;
  SceneResult over = solve_scene(scene);
  for (const char* name : {"left.pmax", "left.pmax_element", "left.patches.0.pmax"}) {
    EXPECT_TRUE(std::isnan(number_value(over, name).value())) << name << " has no bound";
  }
  EXPECT_NEAR(whole - over.vertical, half * half / 920.0, 2e-4);
  EXPECT_NEAR(over.left->force.z, scene.left.load, 1e-3 * scene.left.load);
  EXPECT_TRUE(over.left->meets_part_end);
  for (const PatchResult& patch : over.left->patches) { // one, of both ends
    EXPECT_NEAR(patch.centroid.y, 750.0, 10.0);
    EXPECT_NEAR(patch.reference.y, 750.0, 10.0);
    EXPECT_NEAR(patch.reference.z, 0.0, 1.0);
  }
  scene.left.rail.name = "60E1"; // the other way around
  EXPECT_NO_THROW((void)solve_scene(scene));
}

TEST_F(VaryingScene, AWideGapStopsItsOwnWheelOnly) {
  Scene scene = level_on("60E1");
  scene.left.rail.name = rail_with_gap("wide.slcs", 150.0);
  expect_error(
      ErrorCode::no_contact, [&] { (void)solve_scene(scene); },
      "the wheel is over a gap of the rail at 0 mm along it: the nearest part is 150 mm away");
  scene.side = SideChoice::right;
  EXPECT_TRUE(solve_scene(scene).right);
  scene.along = 400.0; // where the left rail has no slices
  EXPECT_TRUE(solve_scene(scene).right);
  scene.side = SideChoice::left;
  expect_error(
      ErrorCode::no_contact, [&] { (void)solve_scene(scene); }, "400");
}

TEST_F(VaryingScene, SwingsBetweenSlicesAreWarnings) {
  const auto warnings_on = [](const std::string& rail) {
    Scene scene = level_on(rail);
    scene.until = Module::geometry;
    return all_warnings(solve_scene(scene));
  };
  const Warnings swings =
      warnings_on(list("joint.slcs", "60E1", {-300.0, -100.0, -0.5, 0.5, 100.0, 300.0},
                       [](double x) { return x < 0.0 ? 0.0 : 0.3; }));
  ASSERT_EQ(swings.size(), 2U);
  EXPECT_EQ(swings[0].kind, WarningClass::profile_swing);
  EXPECT_NE(swings[0].text.find("between slices 2 and 3 the rail is"), std::string::npos);
  EXPECT_NE(swings[1].text.find("steeper than 1:5"), std::string::npos);
  EXPECT_TRUE(warnings_on(wavy_rail()).empty());
}

TEST_F(VaryingScene, RefusesWhatSlicesAndWavesCannotHave) {
  Scene scene;
  const auto solve = [&scene] { (void)solve_scene(scene); };
  scene.left.rail.name = wavy_rail();
  VehicleState state;
  state.velocity = SixNumbers{1e4};
  state.history = std::make_shared<const ContactHistory>();
  state.time_step = 1e-3;
  expect_error(
      ErrorCode::invalid_argument, [&] { (void)scene_at(scene, state); }, "history", "varies");
  scene = Scene();
  scene.left.wheel.name = wavy_rail();
  expect_error(ErrorCode::invalid_argument, solve, "they must be of a wheel");
  scene = Scene();
  scene.left.wheel.name = scene.right.wheel.name = wheel_with_flat();
  scene.left.wheel.options.placement.lateral_shift = 1.0;
  expect_error(ErrorCode::invalid_argument, solve, "; shift = 1\": must have no origin, shift");
  scene = Scene();
  scene.left.wheel.harmonics = {{700, 0.02, 0.0}};
  expect_error(ErrorCode::invalid_argument, solve, "wheelset.harmonics: order 700",
               "at least 12 mm");
  scene.left.wheel.harmonics = {{10, 20.0, 0.0}};
  expect_error(ErrorCode::invalid_argument, solve, "wheelset.harmonics = 20",
               "order times amplitude over radius must be at most 0.2");
}
} // namespace
} // namespace wrc::test::varying_limits_test
