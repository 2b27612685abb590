// Scenes that once took gigabytes, read beyond an array or gave numbers that are none.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "keys/scene_keys.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::bounded_cost_test {
namespace {

/// A grid within the limit lacks no more than a few of a hundred rows of it.
constexpr double whole_rows = 1.1;
/// Beyond what any scene here wants.
constexpr double unlimited = 67108864.0;

bool warns(const WheelResult& wheel, const std::string& words) {
  return std::ranges::any_of(wheel.warnings, [&](const Warning& warning) {
    return warning.text.find(words) != std::string::npos;
  });
}

double normal_elements(const WheelResult& wheel) {
  double count = 0.0;
  for (const PatchResult* patch : solved_patches(wheel)) {
    count += static_cast<double>(patch->grid.element_count());
  }
  return count;
}

double creep_elements(const WheelResult& wheel) {
  double count = 0.0;
  for (const PatchResult* patch : solved_patches(wheel)) {
    count += patch->creep ? static_cast<double>(patch->creep->grid.element_count()) : 0.0;
  }
  return count;
}

Scene rolling_scene() {
  Scene scene;
  scene.side = SideChoice::left;
  scene.left.creepages = Creepages{1e-3, 5e-4, 1e-4};
  return scene;
}

/// On the edge of the chamfer, most of it beyond the rail: the patch finder read beyond an array.
TEST(BoundedCost, AWheelBesideTheRailIsSolved) {
  Scene scene;
  scene.left.radius = scene.right.radius = 5000.0;
  scene.lateral = 50.0;
  scene.yaw = -0.2;
  scene.roll = 0.014;
  const SceneResult result = solve_scene(scene);
  ASSERT_TRUE(result.left && result.right);
  for (const WheelResult* wheel : {&*result.left, &*result.right}) {
    EXPECT_GT(wheel->pmax, 0.0);
    EXPECT_NEAR(wheel->force.z, 80e3, 1.0);
  }
}

TEST(BoundedCost, TheLimitHoldsForPressuresAndTractions) {
  Scene scene = rolling_scene();
  scene.accuracy_of = AccuracyOf::forces; // no second grid, of another shape
  scene.accuracy = 2e-4;
  const WheelResult whole = *solve_scene(scene).left;
  EXPECT_FALSE(warns(whole, "solve.element_limit"));
  scene.element_limit = 1000.0;
  const WheelResult wheel = *solve_scene(scene).left;
  EXPECT_LE(normal_elements(wheel), scene.element_limit);
  EXPECT_LE(creep_elements(wheel), scene.element_limit);
  EXPECT_GE(normal_elements(wheel), scene.most_elements() / whole_rows);
  EXPECT_GE(creep_elements(wheel), scene.most_elements() / whole_rows);
  EXPECT_TRUE(warns(wheel, "solve.element_limit = 1000 permits"));
  EXPECT_TRUE(warns(wheel, "creep forces: the accuracy needs"));
  const Grid& grid = wheel.patches.front().grid;
  const Grid& other = whole.patches.front().grid;
  const double shape = grid.lateral_step / grid.longitudinal_step;
  EXPECT_NEAR(shape, other.lateral_step / other.longitudinal_step, 0.01 * shape);
  // The estimate says what is left of the accuracy, and that is true.
  EXPECT_GT(*wheel.error_estimate, scene.accuracy);
  EXPECT_LE(std::abs(wheel.approach / whole.approach - 1.0),
            *wheel.error_estimate + scene.accuracy);
  const CreepResult& creep = *wheel.patches.front().creep;
  const CreepResult& creep_of_whole = *whole.patches.front().creep;
  EXPECT_GT(*creep.error_estimate, scene.accuracy);
  EXPECT_LE(std::abs(creep.longitudinal_force - creep_of_whole.longitudinal_force),
            (*creep.error_estimate + scene.accuracy) * creep.friction *
                wheel.patches.front().normal_force);
}

TEST(BoundedCost, ScenesBelowTheLimitDoNotDependOnIt) {
  Scene scene = rolling_scene();
  const WheelResult by_default = *solve_scene(scene).left;
  scene.element_limit = unlimited;
  const WheelResult other = *solve_scene(scene).left;
  EXPECT_EQ(by_default.pmax, other.pmax);
  EXPECT_EQ(by_default.patches.front().creep->lateral_force,
            other.patches.front().creep->lateral_force);
}

TEST(BoundedCost, PatchesShareTheLimit) {
  Scene scene = rolling_scene();
  set_text(scene, "track.rail", "UIC60-Manchester"); // two lobes
  scene.lateral = 5.0;
  scene.left.load = 10000.0;
  scene.element_limit = unlimited;
  const WheelResult whole = *solve_scene(scene).left;
  ASSERT_GT(solved_patches(whole).size(), 1u);
  scene.element_limit = 2000.0;
  const WheelResult wheel = *solve_scene(scene).left;
  EXPECT_LE(normal_elements(wheel), scene.element_limit);
  EXPECT_LE(creep_elements(wheel), scene.element_limit);
  EXPECT_TRUE(warns(wheel, "solve.element_limit"));
}

TEST(BoundedCost, APrescribedGridIsNotChanged) {
  Scene scene;
  scene.side = SideChoice::left;
  scene.grid = {{60, 40}};
  scene.element_limit = 1000.0;
  const WheelResult wheel = *solve_scene(scene).left;
  EXPECT_EQ(normal_elements(wheel), 2400.0);
  EXPECT_FALSE(warns(wheel, "solve.element_limit"));
}

/// 1482 x 2366 elements once, for 0.08 N.
TEST(BoundedCost, ANearlyEmptyPatchStaysWithinTheLimitOfItsAccuracy) {
  Scene scene;
  set_text(scene, "wheelset.wheel", "LMA");
  set_text(scene, "track.rail", "54E2");
  scene.track.gauge = 1428.8808894188298;
  scene.left.radius = scene.right.radius = 5000.0;
  scene.lateral = 3.2798687261261783;
  scene.yaw = -0.037209116744786108;
  scene.right.creepages = Creepages{6.0953978081335972e-08, 0.00042840384025976162, -0.00024};
  scene.accuracy = 0.021459279727283811;
  scene.vertical = 5004.3941136152862;
  scene.roll = 0.018423843432831176;
  scene.side = SideChoice::right;
  const WheelResult wheel = *solve_scene(scene).right;
  EXPECT_LE(creep_elements(wheel), 16000.0);
  EXPECT_GT(creep_elements(wheel), 8000.0);
  EXPECT_TRUE(warns(wheel, "creep forces: the accuracy needs"));
}

/// Few rows of many elements: rounding both numbers up made 2500 elements of 2198.
TEST(BoundedCost, SlenderCreepGridsStayWithinTheLimitAfterRounding) {
  Scene scene = rolling_scene();
  set_text(scene, "track.rail", "50E6");
  scene.gap = GapConvention::vertical;
  scene.track.gauge = 1425.6172716640262;
  scene.track.gauge_height = 13.89417946930071;
  scene.back_to_back = 1350.7946774687236;
  scene.left.radius = scene.right.radius = 340.10205796599496;
  scene.lateral = -4.7859603929070982;
  scene.vertical = 449.69873738728791;
  scene.roll = -0.14433103660504498;
  scene.accuracy = 0.0042226767227558481;
  for (double limit = 1500.0; limit < 3000.0; limit += 50.0) {
    scene.element_limit = limit;
    const WheelResult wheel = *solve_scene(scene).left;
    ASSERT_GT(creep_elements(wheel), 0.0);
    EXPECT_LE(normal_elements(wheel), scene.element_limit);
    EXPECT_LE(creep_elements(wheel), scene.element_limit);
  }
}

/// Tractions are found at some ten pitch rates where the pitch is free.
TEST(BoundedCost, ElementsCountThreeTimesWithAFreePitchRate) {
  Scene scene;
  scene.motion = Motion{.speed = 2e4};
  scene.element_limit = 1200.0;
  const double given = creep_elements(*solve_scene(scene).left);
  EXPECT_GT(given, 0.5 * scene.most_elements());
  scene.pitch_is_free = true;
  const WheelResult wheel = *solve_scene(scene).left;
  EXPECT_LE(creep_elements(wheel), scene.most_elements() / 3.0);
  EXPECT_TRUE(warns(wheel, "creep forces: the accuracy needs"));
}

/// Forces are homogeneous in friction and creepages: where all slides they go with friction, whose
/// smallest numbers gave infinite derivatives.
TEST(BoundedCost, DerivativesAtTheSmallestFrictionAreThoseOfSliding) {
  for (const CreepModel model : {CreepModel::linear, CreepModel::shen_hedrick_elkins,
                                 CreepModel::polach, CreepModel::fastsim, CreepModel::full}) {
    Scene scene = rolling_scene();
    scene.accuracy = 1e-2;
    scene.creep = model;
    scene.derivatives = true;
    scene.left.friction.coefficient = 1e-8;
    const CreepResult reference = *solve_scene(scene).left->patches.front().creep;
    const double sliding = reference.derivatives->by_friction[0];
    for (const double friction : {1e-29, 1e-31, 1e-160, 1e-300, 1e-305, 5e-324}) {
      scene.left.friction.coefficient = friction;
      const CreepResult found = *solve_scene(scene).left->patches.front().creep;
      for (const double value : found.derivatives->by_creepage) {
        EXPECT_TRUE(std::isfinite(value)) << friction;
      }
      for (const double value : found.derivatives->by_load) {
        EXPECT_TRUE(std::isfinite(value)) << friction;
      }
      ASSERT_TRUE(found.derivatives->by_position);
      for (const double value : *found.derivatives->by_position) {
        EXPECT_TRUE(std::isfinite(value)) << friction;
      }
      // The linear law has none: its forces do not know friction.
      EXPECT_NEAR(found.derivatives->by_friction[0], sliding, 1e-3 * std::abs(sliding))
          << friction << ", model " << static_cast<int>(model);
    }
  }
}

} // namespace
} // namespace wrc::test::bounded_cost_test
