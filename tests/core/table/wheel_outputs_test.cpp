/// Outputs of a table: their order, and lobes that share the normal force.
#include "table/wheel_outputs.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "keys/scene.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::wheel_outputs_test {
namespace {

TEST(WheelOutputs, AreNamedInTheOrderOfTheirNumbers) {
  EXPECT_EQ(names_of_outputs(),
            "wear_number, centroid.t_rail, centroid.s_wheel, centroid.angle, "
            "centroid.rolling_radius, normal_force.tread, normal_force.flange, on_flange_tip");
  const WheelOutputs outputs = outputs_of({-5.0, 6.0, 0.1, 460.5, 0.25, 0.75, 0.0, 0.0}, 8e4, 12.0);
  EXPECT_EQ(outputs, (WheelOutputs{12.0, -5.0, 6.0, 0.1, 460.5, 6e4, 2e4, 1.0}));
  // Splines may leave a share beyond its bounds.
  EXPECT_EQ(outputs_of({0, 0, 0, 0, 0, -1e-3, 0.25, 0}, 8e4, 0.0)[6], 0.0);
}

TEST(WheelOutputs, OfASolutionAreThoseOfBothMirroredWheels) {
  EXPECT_EQ(outputs_of(WheelResult{}), WheelOutputs{});
  Scene scene;
  scene.lateral = 6.3;
  scene.creep = CreepModel::full;
  scene.motion.emplace().speed = 20e3;
  scene.accuracy = 1e-2;
  const SceneResult result = solve_scene(scene);
  const WheelOutputs flange = outputs_of(*result.left);
  EXPECT_NEAR(flange[5] + flange[6], result.left->normal_force, 1e-9 * result.left->normal_force);
  EXPECT_GT(flange[6], 0.0);
  EXPECT_EQ(outputs_of(*result.right)[6], 0.0);
  EXPECT_GT(flange[3], outputs_of(*result.right)[3]);
  EXPECT_GT(flange[0], 0.0);
}

/// The lobes are told by rows of slip, which creepages that are given do not have.
TEST(WheelOutputs, AreRefusedOfCreepagesThatAreGiven) {
  Scene scene;
  scene.accuracy = 1e-2;
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->creepages.emplace().longitudinal = 1e-3;
  }
  const SceneResult result = solve_scene(scene);
  ASSERT_FALSE(result.left->patches.empty());
  EXPECT_THROW(outputs_of(*result.left), std::bad_optional_access);
}

} // namespace
} // namespace wrc::test::wheel_outputs_test
