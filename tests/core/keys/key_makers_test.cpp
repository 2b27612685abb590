// Makers of keys: what is read and set, and what is not permitted.
#include "keys/key_makers.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test::key_makers_test {
namespace {

using namespace key_makers;
using namespace dimensions;

constexpr KeyDescription named{"some.key", "", "", ""};

TEST(KeyMakers, ANumberInTwoPlacesIsOneOnlyWhereTheyAgree) {
  const Key key = number_key(named, {0.0, 1e6}, force, place_of(&Scene::left, &SceneSide::load),
                             place_of(&Scene::right, &SceneSide::load));
  Scene scene;
  key.set_number(scene, 5e4);
  EXPECT_EQ(scene.left.load, 5e4);
  EXPECT_EQ(scene.right.load, 5e4);
  EXPECT_EQ(std::get<double>(key.get(scene)), 5e4);
  scene.right.load = 6e4;
  EXPECT_TRUE(std::holds_alternative<std::monostate>(key.get(scene)));
  EXPECT_EQ(key.max, 1e6);
}

TEST(KeyMakers, WordsStandForTheValuesOfAnEnumeration) {
  const Key key = word_key(named,
                           std::vector<std::pair<std::string_view, SideChoice>>{
                               {"both", SideChoice::both}, {"left", SideChoice::left}},
                           &Scene::side);
  Scene scene;
  EXPECT_TRUE(key.set_text(scene, "left"));
  EXPECT_EQ(scene.side, SideChoice::left);
  EXPECT_EQ(std::get<std::string>(key.get(scene)), "left");
  EXPECT_FALSE(key.set_text(scene, "middle"));
  EXPECT_EQ(scene.side, SideChoice::left) << "unchanged";
}

TEST(KeyMakers, AWordUnsetsANumber) {
  const Key key = optional_key(named, {0.0, 1.0}, angle, &Scene::roll, "solved");
  Scene scene;
  EXPECT_EQ(std::get<std::string>(key.get(scene)), "solved");
  key.set_number(scene, 0.01);
  EXPECT_EQ(std::get<double>(key.get(scene)), 0.01);
  EXPECT_FALSE(key.set_text(scene, "unset"));
  EXPECT_TRUE(scene.roll);
  EXPECT_TRUE(key.set_text(scene, "solved"));
  EXPECT_FALSE(scene.roll);
}

/// Three numbers in the caller's units and frame; limits are in mm.
TEST(KeyMakers, ThreeNumbersFollowTheConvention) {
  const Key key = three_key(
      named, {10.0, 10.0, 0.1}, {turning_length, turning_length, angle},
      [](const Scene& scene) -> std::optional<Three> {
        const RailDisplacement& d = scene.left.displacement;
        return Three{d.lateral, d.height, d.roll};
      },
      [](Scene& scene, const Three& inside) {
        scene.left.displacement = {inside[0], inside[1], inside[2]};
      });
  Scene scene;
  scene.convention = {Units::si, TrackFrame::right_down};
  EXPECT_TRUE(key.set_numbers(scene, std::array{0.002, -0.003, 0.05}));
  EXPECT_DOUBLE_EQ(scene.left.displacement.lateral, -2.0);
  EXPECT_DOUBLE_EQ(scene.left.displacement.height, 3.0);
  EXPECT_DOUBLE_EQ(scene.left.displacement.roll, 0.05);
  const auto values = std::get<std::vector<double>>(key.get(scene));
  EXPECT_DOUBLE_EQ(values[0], 0.002);
  EXPECT_DOUBLE_EQ(values[1], -0.003);
  EXPECT_FALSE(key.set_numbers(scene, std::array{0.011, 0.0, 0.0})) << "11 mm";
  EXPECT_FALSE(key.set_numbers(scene, std::array{0.0, 0.0})) << "two numbers";
  EXPECT_FALSE(key.set_numbers(scene, std::array{std::nan(""), 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(scene.left.displacement.lateral, -2.0) << "unchanged";
}

} // namespace
} // namespace wrc::test::key_makers_test
