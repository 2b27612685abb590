/// Differences that no result shows count as none: of materials, of a wheel's radius.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "creep/elastic_history.hpp"
#include "scene/solve_scene.hpp"
#include "scene/vehicle_step.hpp"

namespace wrc::test::negligible_differences_test {
namespace {

constexpr double friction = 0.3;
/// Of forces that no difference may change more: a thousandth of the accuracy.
constexpr double share = 1e-5;

Scene rolling_scene() {
  Scene scene;
  scene.lateral = 2.0;
  scene.side = SideChoice::left;
  scene.accuracy = 1e-2;
  scene.left.creepages = Creepages{1e-3, 5e-4, 1e-4};
  return scene;
}

const CreepResult& creep_of(const SceneResult& result) {
  return result.left.value().patches.front().creep.value();
}

/// E computed from G, Poisson's ratio as a sum, a modulus of six digits.
TEST(LikeMaterials, RoundingOfConstantsChangesNothing) {
  const SceneResult like = solve_scene(rolling_scene());
  const CreepResult& expected = creep_of(like);
  for (const Material& material :
       {Material{std::nextafter(210000.0, INFINITY), 0.3}, Material{210000.0, 0.1 + 0.2},
        Material{2.0 * 1.3 * (210000.0 / 2.6), 0.3}, Material{210000.1, 0.3}}) {
    for (Material Scene::*body : {&Scene::wheel_material, &Scene::rail_material}) {
      Scene scene = rolling_scene();
      scene.*body = material;
      const SceneResult result = solve_scene(scene);
      const CreepResult& found = creep_of(result);
      EXPECT_NEAR(found.longitudinal_force / expected.longitudinal_force, 1.0, share);
      EXPECT_NEAR(found.lateral_force / expected.lateral_force, 1.0, share);
      EXPECT_EQ(found.grid.element_count(), expected.grid.element_count()) << "the usual cost";
      EXPECT_EQ(found.convolutions, expected.convolutions);
      EXPECT_EQ(result.left->warnings, like.left->warnings);
    }
  }
}

TEST(LikeMaterials, HaveAHistory) {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.wheel_material.youngs_modulus = std::nextafter(210000.0, INFINITY);
  scene.rail_material.poisson = 0.1 + 0.2;
  VehicleState state;
  state.position = {0.0, 2.0, 459.8, 0.0, 0.0, 0.001};
  state.velocity = SixNumbers{2e4, 10.0, 0.0, 0.0, 2e4 / 460.0, 0.0};
  state.history = std::make_shared<const ContactHistory>();
  state.time_step = 1e-3;
  EXPECT_NO_THROW(scene_at(scene, state));
  scene.right.friction.coefficient = 0.0;
  EXPECT_NO_THROW(scene_at(scene, state)) << "no friction, no effect";
}

/// The law that decides: K/mu, in mu N.
TEST(LikeMaterials, ForcesChangeByTheDifferenceOverFriction) {
  Scene scene = rolling_scene();
  scene.accuracy = 1e-3;
  const SceneResult before = solve_scene(scene);
  const CreepResult& like = creep_of(before);
  scene.wheel_material.youngs_modulus = 190000.0;
  const double difference =
      shear_constants(scene.wheel_material, scene.rail_material).difference_parameter;
  const SceneResult after = solve_scene(scene);
  const CreepResult& unlike = creep_of(after);
  const double bound = friction * before.left->normal_force;
  const double change = std::hypot(unlike.longitudinal_force - like.longitudinal_force,
                                   unlike.lateral_force - like.lateral_force) /
                        bound;
  EXPECT_GT(difference / friction, 1e-2);
  EXPECT_LT(change, difference / friction + 0.1) << "with that of the other stiffness";
  EXPECT_GT(unlike.pressure_change, 0.0);
  EXPECT_LT(unlike.pressure_change, friction * difference);
}

/// Such a wheel was solved as one that varies, in 20 times the time, and had no history.
TEST(NegligibleDifferences, WavesLeaveAWheelRound) {
  Scene scene = rolling_scene();
  const SceneResult round = solve_scene(scene);
  scene.left.wheel.harmonics = {{1, 1e-12, 0.3}, {20, -2e-12, 0.0}};
  EXPECT_TRUE(has_round_wheels(scene));
  const SceneResult waved = solve_scene(scene);
  EXPECT_EQ(creep_of(waved).longitudinal_force, creep_of(round).longitudinal_force);
  EXPECT_EQ(waved.left->pmax, round.left->pmax);
  scene.left.wheel.harmonics = {{20, 1e-5, 0.0}};
  EXPECT_FALSE(has_round_wheels(scene));
}

} // namespace
} // namespace wrc::test::negligible_differences_test
