/// Wheels and rails that differ from side to side, and rails displaced from their place.
#include <cmath>
#include <filesystem>

#include <unistd.h>

#include <gtest/gtest.h>

#include "creep/rolling_frame.hpp"
#include "keys/scene_file.hpp"
#include "keys/scene_keys.hpp"
#include "measured/readers.hpp"
#include "scene/scene_result.hpp"
#include "scene/solve_scene.hpp"
#include "support/errors.hpp"

namespace wrc::test::sides_test {
namespace {

/// Of forces and pressures, where only rounding of places of 750 mm differs.
constexpr double rounding = 1e-6;

Scene scene_at(double lateral) {
  Scene scene;
  scene.lateral = lateral;
  scene.yaw = 0.003;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  return scene;
}

TEST(Sides, WithoutRollEachWheelIsIndependentOfTheOther) {
  Scene both = scene_at(1.0);
  both.roll = 0.0;
  Scene left = both;
  set_text(left, "wheelset.wheel", "LMA");
  set_text(left, "track.rail", "CHN60");
  set_number(left, "wheelset.radius", 430.0);
  Scene differing = both;
  set_text(differing, "wheelset.left.wheel", "LMA");
  set_text(differing, "track.left.rail", "CHN60");
  set_number(differing, "wheelset.left.radius", 430.0);
  const SceneResult found = solve_scene(differing);
  EXPECT_EQ(found.left->patches.at(0).pressure, solve_scene(left).left->patches.at(0).pressure);
  EXPECT_EQ(found.right->patches.at(0).pressure, solve_scene(both).right->patches.at(0).pressure);
  EXPECT_EQ(found.right->vertical, solve_scene(both).right->vertical);
}

TEST(Sides, DifferingSidesMirrorToTheLastBit) {
  Scene one = scene_at(2.0);
  one.left.wheel.name = "LMA";
  one.right.rail.name = "56E1";
  one.left.radius = 461.0;
  one.left.displacement = {1.0, -0.5, 0.01};
  one.right.velocity = {20.0, 1.0, 0.1};
  one.motion = Motion{.speed = 20000.0, .lateral = 30.0, .yaw = 0.02};
  Scene other = one;
  other.lateral = -one.lateral;
  other.yaw = -one.yaw;
  other.motion = mirrored(*one.motion);
  other.left = one.right;
  other.right = one.left;
  for (RailDisplacement* moved : {&other.left.displacement, &other.right.displacement,
                                  &other.left.velocity, &other.right.velocity}) {
    *moved = mirrored(*moved);
  }
  const SceneResult first = solve_scene(one);
  const SceneResult second = solve_scene(other);
  EXPECT_EQ(first.roll, -second.roll);
  EXPECT_EQ(first.left->patches.at(0).pressure, second.right->patches.at(0).pressure);
  EXPECT_EQ(first.right->force.y, -second.left->force.y);
  EXPECT_EQ(first.right->patches.at(0).creep->lateral_force,
            -second.left->patches.at(0).creep->lateral_force);
}

TEST(Sides, ALargerWheelLiftsItsSide) {
  Scene scene = scene_at(0.0);
  scene.yaw = 0.0;
  scene.left.radius = 461.5;
  const SceneResult found = solve_scene(scene);
  const double apart = found.left->rigid_contact.y - found.right->rigid_contact.y;
  // The rail tops are level, so that the axle is not.
  EXPECT_NEAR(found.roll, 1.5 / apart, 0.1 * 1.5 / apart);
}

TEST(Sides, MovingBothRailsEqualsMovingTheWheelsetTheOtherWay) {
  Scene moved = scene_at(1.0);
  moved.left.displacement = {0.7, -0.4, 0.0};
  moved.right.displacement = moved.left.displacement;
  const SceneResult there = solve_scene(moved);
  const SceneResult here = solve_scene(scene_at(0.3));
  EXPECT_NEAR(there.roll, here.roll, 1e-12);
  EXPECT_NEAR(there.vertical, here.vertical - 0.4, 1e-9);
  for (const auto side : {&SceneResult::left, &SceneResult::right}) {
    const WheelResult& one = *(there.*side);
    const WheelResult& other = *(here.*side);
    EXPECT_NEAR(one.force.y, other.force.y, rounding * one.force.z);
    EXPECT_NEAR(one.pmax, other.pmax, rounding * other.pmax);
    EXPECT_NEAR(one.centroid.y, other.centroid.y + 0.7, 1e-6);
    EXPECT_NEAR(one.centroid.z, other.centroid.z - 0.4, 1e-6);
    EXPECT_NEAR(one.centroid.t_rail, other.centroid.t_rail, 1e-6);
  }
}

TEST(Sides, ARolledRailEqualsARailOfAnotherCant) {
  Scene rolled = scene_at(0.0);
  rolled.roll = 0.0;
  rolled.left.displacement.roll = 0.01;
  Scene canted = scene_at(0.0);
  canted.roll = 0.0;
  canted.track.inclination += 0.01;
  // An inclination turns the rail about its origin too, before the track puts it in its place.
  const RailSurface from(standard_profile("60E1"), rolled.track);
  const RailSurface to(standard_profile("60E1"), canted.track);
  rolled.left.displacement.lateral = to.origin_y() - from.origin_y();
  rolled.left.displacement.height = to.origin_z() - from.origin_z();
  const WheelResult one = *solve_scene(rolled).left;
  const WheelResult other = *solve_scene(canted).left;
  EXPECT_GT(std::abs(rolled.left.displacement.lateral), 0.05);
  EXPECT_NEAR(one.force.y, other.force.y, rounding * one.force.z);
  EXPECT_NEAR(one.pmax, other.pmax, rounding * other.pmax);
  EXPECT_NEAR(one.vertical, other.vertical, 1e-9);
}

TEST(Sides, RailsThatMoveWithTheWheelsetLeaveItsCreepages) {
  Scene scene = scene_at(1.0);
  scene.motion = Motion{.speed = 20000.0};
  const SceneResult at_rest = solve_scene(scene);
  scene.motion->lateral = 50.0;
  scene.motion->vertical = -7.0;
  const SceneResult moving = solve_scene(scene);
  scene.left.velocity = scene.right.velocity = {50.0, -7.0, 0.0};
  const SceneResult both = solve_scene(scene);
  const auto lateral = [](const SceneResult& result) {
    return result.left->patches.at(0).creep->creepages.lateral;
  };
  EXPECT_NEAR(lateral(moving) - lateral(at_rest), 50.0 / 20000.0, 3e-5);
  EXPECT_NEAR(lateral(both), lateral(at_rest), 1e-12);
}

TEST(Sides, ARollingRailAddsSpinAndTheVelocityOfItsLeverArm) {
  Scene scene = scene_at(0.0);
  scene.slip.variation = SlipVariation::planar; // at the reference
  scene.motion = Motion{.speed = 20000.0};
  const Creepages at_rest = solve_scene(scene).left->patches.at(0).creep->creepages;
  scene.left.velocity.roll = 1.0;
  scene.left.velocity.height = -3.0;
  const SceneResult found = solve_scene(scene);
  const PatchResult& patch = found.left->patches.at(0);
  const Vector3 place = patch.frame.origin - patch.approach * patch.frame.normal;
  const RailSurface& rail = *found.left->details.rail;
  const Vector3 of_rail{0.0, -(place.z - rail.origin_z()), place.y - rail.origin_y() - 3.0};
  EXPECT_NEAR(patch.creep->creepages.lateral - at_rest.lateral,
              -dot(of_rail, patch.frame.lateral) / 20000.0, 1e-8);
  EXPECT_EQ(patch.creep->creepages.longitudinal, at_rest.longitudinal);
}

TEST(Sides, AKeyOfBothSidesHasNoValueIfTheyDiffer) {
  Scene scene;
  set_text(scene, "wheelset.right.wheel", "LMA");
  set_number(scene, "wheelset.right.radius", 430.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(key_value(scene, "wheelset.wheel")));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(key_value(scene, "wheelset.radius")));
  EXPECT_EQ(std::get<std::string>(key_value(scene, "wheelset.left.wheel")), "S1002");
  set_text(scene, "wheelset.wheel", "LM");
  EXPECT_EQ(std::get<std::string>(key_value(scene, "wheelset.right.wheel")), "LM");
}

TEST(Sides, DisplacementsAreReturnedInTheCallersConvention) {
  Scene scene;
  scene.convention = {Units::si, TrackFrame::right_down};
  set_numbers(scene, "track.left.displacement", std::vector{0.001, 0.002, 0.003});
  EXPECT_EQ(scene.left.displacement, (RailDisplacement{-1.0, -2.0, 0.003}));
  EXPECT_EQ(std::get<std::vector<double>>(key_value(scene, "track.left.displacement")),
            (std::vector{0.001, 0.002, 0.003}));
  expect_error(
      ErrorCode::invalid_argument,
      [&] {
        set_numbers(scene, "track.left.displacement", std::vector{20.0, 0.0, 0.0});
      },
      "track.left.displacement", "20", "-1e4 to 1e4 mm");
}

TEST(Sides, AnErrorNamesTheKeyOfTheSide) {
  Scene scene;
  scene.right.rail.name = "no such rail";
  expect_error(
      ErrorCode::unknown_name, [&] { solve_scene(scene); }, "track.right.rail", "no such rail");
}

TEST(Sides, ProfilesOfEachSideAreSavedInSeparateFiles) {
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      ("wrcontact_sides_test_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  const auto wheel = [&](double rise) {
    return profile_through(std::vector<Position>{{-60.0, 10.0 + rise},
                                                 {-50.0, 28.0},
                                                 {-30.0, 8.0},
                                                 {0.0, 0.0},
                                                 {30.0, -1.0},
                                                 {60.0, -2.0}},
                           "worn", options)
        .profile;
  };
  Scene scene;
  set_profile(scene, "wheelset.left.wheel", wheel(0.0));
  set_profile(scene, "wheelset.right.wheel", wheel(0.5));
  write_scene(scene, folder / "scene.toml");
  EXPECT_EQ(read_profile(folder / "scene.left.wheel.txt", options).profile.points,
            scene.left.wheel.given->points);
  EXPECT_EQ(read_profile(folder / "scene.right.wheel.txt", options).profile.points,
            scene.right.wheel.given->points);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace wrc::test::sides_test
