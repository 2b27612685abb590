/// Steel that yields under profiles that vary along the track: equal slices, crests at the ends of
/// flats, sides, and mixed stiffnesses, equal since forces derive from an energy.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "base/warning.hpp"
#include "scene/solve_scene.hpp"
#include "scene/varying_lists.hpp"
#include "support/energy_pairs.hpp"

namespace wrc::test::yielding_slices_test {
namespace {

void let_yield(Scene& scene, double wheel, double rail) {
  scene.wheel_steel.yield_stress = wheel;
  scene.rail_steel.yield_stress = rail;
}

/// On the tread and where two lobes bear.
TEST_F(VaryingScene, SteelYieldsAlikeOnSlicesThatDifferFarAway) {
  const auto places = places_every(-1000.0, 2000.0, 50.0);
  const auto bump = [](double place) { return place > 1500.0 ? 1.0 : 0.0; };
  const std::string far = list("far.slcs", "60E1", places, bump);
  const std::string equal = list("same.slcs", "60E1", places, [](double) { return 0.0; });
  for (const double lateral : {1.5, 5.0}) {
    Scene scene = scene_on(far);
    scene.motion.reset();
    scene.lateral = lateral;
    let_yield(scene, 520.0, 480.0);
    scene.accuracy = 1e-3;
    const SceneResult one = solve_scene(scene);
    scene.left.rail.name = scene.right.rail.name = equal;
    const SceneResult other = solve_scene(scene);
    const double load = scene.left.load;
    for (const auto& [a, b] : {std::pair(&one.left, &other.left), {&one.right, &other.right}}) {
      EXPECT_EQ((*a)->patches.at(0).elastic_peak.has_value(),
                (*b)->patches.at(0).elastic_peak.has_value());
      EXPECT_LT(norm((*a)->force - (*b)->force), 1e-3 * load) << lateral;
      EXPECT_NEAR((*a)->pmax, (*b)->pmax, 1e-2 * (*b)->pmax) << lateral;
      EXPECT_NEAR((*a)->depth, (*b)->depth, 1e-3 * (*b)->depth) << lateral;
    }
    EXPECT_TRUE(one.left->patches.at(0).elastic_peak) << lateral;
  }
}

/// The sharp end of the flat is a crest along the rail.
TEST_F(VaryingScene, SteelYieldsAtTheEndsOfAFlatWithinTheStatedError) {
  Scene scene = scene_on("60E1", wheel_with_chord());
  scene.side = SideChoice::left;
  scene.motion.reset();
  scene.accuracy_of = AccuracyOf::pressures;
  SceneSolver solver;
  for (const double pitch : {0.01, 0.03, 0.055}) {
    scene.pitch = pitch;
    let_yield(scene, 520.0, 480.0);
    scene.accuracy = 1e-3;
    const WheelResult truth = *solver.solve(scene).left;
    scene.accuracy = 1e-2;
    const WheelResult found = *solver.solve(scene).left;
    ASSERT_TRUE(found.patches.at(0).elastic_peak) << pitch;
    EXPECT_EQ(found.stop_reason, StopReason::tolerance_met) << pitch;
    EXPECT_NEAR(found.force.z, scene.left.load, 1e-6 * scene.left.load) << pitch;
    EXPECT_NEAR(found.pmax / truth.pmax, 1.0, *found.discretisation_error) << pitch;
    EXPECT_LT(found.pmax, *found.patches.at(0).elastic_peak) << pitch;
    EXPECT_EQ(std::ranges::count(found.warnings, WarningClass::first_pressing, &Warning::kind), 1);
  }
}

TEST_F(VaryingScene, SteelThatYieldsMirrorsToTheLastBit) {
  Scene scene = scene_on(wavy_rail(), wheel_with_flat());
  scene.motion.reset();
  scene.lateral = 5.0;
  let_yield(scene, 520.0, 480.0);
  const SceneResult left = solve_scene(scene);
  scene.lateral = -scene.lateral;
  scene.yaw = -scene.yaw;
  const SceneResult right = solve_scene(scene);
  ASSERT_TRUE(left.left->patches.at(0).elastic_peak);
  EXPECT_EQ(left.left->patches.at(0).pressure, right.right->patches.at(0).pressure);
  EXPECT_EQ(left.left->force.x, right.right->force.x);
  EXPECT_EQ(left.left->force.y, -right.right->force.y);
  EXPECT_EQ(left.left->depth, right.right->depth);
}

/// At a prescribed position; over the stiffness by height.
TEST_F(VaryingScene, SteelThatYieldsHasEqualMixedStiffnesses) {
  Scene scene = scene_on(wavy_rail());
  scene.side = SideChoice::left;
  scene.motion.reset();
  scene.yaw = 0.0;
  scene.accuracy = 1e-3;
  let_yield(scene, 480.0, 440.0);
  for (const double lateral : {1.5, 4.0}) {
    scene.lateral = lateral;
    scene.roll.reset();
    scene.vertical.reset();
    stay_where_loaded(scene);
    ASSERT_TRUE(solve_scene(scene).left->patches.at(0).elastic_peak) << lateral;
    constexpr double step = 1e-3;
    const auto force_at = [&](double along, double across, double up) {
      Scene there = scene;
      there.along = scene.along + along;
      there.lateral = lateral + across;
      there.vertical = *scene.vertical + up;
      return solve_scene(there).left->force;
    };
    const auto slope = [&](Vector3 by) {
      return (0.5 / step) * (force_at(by.x, by.y, by.z) - force_at(-by.x, -by.y, -by.z));
    };
    const Vector3 by_x = slope({step, 0.0, 0.0});
    const Vector3 by_y = slope({0.0, step, 0.0});
    const Vector3 by_z = slope({0.0, 0.0, step});
    const double stiffness = std::abs(by_z.z);
    EXPECT_NEAR(by_y.z, by_z.y, 2e-3 * stiffness) << lateral;
    EXPECT_NEAR(by_x.z, by_z.x, 3e-4 * stiffness) << lateral;
    EXPECT_NEAR(by_x.y, by_y.x, 3e-4 * stiffness) << lateral;
  }
}

} // namespace
} // namespace wrc::test::yielding_slices_test
