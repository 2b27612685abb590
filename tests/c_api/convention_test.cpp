/// Units and frame of a scene, values of keys, the modules one by one, profiles of the program's
/// own, and the file of a scene.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "all_results.hpp"

namespace convention_test {
namespace {

/// Powers of ten are exact in double precision: only the last rounding is left.
constexpr double rounding = 1e-15;

std::map<std::string, double> numbers_of(wrc_scene* scene) {
  std::map<std::string, double> numbers;
  for (std::int64_t i = 0; const char* name = wrc_scene_number_name(scene, i); ++i) {
    numbers[name] = number_of(scene, name);
  }
  return numbers;
}

TEST(Convention, MetresAndPascalsGiveTheSameScene) {
  const ScenePointer in_mm = make_small_scene();
  set(in_mm.get(),
      {{"pose.lateral", 4.0}, {"track.gauge", 1437.0}, {"material.youngs_modulus", 2.1e5}});
  const ScenePointer in_m = make_small_scene();
  set(in_m.get(), {{"convention.units", "SI"},
                   {"pose.lateral", 4.0e-3},
                   {"track.gauge", 1.437},
                   {"material.youngs_modulus", 2.1e11}});
  solve(in_mm.get());
  solve(in_m.get());
  const char* units = nullptr;
  ASSERT_EQ(wrc_scene_text(in_m.get(), "units", &units), WRC_OK);
  EXPECT_STREQ(units, "m, N, Pa, rad");

  const std::map<std::string, double> factors{{"left.pmax", 1e6},
                                              {"left.area", 1e-6},
                                              {"left.patches.0.y", 1e-3},
                                              {"left.patches.0.angle", 1},
                                              {"left.normal_force", 1},
                                              {"left.pressure_moment.x", 1e-3},
                                              {"left.approach", 1e-3},
                                              {"vertical", 1e-3},
                                              {"roll", 1},
                                              {"left.iterations", 1},
                                              {"left.patches.0.fill", 1},
                                              {"right.patches.0.radii.longitudinal", 1e-3},
                                              {"left.sensitivities.pressure_force.z.vertical", 1e3},
                                              {"left.sensitivities.pressure_force.z.roll", 1},
                                              {"left.sensitivities.at_load.vertical.roll", 1e-3}};
  for (const auto& [name, factor] : factors) {
    const double expected = factor * number_of(in_mm.get(), name.c_str());
    EXPECT_NEAR(number_of(in_m.get(), name.c_str()), expected, 1e-12 * std::abs(expected)) << name;
  }
  const std::vector<double> pressure = field_of(in_mm.get(), "left.pressure");
  const std::vector<double> in_pascal = field_of(in_m.get(), "left.pressure");
  ASSERT_EQ(pressure.size(), in_pascal.size());
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_NEAR(in_pascal[i], 1e6 * pressure[i], 1e-12 * 1e6 * pressure[i]);
  }
}

TEST(Convention, EveryNumberIsTransformedConsistently) {
  // With the results of one solution, told in four ways.
  const ScenePointer scene = make_small_scene();
  solve(scene.get(), {{"pose.lateral", 4.0}, {"pose.yaw", 5e-3}});
  const auto usual = numbers_of(scene.get());
  set(scene.get(), {{"convention.units", "SI"}});
  const auto si = numbers_of(scene.get());
  set(scene.get(), {{"convention.units", "mm"}, {"convention.frame", "right-down"}});
  const auto turned = numbers_of(scene.get());
  set(scene.get(), {{"convention.frame", "left-up"}});
  EXPECT_EQ(numbers_of(scene.get()), usual);
  ASSERT_EQ(usual.size(), si.size());
  ASSERT_EQ(usual.size(), turned.size());
  for (const auto& [name, value] : usual) {
    if (value == 0.0) {
      EXPECT_EQ(si.at(name), 0.0) << name;
      EXPECT_EQ(turned.at(name), 0.0) << name;
      continue;
    }
    EXPECT_EQ(std::abs(turned.at(name)), std::abs(value)) << name;
    const double power = std::log10(si.at(name) / value);
    EXPECT_NEAR(power, 3.0 * std::round(power / 3.0), rounding * 10.0) << name;
  }
  // What turns, by example: components across and up, not those along, and no angle about x.
  for (const char* name : {"left.patches.0.y", "left.patches.0.z", "right.lateral_force",
                           "right.vertical_force", "vertical", "left.pressure_moment.y",
                           "left.pressure_moment.z", "left.sensitivities.pressure_force.y.roll"}) {
    EXPECT_EQ(turned.at(name), -usual.at(name)) << name;
  }
  for (const char* name :
       {"left.patches.0.x", "left.patches.0.angle", "roll", "left.normal_force",
        "left.pressure_moment.x", "left.patches.0.s_wheel", "left.approach",
        "left.sensitivities.pressure_force.y.lateral",
        "left.sensitivities.pressure_force.z.lateral", "rolling_radius_difference"}) {
    EXPECT_EQ(turned.at(name), usual.at(name)) << name;
  }
}

TEST(Convention, ATurnedSceneIsTheSameScene) {
  const ScenePointer usual = make_small_scene();
  solve(usual.get(), {{"pose.lateral", 3.0}, {"pose.yaw", 4e-3}, {"pose.vertical", 459.85}});
  const ScenePointer turned = make_small_scene();
  solve(turned.get(), {{"convention.frame", "right-down"},
                       {"pose.lateral", -3.0},
                       {"pose.yaw", -4e-3},
                       {"pose.vertical", -459.85}});
  EXPECT_EQ(number_of(turned.get(), "left.lateral_force"),
            -number_of(usual.get(), "left.lateral_force"));
  EXPECT_EQ(field_of(turned.get(), "left.y").front(), -field_of(usual.get(), "left.y").front());
  EXPECT_EQ(field_of(turned.get(), "left.x"), field_of(usual.get(), "left.x"));
  set(turned.get(), {{"convention.frame", "left-up"}});
  expect_same_bits(usual.get(), turned.get(), "seen from the usual frame again");
}

TEST(Convention, RefusedValuesAndTheirRangesAreInTheUnitsOfTheCaller) {
  const ScenePointer scene = make_scene();
  set(scene.get(), {{"convention.units", "SI"}});
  EXPECT_EQ(wrc_scene_set_number(scene.get(), "track.gauge", 1435.0), WRC_INVALID_ARGUMENT);
  EXPECT_STREQ(wrc_scene_error(scene.get()), "track.gauge = 1435: must be between 0.6 and 1.7 m");
}

TEST(Inputs, AreDefaultsUntilSet) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  double number = 0.0;
  const char* text = nullptr;
  EXPECT_EQ(wrc_scene_get_number(s, "track.gauge", &number), WRC_OK);
  EXPECT_EQ(number, 1435.0);
  EXPECT_EQ(wrc_scene_get_text(s, "pose.roll", &text), WRC_OK);
  EXPECT_STREQ(text, "solve");
  set(scene.get(), {{"pose.roll", 1e-3}});
  expect_error(s, wrc_scene_get_text(s, "pose.roll", &text), WRC_INVALID_ARGUMENT, "pose.roll");
  EXPECT_EQ(wrc_scene_get_number(s, "pose.roll", &number), WRC_OK);
  EXPECT_EQ(number, 1e-3);
  set(scene.get(), {{"pose.roll", "solve"}});
  EXPECT_EQ(wrc_scene_get_text(s, "pose.roll", &text), WRC_OK);
  set(scene.get(), {{"load.left", 5e4}});
  EXPECT_EQ(wrc_scene_get_number(s, "load.both", &number), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_get_number(s, "load.left", &number), WRC_OK);
  EXPECT_EQ(number, 5e4);
  EXPECT_EQ(wrc_scene_get_text(s, "solve.grid", &text), WRC_OK);
  EXPECT_STREQ(text, "by accuracy");
  set(s, {{"solve.grid", std::vector{30.0, 20.0}}});
  double read[2] = {};
  std::int64_t count = 0;
  EXPECT_EQ(wrc_scene_get_numbers(s, "solve.grid", nullptr, 0, &count), WRC_OK);
  EXPECT_EQ(count, 2);
  EXPECT_EQ(wrc_scene_get_numbers(s, "solve.grid", read, 1, &count), WRC_TOO_SMALL);
  EXPECT_EQ(wrc_scene_get_numbers(s, "solve.grid", read, 2, &count), WRC_OK);
  EXPECT_EQ(read[0], 30.0);
  EXPECT_EQ(read[1], 20.0);
  set(scene.get(), {{"convention.units", "SI"}});
  EXPECT_EQ(wrc_scene_get_number(s, "track.gauge", &number), WRC_OK);
  EXPECT_EQ(number, 1.435);
  EXPECT_EQ(wrc_scene_get_number(s, "track.width", &number), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_scene_get_number(s, "track.gauge", nullptr), WRC_INVALID_ARGUMENT);
}

