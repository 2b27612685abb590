#include "keys/profile_text.hpp"

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "keys/scene_keys.hpp"
#include "profile/profile.hpp"
#include "support/errors.hpp"

namespace wrc::test::profile_text_test {
namespace {

ProfileChoice choice_of(const std::string& text, ProfileKind kind,
                        const Convention& convention = {}) {
  ProfileChoice choice;
  set_profile_text(choice, text, {"track.rail", kind}, convention);
  return choice;
}

ProfileChoice wheel_of(const std::string& text) {
  return choice_of(text, ProfileKind::wheel);
}

std::string refusal(const std::string& text, ProfileKind kind, const Convention& convention = {}) {
  try {
    choice_of(text, kind, convention);
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << text << " was accepted";
  return "";
}

TEST(ProfileText, HasOptionsBehindTheName) {
  const ProfileChoice choice =
      wheel_of("worn wheel.txt ; Smoothing=5;smoothing_along = 20; shift = -71.5; rotation = 0.02; "
               "origin = flange-back; align_to = my nominal.prw");
  EXPECT_EQ(choice.name, "worn wheel.txt");
  EXPECT_EQ(choice.options.smoothing, 5.0);
  EXPECT_EQ(choice.options.smoothing_along, 20.0);
  EXPECT_EQ(choice.options.placement.lateral_shift, -71.5);
  EXPECT_EQ(choice.options.placement.rotation, 0.02);
  EXPECT_EQ(choice.options.placement.origin, WheelOrigin::flange_back);
  EXPECT_EQ(choice.options.placement.align_to, "my nominal.prw");
  EXPECT_EQ(profile_text(choice, {}),
            "worn wheel.txt; smoothing = 5; smoothing_along = 20; rotation = 0.02; shift = -71.5; "
            "origin = flange-back; align_to = my nominal.prw");
  EXPECT_EQ(wheel_of("a; smoothing = auto; rotation = auto; shift = none; origin = auto; align_to "
                     "= none"),
            ProfileChoice{"a"});
}

TEST(ProfileText, NamesMayHaveBlanksCommasEqualSignsAndSemicolons) {
  for (const char* name :
       {"a b.txt", "a, b = c.txt", "{a}", "\"a\"", "a=b.txt", "=1+1.txt", "a; b.txt", "a;2=b.txt",
        "\tx.txt", " x.txt", "x.txt ", ";", "C:\\wheels\\worn.prw", "a;b c=d"}) {
    EXPECT_EQ(wheel_of(name), ProfileChoice{name}) << name;
  }
  EXPECT_EQ(wheel_of("a=b;c.txt;smoothing=3").name, "a=b;c.txt");
  EXPECT_EQ(wheel_of("a; align_to = b = c; d.txt").options.placement.align_to, "b = c; d.txt");
}

TEST(ProfileText, NumbersAreInTheUnitsOfTheConvention) {
  const Convention si{Units::si, TrackFrame::right_down};
  const ProfileChoice rail =
      choice_of("a; origin = 0.75; smoothing = 0.003", ProfileKind::rail, si);
  EXPECT_DOUBLE_EQ(rail.options.rail_origin.value(), 750.0);
  EXPECT_DOUBLE_EQ(rail.options.smoothing.value(), 3.0);
  EXPECT_EQ(profile_text(rail, si), "a; smoothing = 0.003; origin = 0.75");
  EXPECT_EQ(refusal("a; origin = 750", ProfileKind::rail, si),
            "track.rail.origin = \"750\": must be \"gauge\", or -2 to 2 m");
}

TEST(ProfileText, WrongOptionsAreRefused) {
  EXPECT_EQ(refusal("a; smoothing = 1e3", ProfileKind::rail),
            "track.rail.smoothing = \"1e3\": must be \"auto\", or 0 to 100 mm");
  for (const char* value : {"", "nan", "inf", "1e999", "5 mm", "5,0", "-1"}) {
    EXPECT_EQ(refusal(std::string("a; smoothing = ") + value, ProfileKind::wheel),
              std::string("track.rail.smoothing = \"") + value +
                  "\": must be \"auto\", or 0 to 100 mm");
  }
  EXPECT_EQ(refusal("a; origin = left", ProfileKind::wheel),
            "track.rail.origin = \"left\": must be \"auto\", \"tape\" or \"flange-back\"");
  EXPECT_EQ(refusal("a; shift = 3", ProfileKind::rail),
            "unknown option track.rail.shift: must be smoothing, smoothing_along, rotation, "
            "origin, align_to or file");
  EXPECT_EQ(refusal("a; align_to =", ProfileKind::wheel),
            "track.rail.align_to = \"\": must be a built-in profile or a profile file");
  EXPECT_EQ(refusal("a; smoothing = 3; Smoothing = 5", ProfileKind::wheel),
            "track.rail.Smoothing = \"5\": must be there once; it is twice in one text");
  EXPECT_NE(refusal("a; file = b", ProfileKind::wheel), "");
}

/// Hostile texts of any length take a time in proportion.
TEST(ProfileText, MayBeLong) {
  constexpr std::size_t many = 1000000;
  for (const char* part : {";", "; ", "; a", "= ;"}) {
    std::string text;
    while (text.size() < many) {
      text += part;
    }
    EXPECT_EQ(wheel_of("a" + text + std::string(many, ' ')).options, ProfileOptions{}) << part;
  }
}

TEST(ProfileText, HasNamesOfOptions) {
  Scene scene;
  scene.convention = {Units::si, TrackFrame::right_down};
  set_text(scene, "Track.Rail.File", "a; b = c.txt");
  set_number(scene, "track.rail.Smoothing", 0.003);
  set_text(scene, "track.left.rail.align_to", "d; shift = 3");
  EXPECT_EQ(scene.left.rail.name, "a; b = c.txt");
  EXPECT_EQ(scene.right.rail.options.smoothing, 3.0);
  EXPECT_EQ(std::get<double>(key_value(scene, "track.left.rail.smoothing")), 0.003);
  EXPECT_EQ(std::get<std::string>(key_value(scene, "track.right.rail.align_to")), "none");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(key_value(scene, "track.rail.align_to")));
  EXPECT_EQ(std::get<std::string>(key_value(scene, "wheelset.wheel.origin")), "auto");
  EXPECT_EQ(key_unit("track.rail.smoothing", Units::si), "m");
  EXPECT_EQ(key_unit("wheelset.wheel.origin", Units::si), "");
  const auto number = [&](const char* key, double value) {
    return [&scene, key, value] { set_number(scene, key, value); };
  };
  expect_error(ErrorCode::invalid_argument, number("track.rail.smoothing", 3.0),
               "track.rail.smoothing = \"3\": must be \"auto\", or 0 to 0.1 m");
  expect_error(ErrorCode::unknown_name, number("track.rail.shift", 0.0), "unknown option");
  expect_error(ErrorCode::unknown_name, number("track.gauge.smoothing", 0.0), "unknown key");
  expect_error(
      ErrorCode::invalid_argument, [] { (void)key_id("track.rail.smoothing"); }, "by its name");
  expect_error(
      ErrorCode::unknown_name, [] { (void)key_id("track.rail.slip"); }, "unknown option");
}

TEST(ProfileText, BelongsToTheProfileThatIsNamed) {
  Scene scene;
  set_text(scene, "track.rail", "54e3; origin = 750");
  EXPECT_EQ(scene.left.rail.name, "54E3");
  EXPECT_EQ(scene.right.rail.options.rail_origin, 750.0);
  EXPECT_EQ(std::get<std::string>(key_value(scene, "track.rail")), "54E3; origin = 750");
  set_text(scene, "track.left.rail", "; align_to = S49");
  EXPECT_EQ(scene.left.rail.name, "54E3");
  EXPECT_EQ(scene.left.rail.options.rail_origin, 750.0);
  EXPECT_EQ(scene.right.rail.options.rail_origin, 750.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(key_value(scene, "track.rail")));
  set_text(scene, "track.rail", "60E1");
  EXPECT_EQ(scene.left.rail, scene.right.rail);
  EXPECT_EQ(scene.left.rail, ProfileChoice{"60E1"});
  Profile given = standard_profile("54E3");
  given.points = {{0.0, 0.0}};
  set_profile(scene, "track.rail", given);
  set_text(scene, "track.rail", "; origin = 750");
  EXPECT_TRUE(scene.left.rail.given);
  EXPECT_EQ(scene.left.rail.options.rail_origin, 750.0);
  set_profile(scene, "track.rail", given);
  EXPECT_FALSE(scene.left.rail.options.rail_origin);
  expect_error(
      ErrorCode::invalid_argument, [&] { set_text(scene, "track.rail", ""); }, "track.rail");
  EXPECT_THROW(set_text(scene, "track.rail", "60E1; smoothing = 500"), Error);
  EXPECT_TRUE(scene.left.rail.given);
}

} // namespace
} // namespace wrc::test::profile_text_test
