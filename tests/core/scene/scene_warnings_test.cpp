/// Warnings of profiles come with every result that was solved with them.
#include "scene/scene_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "measured/readers.hpp"
#include "results/constants.hpp"
#include "scene/profile_warnings.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::scene_warnings_test {
namespace {

/// The points of S1002, without those between two places, mm.
Profile holed(double first, double last) {
  std::vector<Position> points;
  const Curve curve = standard_profile("S1002").curve;
  for (double arc = 0.0; arc < curve.length(); arc += 0.5) {
    const CurvePoint at = curve.at(arc);
    if (at.lateral < first || at.lateral > last) {
      points.push_back({at.lateral, at.height});
    }
  }
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  return profile_through(points, "holed", options).profile;
}

Scene geometry_of(const Profile& wheel) {
  Scene scene;
  scene.until = Module::geometry;
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->wheel.name = wheel.name;
    side->wheel.given = std::make_shared<const Profile>(wheel);
  }
  return scene;
}

TEST(SceneWarnings, ProfileWarningsDoNotDependOnCachedSurfaces) {
  const Scene scene = geometry_of(holed(-5.0, 8.0));
  SceneSolver solver;
  for (int repeated = 0; repeated < 3; ++repeated) {
    const SceneResult result = solver.solve(scene);
    ASSERT_EQ(warning_count(result), 1U);
    const Warnings all = all_warnings(result);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].kind, WarningClass::profile_gap);
    EXPECT_TRUE(all[0].text.starts_with("wheel profile holed: gap of 13.")) << all[0].text;
    EXPECT_TRUE(result.corrections.empty());
    (void)solver.solve(Scene());
  }
}

TEST(SceneWarnings, ARailWithoutAGaugeFaceIsPlacedByItsAxisWithAWarning) {
  std::vector<Position> points;
  for (double y = -15.0; y <= 15.0; y += 0.25)
    points.push_back({y, std::sqrt(300.0 * 300.0 - y * y) - 300.0});
  ReadOptions options;
  options.kind = ProfileKind::rail;
  const Profile disc = profile_through(points, "disc", options).profile;
  Scene scene;
  scene.until = Module::geometry;
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->rail.name = disc.name;
    side->rail.given = std::make_shared<const Profile>(disc);
  }
  const Warnings all = all_warnings(SceneSolver().solve(scene));
  const auto found = std::find_if(all.begin(), all.end(), [](const Warning& warning) {
    return warning.text.find("placed by its axis, lateral 0 is 750 mm") != std::string::npos;
  });
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->kind, WarningClass::profile_origin);
}

TEST(SceneWarnings, AWarningOfOneSideNamesTheSide) {
  Scene scene = geometry_of(holed(-5.0, 8.0));
  scene.left.wheel = ProfileChoice{"S1002"};
  EXPECT_TRUE(all_warnings(solve_scene(scene)).at(0).text.starts_with("right wheel profile holed"));
  scene.side = SideChoice::left;
  EXPECT_EQ(warning_count(solve_scene(scene)), 0U) << "that wheel is not solved";
}

/// Both sides have their own surface, since their radii differ.
TEST(SceneWarnings, TheSameWarningOfBothSidesIsGivenOnce) {
  Scene scene = geometry_of(holed(-5.0, 8.0));
  scene.right.radius = 459.0;
  const Warnings all = all_warnings(solve_scene(scene));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(all[0].text.starts_with("wheel profile holed"));
}

TEST(SceneWarnings, AllAreTextsByNameAndTheirCountsAgree) {
  Scene scene = geometry_of(holed(-5.0, 8.0));
  scene.until = Module::mechanics;
  scene.lateral = 6.5;
  scene.accuracy = 0.1;
  SceneResult result = solve_scene(scene);
  std::size_t texts = 0;
  std::size_t classes = 0;
  std::size_t left = 0;
  for (const auto& [name, text] : text_values(result)) {
    texts += name.starts_with("warnings.") ? 1 : 0;
    classes += name.starts_with("warning_classes.") ? 1 : 0;
    left += name.starts_with("left.warnings.") ? 1 : 0;
  }
  EXPECT_EQ(number_value(result, "warning_count"), static_cast<double>(texts));
  EXPECT_EQ(number_value(result, "left.warning_count"), static_cast<double>(left));
  EXPECT_EQ(classes, texts);
  EXPECT_GE(texts, 1 + left);
  EXPECT_GT(left, 0U);
}

TEST(SceneWarnings, APressureAboveTheStrengthOfSteelIsReported) {
  Scene scene;
  scene.accuracy = 0.1;
  scene.side = SideChoice::left;
  const auto told = [](const SceneResult& result) {
    const Warnings& all = result.left->warnings;
    return std::ranges::any_of(
        all, [](const Warning& warning) { return warning.kind == WarningClass::pressure; });
  };
  for (const double lateral : {0.0, 3.0, 5.0, 6.5, 7.0}) {
    scene.lateral = lateral;
    const SceneResult result = solve_scene(scene);
    EXPECT_EQ(told(result), result.left->pmax > hardest_steel) << lateral;
  }
  scene.lateral = 6.5;
  EXPECT_TRUE(told(solve_scene(scene))) << "6047 MPa";
  scene.wheel_material.youngs_modulus = scene.rail_material.youngs_modulus = 400e3;
  EXPECT_FALSE(told(solve_scene(scene))) << "no steel";
}

/// A profile of both sides is one entry, and its lead names no side.
TEST(ProfileWarnings, OfBothSidesAreGivenOnce) {
  const auto warnings =
      std::make_shared<const Warnings>(Warnings{{WarningClass::profile_gap, "a gap"}});
  ProfileWarnings all;
  all.add({ProfileKind::wheel, SideChoice::left, "worn.prw", warnings});
  Warnings texts;
  all.append_to(texts);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts.front().text, "left wheel profile worn.prw: a gap");
  all.add({ProfileKind::wheel, SideChoice::right, "worn.prw", warnings});
  EXPECT_EQ(all.count(), 1U);
  texts.clear();
  all.append_to(texts);
  EXPECT_EQ(texts.front().text, "wheel profile worn.prw: a gap");
  all.add({ProfileKind::rail, SideChoice::left, "worn.prw", warnings});
  EXPECT_EQ(all.count(), 2U) << "a rail of the same name";
}

} // namespace
} // namespace wrc::test::scene_warnings_test