TEST(Inputs, EveryValueCanBeSetAgain) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  for (std::int64_t i = 0; i < wrc_scene_key_count(); ++i) {
    const char *name = nullptr, *default_value = nullptr, *allowed = nullptr, *meaning = nullptr;
    ASSERT_EQ(wrc_scene_key(i, &name, &default_value, &allowed, &meaning), WRC_OK);
    double number = 0.0;
    const char* text = nullptr;
    if (wrc_scene_get_number(s, name, &number) == WRC_OK) {
      set(s, {{name, number}});
    } else if (const std::string list = default_value; list.starts_with("[0.0")) {
      std::vector<double> values(static_cast<std::size_t>(std::ranges::count(list, ',')) + 1, 1.0);
      std::int64_t count = std::ssize(values);
      ASSERT_EQ(wrc_scene_get_numbers(s, name, values.data(), count, &count), WRC_OK) << name;
      EXPECT_EQ(values, std::vector(values.size(), 0.0)) << name;
      set(s, {{name, values}});
    } else {
      ASSERT_EQ(wrc_scene_get_text(s, name, &text), WRC_OK) << name;
      const std::string value = text;
      EXPECT_EQ('"' + value + '"', default_value) << name;
      set(s, {{name, value.c_str()}});
    }
  }
}

