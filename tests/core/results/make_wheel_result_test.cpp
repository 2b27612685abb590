// The result of a wheel: its patches as they were solved, and residuals by convolutions of their
// own.
#include "results/make_wheel_result.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/solve_scene.hpp"

namespace wrc::test::make_wheel_result_test {
namespace {

TEST(WheelResult, SolvedPatchesIncludeThePartsOfAPlane) {
  WheelResult wheel;
  wheel.patches.resize(3);
  wheel.patches[1].parts.resize(2);
  const std::vector<const PatchResult*> solved = solved_patches(wheel);
  ASSERT_EQ(solved.size(), 4U);
  EXPECT_EQ(solved[0], &wheel.patches[0]);
  EXPECT_EQ(solved[1], &wheel.patches[1].parts[0]);
  EXPECT_EQ(solved[2], &wheel.patches[1].parts[1]);
  EXPECT_EQ(solved[3], &wheel.patches[2]);
}

/// Forces push along the normal of the angle they go with, and along their plane's normal by its
/// pressures; the right side is a mirror image.
TEST(WheelResult, ForcesAreSumsOverThePatches) {
  for (const double lateral : {0.0, 5.0, -5.0}) {
    Scene scene;
    scene.lateral = lateral;
    const SceneResult result = solve_scene(scene);
    for (const WheelResult* wheel : {&*result.left, &*result.right}) {
      Vector3 force;
      double normal_force = 0.0;
      double largest = 0.0;
      for (const PatchResult& patch : wheel->patches) {
        force = force + patch.force;
        const double amount = norm(patch.force);
        normal_force += amount;
        largest = std::max(largest, patch.pmax);
        // A plane that rises to the left pushes the wheel to the right.
        EXPECT_NEAR(patch.force.y, -std::sin(patch.angle) * amount, 1e-6 * amount);
        EXPECT_NEAR(patch.force.z, std::cos(patch.angle) * amount, 1e-6 * amount);
        EXPECT_NEAR(std::cos(patch.plane_angle) * patch.force.z -
                        std::sin(patch.plane_angle) * patch.force.y,
                    patch.normal_force, 1e-6 * amount);
      }
      EXPECT_NEAR(wheel->force.y, force.y, 1e-6);
      EXPECT_NEAR(wheel->force.z, force.z, 1e-6);
      EXPECT_NEAR(wheel->normal_force, normal_force, 1e-6);
      EXPECT_EQ(wheel->pmax, largest);
      EXPECT_NEAR(wheel->force.z, 80000.0, 1.0);
    }
  }
}

TEST(WheelResult, LeftAndRightAreMirrorImages) {
  Scene scene;
  scene.lateral = 4.0;
  const SceneResult one = solve_scene(scene);
  scene.lateral = -4.0;
  const SceneResult other = solve_scene(scene);
  EXPECT_EQ(one.left->force.y, -other.right->force.y);
  EXPECT_EQ(one.left->centroid.y, -other.right->centroid.y);
  EXPECT_EQ(one.left->pmax, other.right->pmax);
}

} // namespace
} // namespace wrc::test::make_wheel_result_test
