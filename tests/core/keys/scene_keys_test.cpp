#include "keys/scene_keys.hpp"

#include <cctype>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace wrc::test::scene_keys_test {
namespace {

/// The text of the error that a call throws; fails the test if it throws none.
template <class Call> std::string error_text(Call&& call, ErrorCode code) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(SceneKeys, DefaultsAreThePapersTable1) {
  const Scene scene;
  EXPECT_EQ(scene.left.wheel.name, "S1002");
  EXPECT_EQ(scene.left.rail.name, "60E1");
  EXPECT_EQ(scene.track.gauge, 1435.0);
  EXPECT_EQ(scene.track.inclination, std::atan(1.0 / 40.0));
  EXPECT_EQ(scene.back_to_back, 1360.0);
  EXPECT_EQ(scene.left.radius, 460.0);
  EXPECT_EQ(scene.wheel_material.youngs_modulus, 210000.0);
  EXPECT_EQ(scene.rail_material.poisson, 0.3);
}

TEST(SceneKeys, EveryKeyRefusesForbiddenValuesAndNamesAllowedOnes) {
  for (const KeyDescription& key : scene_keys()) {
    Scene scene;
    const auto refuse_number = [&](double value) {
      const std::string text =
          error_text([&] { set_number(scene, key.name, value); }, ErrorCode::invalid_argument);
      EXPECT_NE(text.find(key.name), std::string::npos) << text;
      EXPECT_NE(text.find(must_be(key.allowed)), std::string::npos) << text;
    };
    refuse_number(std::numeric_limits<double>::quiet_NaN());
    refuse_number(1e300);
    refuse_number(-1e300);
    const std::string text =
        error_text([&] { set_text(scene, key.name, ""); }, ErrorCode::invalid_argument);
    EXPECT_NE(text.find(must_be(key.allowed)), std::string::npos) << text;
    const std::array<double, 5> five{1.0, 2.0, 3.0, 4.0, 5.0}; // no list has as many
    error_text([&] { set_numbers(scene, key.name, five); }, ErrorCode::invalid_argument);
  }
}

TEST(SceneKeys, CaseDoesNotMatter) {
  for (const KeyDescription& key : scene_keys()) {
    std::string capitals(key.name);
    for (char& c : capitals) {
      EXPECT_FALSE(c >= 'A' && c <= 'Z') << key.name << ": names are spelled in small letters";
      c = static_cast<char>(std::toupper(c));
    }
    EXPECT_EQ(key_id(capitals), key_id(key.name));
  }
  Scene scene;
  set_number(scene, "Load.LEFT", 7e4);
  EXPECT_EQ(std::get<double>(key_value(scene, "load.left")), 7e4);
  set_text(scene, "Track.Rail", "54E3"); // values keep theirs
  EXPECT_EQ(scene.left.rail.name, "54E3");
  EXPECT_EQ(error_text([&] { set_number(scene, "LOAD.Vertical", 7e4); }, ErrorCode::unknown_name),
            "load.vertical is not a key any more: use load.both");
}

/// A range is stated with the unit: "600 to 1700 mm".
TEST(SceneKeys, ProfilesHaveTheNameOfTheirStandard) {
  Scene scene;
  set_text(scene, "track.rail", "uic54");
  set_text(scene, "wheelset.wheel", "lma");
  EXPECT_EQ(scene.left.rail.name, "54E1");
  EXPECT_EQ(scene.right.wheel.name, "LMA");
}

TEST(SceneKeys, UnitsAreThoseOfTheirRanges) {
  for (const KeyDescription& key : scene_keys()) {
    const std::string unit = key_unit(key.name, Units::mm);
    const std::string allowed(key.allowed);
    const bool is_list = allowed.starts_with('[');
    const auto pure = [&] { // a number ends the range, or a comma
      const std::size_t at = allowed.find(" to ");
      const std::size_t end = allowed.find_first_of(" ,", at + 4);
      return at != std::string::npos && (end == std::string::npos || allowed[end] == ',');
    };
    if (is_list || allowed.find(" to ") == std::string::npos) {
      EXPECT_EQ(unit, "") << key.name;
    } else if (key.name == "wear.energy_coefficient") { // spelled out there
      EXPECT_EQ(unit, "mm2/N");
    } else if (unit == "1") {
      EXPECT_TRUE(pure()) << key.name << ": " << allowed;
    } else {
      EXPECT_NE(allowed.find(' ' + unit), std::string::npos) << key.name << ": " << unit;
      EXPECT_FALSE(pure()) << key.name << ": " << allowed;
    }
  }
  EXPECT_EQ(key_unit("motion.speed", Units::si), "m/s");
  EXPECT_EQ(key_unit("material.wheel.youngs_modulus", Units::si), "Pa");
}

TEST(SceneKeys, RangesAreStatedInTheUnitsAndFrameOfTheCaller) {
  struct Refused {
    const char* key;
    double value;
    const char* text;
  };
  constexpr std::array<Refused, 6> refused{{
      {"pose.lateral", 30.0, "pose.lateral = 30: must be between -10 and 10 m"},
      {"track.gauge", 1435.0, "track.gauge = 1435: must be between 0.6 and 1.7 m"},
      {"motion.speed", 2e4,
       "motion.speed = 20000: must be between -1000 and 1000 m/s, or \"none\""},
      {"material.youngs_modulus", 1e300, "must be between 1e+06 and 1e+15 Pa"},
      {"creepage.spin", 1e300, "must be between -10000 and 10000 1/m, or \"none\""},
      {"pose.yaw", 3.0, "pose.yaw = 3: must be between -0.2 and 0.2 rad"},
  }};
  Scene scene;
  scene.convention.units = Units::si;
  for (const TrackFrame frame : {TrackFrame::left_up, TrackFrame::right_down}) {
    scene.convention.frame = frame;
    for (const Refused& one : refused) {
      const std::string text =
          error_text([&] { set_number(scene, one.key, one.value); }, ErrorCode::invalid_argument);
      EXPECT_NE(text.find(one.text), std::string::npos) << text;
    }
    const std::string text =
        error_text([&] { set_number(scene, "pose.vertical", 460.0); }, ErrorCode::invalid_argument);
    EXPECT_EQ(text, frame == TrackFrame::left_up
                        ? "pose.vertical = 460: must be \"solve\" or -10 to 20 m"
                        : "pose.vertical = 460: must be \"solve\" or -20 to 10 m");
  }
}

TEST(SceneKeys, AnUnknownKeyIsReportedWithTheNearestKeys) {
  const std::array<std::pair<std::string, const char*>, 7> words{{
      {"pose.latral", "pose.lateral"},
      {"track_gage", "track.gauge"},
      {"yaw", "pose.yaw motion.yaw"},
      {"solve.accuracyof", "solve.accuracy_of"},
      {"wheelset.back_to_back_distance", "wheelset.back_to_back"},
      {"loads", "load.both load.left load.right"},
      {std::string(1 << 20, 'y'), ""}, // and does not take a minute
  }};
  for (const auto& [word, nearest] : words) {
    Scene scene;
    const std::string text =
        error_text([&, &word = word] { set_number(scene, word, 1.0); }, ErrorCode::unknown_name);
    EXPECT_NE(text.find("unknown key " + word + "; nearest: " + nearest), std::string::npos)
        << text;
    EXPECT_NE(text.find("; all are listed by wrc_scene_key"), std::string::npos) << text;
    EXPECT_LT(text.size(), word.size() + 250) << text;
  }
}

TEST(SceneKeys, ATextWhereANumberBelongsIsReportedAsOne) {
  Scene scene;
  const auto text_of_refusal = [&](const char* key, const char* value) {
    return error_text([&] { set_text(scene, key, value); }, ErrorCode::invalid_argument);
  };
  EXPECT_EQ(text_of_refusal("pose.lateral", "5"),
            "pose.lateral = \"5\": a text; write the number without quotes; must be between -1e4 "
            "and 1e4 mm");
  for (const char* wrong : {"5mm", "0,005", "-1.5.", "1e"}) {
    EXPECT_EQ(text_of_refusal("pose.lateral", wrong),
              "pose.lateral = \"" + std::string(wrong) +
                  "\": not a number; must be between -1e4 and 1e4 mm");
  }
  EXPECT_EQ(text_of_refusal("pose.lateral", "far"),
            "pose.lateral = \"far\": must be between -1e4 and 1e4 mm");
  EXPECT_EQ(text_of_refusal("solve.side", "5"),
            "solve.side = \"5\": must be \"both\", \"left\" or \"right\"");
  set_text(scene, "convention.units", "SI");
  EXPECT_EQ(text_of_refusal("pose.lateral", "5mm"),
            "pose.lateral = \"5mm\": not a number; must be between -10 and 10 m");
}

TEST(SceneKeys, AModelNoLongerThereNamesABetterOne) {
  Scene scene;
  const std::string text = error_text([&] { set_text(scene, "solve.creep", "fastsim-strips"); },
                                      ErrorCode::invalid_argument);
  EXPECT_NE(text.find("no longer there: \"full\" at solve.accuracy = 0.1"), std::string::npos)
      << text;
  EXPECT_FALSE(scene.creep);
}

TEST(SceneKeys, CantAsRatioOrAngle) {
  Scene scene;
  set_text(scene, "track.inclination", "1:20");
  EXPECT_EQ(scene.track.inclination, std::atan(1.0 / 20.0));
  set_text(scene, "track.inclination", "-1:30");
  EXPECT_EQ(scene.track.inclination, -std::atan(1.0 / 30.0));
  set_number(scene, "track.inclination", 0.01);
  EXPECT_EQ(scene.track.inclination, 0.01);
  for (const char* wrong : {"1:", "1:0", "1:2", "2:40", "1:40x", "x", "1:nan", "1:inf"}) {
    error_text([&] { set_text(scene, "track.inclination", wrong); }, ErrorCode::invalid_argument);
  }
  EXPECT_EQ(scene.track.inclination, 0.01);
}

TEST(SceneKeys, LaterCallsReplaceEarlierOnesOfTheSameSubject) {
  Scene scene;
  set_number(scene, "load.left", 7.0);
  EXPECT_EQ(scene.left.load, 7.0);
  EXPECT_EQ(scene.right.load, 80000.0);
  set_number(scene, "load.both", 9.0);
  EXPECT_EQ(scene.left.load, 9.0);
  EXPECT_EQ(scene.right.load, 9.0);
  const std::array<double, 2> grid{256.0, 128.0};
  set_numbers(scene, "solve.grid", grid);
  EXPECT_TRUE(scene.grid);
  set_number(scene, "solve.accuracy", 1e-2);
  EXPECT_FALSE(scene.grid);
  set_number(scene, "pose.roll", 1e-3);
  EXPECT_EQ(scene.roll, 1e-3);
  set_text(scene, "pose.roll", "en15302");
  EXPECT_EQ(scene.roll, 0.0);
  set_text(scene, "pose.roll", "solve");
  EXPECT_FALSE(scene.roll);
}

TEST(SceneKeys, FrictionByPositionNeedsPairsWithRisingPositions) {
  Scene scene;
  const std::vector<double> pairs{-25.0, 0.1, -10.0, 0.4};
  set_numbers(scene, "friction.left_places", pairs);
  EXPECT_EQ(std::get<std::vector<double>>(key_value(scene, "friction.left_places")), pairs);
  EXPECT_EQ(scene.right.friction.places.size(), 0U);
  EXPECT_EQ(key_value(scene, "friction.places").index(), 0U); // not the same on both sides
  set_numbers(scene, "friction.places", pairs);
  EXPECT_EQ(std::get<std::vector<double>>(key_value(scene, "friction.right_places")), pairs);
  for (const std::vector<double>& wrong :
       {std::vector{-25.0}, std::vector{-10.0, 0.1, -25.0, 0.4}, std::vector{0.0, -0.1},
        std::vector{0.0, 10.5}, std::vector{-201.0, 0.3}}) {
    error_text([&] { set_numbers(scene, "friction.places", wrong); }, ErrorCode::invalid_argument);
  }
  EXPECT_EQ(scene.left.friction.places.size(), 2U);
  set_text(scene, "friction.places", "none");
  EXPECT_EQ(scene.left.friction.places.size(), 0U);
  EXPECT_EQ(std::get<std::string>(key_value(scene, "friction.places")), "none");
}

TEST(SceneKeys, RangesOfListsAreStatedWithTheirUnits) {
  Scene scene;
  const std::vector<double> far{1e6, 0.0, 0.0};
  const auto refusal = [&] {
    return error_text([&] { set_numbers(scene, "track.left.displacement", far); },
                      ErrorCode::invalid_argument);
  };
  EXPECT_FALSE(refusal().ends_with("stated in mm, N, MPa, y left, z up"));
  set_text(scene, "convention.units", "SI");
  EXPECT_TRUE(refusal().ends_with("stated in mm, N, MPa, y left, z up"));
}

TEST(SceneKeys, GridCountsAreWholeNumbers) {
  Scene scene;
  for (const auto& wrong : {std::array{0.0, 4.0}, std::array{2.5, 4.0}, std::array{4.0, 1e9}}) {
    error_text([&] { set_numbers(scene, "solve.grid", wrong); }, ErrorCode::invalid_argument);
  }
  error_text([&] { set_number(scene, "solve.threads", 1.5); }, ErrorCode::invalid_argument);
}

TEST(SceneKeys, AGradeSetsItsYieldStress) {
  Scene scene;
  set_text(scene, "material.rail.yield_stress", "R350HT");
  EXPECT_EQ(std::get<double>(key_value(scene, "material.rail.yield_stress")), 760.0);
  EXPECT_EQ(scene.rail_steel.grade, "R350HT");
  EXPECT_FALSE(scene.wheel_steel.yield_stress);
  set_number(scene, "material.rail.yield_stress", 700.0);
  EXPECT_EQ(scene.rail_steel, (Steel{700.0, {}}));
  set_text(scene, "material.rail.yield_stress", "none");
  EXPECT_EQ(scene.rail_steel, Steel{});
  const std::string text = error_text([&] { set_number(scene, "material.yield_pressure", 900.0); },
                                      ErrorCode::unknown_name);
  EXPECT_NE(text.find("use material.rail.yield_stress"), std::string::npos) << text;
}

} // namespace
} // namespace wrc::test::scene_keys_test