TEST(Modules, StopOnRequest) {
  const ScenePointer scene = make_scene();
  solve(scene.get(), {{"solve.grid", std::vector{64.0, 32.0}}, {"pose.lateral", 3.0}});
  const double roll = number_of(scene.get(), "roll");
  const double pmax = number_of(scene.get(), "left.pmax");

  solve(scene.get(), {{"solve.until", "geometry"}});
  EXPECT_EQ(number_of(scene.get(), "roll"), roll);
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(scene.get(), "left.patches.0.angle", &value), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_scene_number(scene.get(), "left.residuals.least_gap", &value), WRC_UNKNOWN_NAME);

  solve(scene.get(), {{"solve.until", "remesh"}});
  EXPECT_EQ(number_of(scene.get(), "left.grid.lateral"), 64.0);
  EXPECT_EQ(number_of(scene.get(), "left.grid.longitudinal"), 32.0);
  EXPECT_EQ(wrc_scene_number(scene.get(), "left.residuals.least_gap", &value), WRC_UNKNOWN_NAME);
  const std::vector<double> distance = field_of(scene.get(), "left.undeformed_distance");
  ASSERT_EQ(distance.size(), 64U * 32U);
  for (const double pressure : field_of(scene.get(), "left.pressure")) {
    ASSERT_EQ(pressure, 0.0);
  }

  // The third module by itself, on these distances, gives nearly what all three give at once: the
  // grids differ, and the depth is an estimate.
  const NormalPointer normal = make_normal();
  ASSERT_EQ(wrc_normal_set_grid(normal.get(), 64, 32,
                                number_of(scene.get(), "left.element_size.lateral"),
                                number_of(scene.get(), "left.element_size.longitudinal")),
            WRC_OK);
  ASSERT_EQ(wrc_normal_set_distance(normal.get(), distance.data(),
                                    static_cast<std::int64_t>(distance.size())),
            WRC_OK);
  ASSERT_EQ(wrc_normal_set_number(normal.get(), "normal_load",
                                  80e3 / std::cos(number_of(scene.get(), "left.angle"))),
            WRC_OK);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
  double by_parts = 0.0;
  ASSERT_EQ(wrc_normal_number(normal.get(), "pmax", &by_parts), WRC_OK);
  EXPECT_NEAR(by_parts, pmax, 0.01 * pmax);
}

TEST(Modules, TheSamePositionGivesTheSameDistances) {
  const ScenePointer scene = make_small_scene();
  solve(scene.get(), {{"pose.lateral", 3.0}, {"pose.vertical", 459.85}, {"solve.until", "remesh"}});
  double least = 0.0;
  for (const double distance : field_of(scene.get(), "left.undeformed_distance")) {
    least = std::min(least, distance);
  }
  // The grid's centres miss the deepest place by little.
  EXPECT_NEAR(-least, number_of(scene.get(), "left.patches.0.approach"), 0.02 * -least);
}

/// A conical wheel with a flange, and a rail head of a circular arc.
void set_simple_points(wrc_profile* profile, std::int32_t kind) {
  std::vector<double> lateral;
  std::vector<double> height;
  for (int i = 0; i <= 80; ++i) {
    if (kind == WRC_WHEEL) {
      const double s = -38.0 + i;
      lateral.push_back(s);
      height.push_back(-s / 40.0 + 0.02 * std::pow(std::max(0.0, -s - 18.0), 2.4));
    } else {
      const double t = -34.0 + 68.0 * i / 80.0;
      lateral.push_back(t);
      height.push_back(std::sqrt(300.0 * 300.0 - t * t) - 300.0 -
                       0.15 * std::pow(std::max(0.0, std::abs(t) - 24.0), 2.2));
    }
  }
  wrc_read_options options{};
  options.struct_size = sizeof options;
  options.kind = kind;
  options.kind_given = 1;
  ASSERT_EQ(wrc_profile_set_points(profile, "by hand", lateral.data(), height.data(),
                                   static_cast<std::int64_t>(lateral.size()), &options),
            WRC_OK)
      << wrc_profile_error(profile);
}

