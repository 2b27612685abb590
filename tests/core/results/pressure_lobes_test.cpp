#include "results/pressure_lobes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/solve_scene.hpp"

namespace wrc::test::pressure_lobes_test {
namespace {

Scene scene_at(double lateral, const std::string& rail = "60E1") {
  Scene scene;
  scene.accuracy = 1e-3;
  scene.accuracy_of = AccuracyOf::forces;
  scene.left.rail.name = scene.right.rail.name = rail;
  scene.lateral = lateral;
  return scene;
}

std::vector<PressureLobe> lobes_of(const WheelResult& wheel) {
  return pressure_lobes(wheel.patches.front(), wheel.details);
}

void expect_sum(const WheelResult& wheel, std::size_t count) {
  const PatchResult& patch = wheel.patches.front();
  const auto lobes = pressure_lobes(patch, wheel.details);
  EXPECT_EQ(lobes.size(), count);
  Vector3 sum;
  double lateral = 0.0;
  for (const PressureLobe& lobe : lobes) {
    sum = sum + lobe.force;
    const Vector3 place{lobe.centroid.x, lobe.centroid.y, lobe.centroid.z};
    lateral += norm(lobe.force) * patch.frame.lateral_of(place - patch.frame.origin);
    // The rail's inclination at the centre is nearly that of the tangent across the force.
    EXPECT_NEAR(lobe.angle, lobe.centroid.angle, 0.02);
  }
  EXPECT_NEAR(norm(sum - patch.force), 0.0, 1e-11 * norm(patch.force));
  EXPECT_NEAR(lateral / norm(patch.force), patch.contact.centroid_lateral, 0.05);
}

TEST(PressureLobes, AddUpToTheForceOfThePatch) {
  expect_sum(*solve_scene(scene_at(-3.0)).left, 1);
  expect_sum(*solve_scene(scene_at(0.0)).left, 2);
  expect_sum(*solve_scene(scene_at(5.0)).left, 2);
}

TEST(PressureLobes, OneIsThePatch) {
  const SceneResult result = solve_scene(scene_at(-3.0));
  const auto lobes = lobes_of(*result.left);
  const PatchResult& patch = result.left->patches.front();
  ASSERT_EQ(lobes.size(), 1U);
  EXPECT_NEAR(lobes[0].angle, patch.angle, 1e-12);
  EXPECT_NEAR(lobes[0].centroid.y, patch.centroid.y, 1e-9);
  EXPECT_NEAR(lobes[0].centroid.z, patch.centroid.z, 1e-9);
  EXPECT_NEAR(lobes[0].centroid.rolling_radius, patch.centroid.rolling_radius, 1e-9);
  EXPECT_NEAR(lobes[0].semi_axis_longitudinal, patch.semi_axis_longitudinal, 1e-9);
  EXPECT_NEAR(lobes[0].semi_axis_lateral, patch.semi_axis_lateral, 1e-9);
}

TEST(PressureLobes, APatchWithPartsHasThoseOfItsParts) {
  Scene scene = scene_at(5.0, "UIC60-Manchester");
  scene.roll = 0.0;
  scene.left.load = scene.right.load = 1e4;
  const SceneResult result = solve_scene(scene);
  ASSERT_EQ(result.left->patches.front().parts.size(), 2U);
  expect_sum(*result.left, 2);
  const auto lobes = lobes_of(*result.left);
  EXPECT_LT(lobes[0].centroid.y, lobes[1].centroid.y); // flange first
}

TEST(PressureLobes, NoneWithoutPressures) {
  Scene scene = scene_at(0.0);
  scene.until = Module::remesh;
  const SceneResult result = solve_scene(scene);
  EXPECT_TRUE(lobes_of(*result.left).empty());
}

TEST(PressureLobes, OfTheRightSideAreMirrorImages) {
  for (const double lateral : {0.0, 5.0}) {
    const SceneResult one = solve_scene(scene_at(lateral));
    const SceneResult other = solve_scene(scene_at(-lateral));
    const auto left = lobes_of(*one.left);
    const auto right = lobes_of(*other.right);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t k = 0; k < left.size(); ++k) {
      EXPECT_EQ(left[k].force.z, right[k].force.z);
      EXPECT_EQ(left[k].force.y, -right[k].force.y);
      EXPECT_EQ(left[k].angle, -right[k].angle);
      EXPECT_EQ(left[k].centroid.y, -right[k].centroid.y);
      EXPECT_EQ(left[k].centroid.z, right[k].centroid.z);
      EXPECT_EQ(left[k].centroid.s_wheel, right[k].centroid.s_wheel);
    }
  }
}

/// The left wheel's lobes, solved again and again.
class Lobes {
public:
  explicit Lobes(const std::string& rail) : scene_(scene_at(0.0, rail)) {
    scene_.side = SideChoice::left;
  }
  std::vector<PressureLobe> at(double lateral) {
    scene_.lateral = lateral;
    const SceneResult result = solver_.solve(scene_);
    EXPECT_EQ(result.left->patches.size(), 1U);
    return lobes_of(*result.left);
  }

private:
  Scene scene_;
  SceneSolver solver_;
};

/// Where one of two lobes is born or gone: it has no force, and the other one stays as it is.
void expect_no_jump(std::vector<PressureLobe> one, std::vector<PressureLobe> two) {
  if (one.size() > two.size()) {
    std::swap(one, two);
  }
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(two.size(), 2U);
  const std::size_t stays = norm(two[0].force) > norm(two[1].force) ? 0 : 1;
  const double allowed = 1e-5;
  EXPECT_LT(norm(two[1 - stays].force), allowed * 80e3);
  EXPECT_LT(norm(two[stays].force - one[0].force), allowed * 80e3);
  EXPECT_NEAR(two[stays].centroid.y, one[0].centroid.y, 30.0 * allowed); // of 30 mm apart
  EXPECT_NEAR(two[stays].centroid.z, one[0].centroid.z, 30.0 * allowed);
  EXPECT_NEAR(two[stays].angle, one[0].angle, allowed);
}

/// In sweeps of 1 um each change of their number is looked at within the micrometre: per nanometre
/// forces change by up to 2e-6 of the load.
TEST(PressureLobes, AreBornAndMergeWithoutAJump) {
  struct Case {
    const char* rail;
    double first, last;
  };
  for (const Case& sweep :
       {Case{"60E1", -0.95, 0.7}, Case{"60E1", 4.55, 5.55}, Case{"UIC60-Manchester", -0.95, 0.7},
        Case{"UIC60-Manchester", 4.4, 5.45}}) {
    SCOPED_TRACE(std::string(sweep.rail) + ' ' + std::to_string(sweep.first));
    Lobes lobes(sweep.rail);
    constexpr double coarse = 0.02;
    int changes = 0;
    for (double lateral = sweep.first; lateral < sweep.last; lateral += coarse) {
      double from = lateral;
      double to = lateral + coarse;
      std::vector<PressureLobe> before = lobes.at(from);
      std::vector<PressureLobe> after = lobes.at(to);
      if (before.size() == after.size()) {
        continue;
      }
      ++changes;
      while (to - from > 1e-6) {
        const double middle = 0.5 * (from + to);
        std::vector<PressureLobe> between = lobes.at(middle);
        if (between.size() == before.size()) {
          from = middle;
          before = std::move(between);
        } else {
          to = middle;
          after = std::move(between);
        }
      }
      SCOPED_TRACE(from);
      expect_no_jump(before, after);
    }
    EXPECT_GE(changes, 2);
  }
}

} // namespace
} // namespace wrc::test::pressure_lobes_test