class SceneFile : public WithFolder {};

TEST_F(SceneFile, ProfilesFromTheProgramEqualThoseOfAFile) {
  const ProfilePointer wheel = make_profile();
  set_simple_points(wheel.get(), WRC_WHEEL);
  const ProfilePointer rail = make_profile();
  set_simple_points(rail.get(), WRC_RAIL);
  const ScenePointer scene = make_small_scene();
  expect_error(scene.get(), wrc_scene_set_profile(scene.get(), "track.rail", wheel.get()),
               WRC_INVALID_ARGUMENT, "track.rail");
  EXPECT_EQ(wrc_scene_set_profile(scene.get(), "track.gauge", rail.get()), WRC_INVALID_ARGUMENT);
  const ProfilePointer empty = make_profile();
  EXPECT_EQ(wrc_scene_set_profile(scene.get(), "track.rail", empty.get()), WRC_NO_RESULT);
  EXPECT_EQ(wrc_scene_set_profile(scene.get(), "track.rail", nullptr), WRC_INVALID_ARGUMENT);
  ASSERT_EQ(wrc_scene_set_profile(scene.get(), "wheelset.wheel", wheel.get()), WRC_OK);
  ASSERT_EQ(wrc_scene_set_profile(scene.get(), "track.rail", rail.get()), WRC_OK);
  solve(scene.get());
  set(scene.get(), {{"track.rail", "; smoothing = 2"}});
  EXPECT_EQ(wrc_scene_solve(scene.get()), WRC_INVALID_ARGUMENT);
  set(scene.get(), {{"track.rail", "; smoothing = 0"}});

  ASSERT_EQ(wrc_scene_write(scene.get(), path("scene.toml").c_str()), WRC_OK);
  const ScenePointer by_file = make_small_scene();
  solve(by_file.get(), {{"wheelset.wheel", path("scene.wheel.txt").c_str()},
                        {"track.rail", path("scene.rail.txt").c_str()}});
  for (const char* name : {"left.pmax", "right.pmax", "roll", "left.approach"}) {
    EXPECT_EQ(number_of(scene.get(), name), number_of(by_file.get(), name)) << name;
  }
  // By name again.
  solve(scene.get(), {{"track.rail", "60E1"}, {"wheelset.wheel", "S1002"}});
  const ScenePointer standard = make_small_scene();
  solve(standard.get());
  expect_same_bits(scene.get(), standard.get(), "the standard profiles");
}

TEST_F(SceneFile, ABuiltInProfileIsSavedByName) {
  const ProfilePointer rail = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(rail.get(), "54E3"), WRC_OK);
  const ScenePointer scene = make_small_scene();
  ASSERT_EQ(wrc_scene_set_profile(scene.get(), "track.rail", rail.get()), WRC_OK);
  ASSERT_EQ(wrc_scene_write(scene.get(), path("scene.toml").c_str()), WRC_OK);
  std::stringstream text;
  text << std::ifstream(path("scene.toml")).rdbuf();
  EXPECT_TRUE(contains(text.str(), "rail = \"54E3\"")) << text.str();
  EXPECT_FALSE(std::filesystem::exists(path("scene.rail.txt")));
}

TEST_F(SceneFile, CannotBeWrittenWhereThereIsNoFolder) {
  const ScenePointer scene = make_scene();
  expect_error(scene.get(), wrc_scene_write(scene.get(), path("nowhere/scene.toml").c_str()),
               WRC_FILE_UNREADABLE, "nowhere");
  EXPECT_EQ(wrc_scene_write(scene.get(), nullptr), WRC_INVALID_ARGUMENT);
  std::filesystem::create_directory(path("folder.toml"));
  expect_error(scene.get(), wrc_scene_write(scene.get(), path("folder.toml").c_str()),
               WRC_FILE_UNREADABLE, "not a regular file");
}

TEST(ProfilePoints, AreRefusedWithTheCause) {
  const ProfilePointer profile = make_profile();
  wrc_read_options options{};
  options.struct_size = sizeof options;
  const double lateral[] = {0.0, 1.0, std::nan(""), 3.0, 4.0, 5.0};
  const double height[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  const auto set = [&](std::int64_t count, const wrc_read_options* given) {
    return wrc_profile_set_points(profile.get(), "points", lateral, height, count, given);
  };
  EXPECT_EQ(set(6, nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(set(6, &options), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_profile_error(profile.get()), "kind"));
  options.kind_given = 1;
  EXPECT_EQ(set(6, &options), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_profile_error(profile.get()), "point 2"));
  EXPECT_EQ(set(2, &options), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(set(0, &options), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(set(-1, &options), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(set(INT64_MAX, &options), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_length(profile.get(), nullptr), WRC_NO_RESULT);
}

} // namespace
} // namespace convention_test
