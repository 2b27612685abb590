/// What names of results mean, and those that earlier versions had.
#include <array>
#include <cmath>
#include <set>

#include "all_results.hpp"

namespace names_test {
namespace {

/// Rounding of a sum of some terms.
constexpr double rounding = 1e-12;

std::set<std::string> number_names(wrc_scene* scene) {
  std::set<std::string> names;
  for (std::int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
    names.insert(wrc_scene_number_name(scene, i));
  }
  return names;
}

/// Two wheels with creep forces, the right one with a second contact.
ScenePointer solve_moving() {
  ScenePointer scene = make_scene();
  solve(scene.get(), {{"pose.lateral", -6.3},
                      {"pose.yaw", 1e-3},
                      {"motion.speed", 2e4},
                      {"solve.accuracy", 1e-2}});
  return scene;
}

/// All removed results: tests/core/keys/removed_names_test.cpp.
TEST(RemovedResults, NameTheirSuccessors) {
  const ScenePointer scene = solve_moving();
  double value = 0.0;
  std::int32_t id = 0;
  const char* unit = nullptr;
  const char* text = nullptr;
  const std::string expected = "left.patches.0.closeness is not a result any more: use "
                               "left.patches.0.coupling_weight";
  const char* name = "left.patches.0.closeness";
  wrc_scene* s = scene.get();
  expect_error(s, wrc_scene_number(s, name, &value), WRC_UNKNOWN_NAME, expected);
  expect_error(s, wrc_scene_number_id(s, name, &id), WRC_UNKNOWN_NAME, expected);
  expect_error(s, wrc_scene_number_unit(s, name, &unit), WRC_UNKNOWN_NAME, expected);
  expect_error(s, wrc_scene_text(s, name, &text), WRC_UNKNOWN_NAME, expected);
  const double load = 8e4;
  const std::int64_t count = 1;
  expect_error(s, wrc_scene_tabulate(s, "load.both", &load, &count, name, 1, nullptr, &value),
               WRC_UNKNOWN_NAME, expected);
  for (const char* unknown : {"left.grid.2", "grid.0", "left.centroid.moment.x"}) {
    expect_error(s, wrc_scene_number(s, unknown, &value), WRC_UNKNOWN_NAME, "nearest");
  }
}

/// Rows of the grid lie across the rail: 24 of them in a patch, 20 elements along each.
TEST(Names, SayWhichDirectionTheyMean) {
  const ScenePointer scene = make_scene();
  solve(scene.get(), {{"solve.grid", std::vector{24.0, 20.0}}, {"pose.lateral", 3.0}});
  EXPECT_EQ(number_of(scene.get(), "left.patches.0.grid.lateral"), 24.0);
  EXPECT_EQ(number_of(scene.get(), "left.patches.0.grid.longitudinal"), 20.0);
  const std::vector<double> x = field_of(scene.get(), "left.patches.0.x");
  EXPECT_NEAR(x[1] - x[0], number_of(scene.get(), "left.element_size.longitudinal"), 1e-9);
  // Second moments of the pressures, those of an ellipse a, b being a^2/5 and b^2/5.
  const std::vector<double> p = field_of(scene.get(), "left.patches.0.pressure");
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum += p[i];
    first += p[i] * x[i];
    second += p[i] * x[i] * x[i];
  }
  const double variance = second / sum - first / sum * first / sum;
  const double semi_axis = number_of(scene.get(), "left.patches.0.semi_axes.longitudinal");
  EXPECT_NEAR(semi_axis * semi_axis, 5.0 * variance, 0.02 * semi_axis * semi_axis);
}

TEST(PlainForces, AreTotals) {
  const ScenePointer scene = solve_moving();
  wrc_scene* s = scene.get();
  for (const std::string side : {"left.", "right."}) {
    const auto of = [&](const std::string& name) { return number_of(s, (side + name).c_str()); };
    EXPECT_EQ(of("longitudinal_force"), of("total.force.x"));
    EXPECT_EQ(of("lateral_force"), of("total.force.y"));
    EXPECT_EQ(of("vertical_force"), of("total.force.z"));
    std::array<double, 3> sums{};
    std::array<double, 3> pressures{};
    for (int i = 0; i < static_cast<int>(of("patch_count")); ++i) {
      const std::string patch = "patches." + std::to_string(i) + '.';
      const double x = of(patch + "pressure_force.x");
      const double y = of(patch + "pressure_force.y");
      const double z = of(patch + "pressure_force.z");
      EXPECT_NEAR(std::hypot(x, y, z), of(patch + "normal_force"), rounding * 1e5);
      // In the plane of the patch, which is inclined about x. Tangents of elements are a little off
      // it.
      const double angle = of(patch + "plane_angle");
      const double along = of(patch + "creep_force.longitudinal");
      const double across = of(patch + "creep_force.lateral");
      const double off = 2e-2 * std::hypot(along, across);
      EXPECT_NEAR(of(patch + "longitudinal_force"), x + along, off);
      EXPECT_NEAR(of(patch + "lateral_force"), y + across * std::cos(angle), off);
      EXPECT_NEAR(of(patch + "vertical_force"), z + across * std::sin(angle), off);
      sums[0] += of(patch + "longitudinal_force");
      sums[1] += of(patch + "lateral_force");
      sums[2] += of(patch + "vertical_force");
      pressures[0] += x;
      pressures[1] += y;
      pressures[2] += z;
    }
    EXPECT_NEAR(of("longitudinal_force"), sums[0], rounding * 1e5);
    EXPECT_NEAR(of("lateral_force"), sums[1], rounding * 1e5);
    EXPECT_NEAR(of("vertical_force"), sums[2], rounding * 1e5);
    EXPECT_NEAR(of("pressure_force.x"), pressures[0], rounding * 1e5);
    EXPECT_NEAR(of("pressure_force.y"), pressures[1], rounding * 1e5);
    EXPECT_NEAR(of("pressure_force.z"), pressures[2], rounding * 1e5);
  }
}

/// Yaw of 1 mrad at 20 m/s: the lateral force points the other way than that of the pressures.
TEST(PlainForces, MayHaveTheOppositeSignOfThePressureForces) {
  const ScenePointer scene = make_scene();
  solve(scene.get(), {{"pose.lateral", 3.0}, {"pose.yaw", 1e-3}, {"motion.speed", 2e4}});
  EXPECT_LT(number_of(scene.get(), "left.pressure_force.y"), -5e3);
  EXPECT_GT(number_of(scene.get(), "left.lateral_force"), 5e3);
  EXPECT_GT(number_of(scene.get(), "left.patches.0.lateral_force"), 5e3);
}

TEST(PlainForces, AreThoseOfPressuresWithoutCreepForces) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"pose.lateral", 5.0}, {"solve.accuracy", 1e-2}});
  for (const std::string of : {"left.", "right.", "left.patches.0.", "right.patches.0."}) {
    EXPECT_EQ(number_of(s, (of + "longitudinal_force").c_str()),
              number_of(s, (of + "pressure_force.x").c_str()));
    EXPECT_EQ(number_of(s, (of + "lateral_force").c_str()),
              number_of(s, (of + "pressure_force.y").c_str()));
    EXPECT_EQ(number_of(s, (of + "vertical_force").c_str()),
              number_of(s, (of + "pressure_force.z").c_str()));
  }
}

TEST(Patches, HaveTheNamesOfResults) {
  const ScenePointer scene = solve_moving();
  std::array<wrc_patch, 8> patches{};
  std::int64_t count = 0;
  ASSERT_EQ(wrc_scene_patches(scene.get(), patches.data(), sizeof(wrc_patch), 8, &count), WRC_OK);
  ASSERT_GE(count, 2);
  const wrc_patch& patch = patches[0]; // the only one of the left wheel
  ASSERT_EQ(number_of(scene.get(), "left.patch_count"), 1.0);
  const auto of = [&](const std::string& name) {
    return number_of(scene.get(), ("left.patches.0." + name).c_str());
  };
  EXPECT_EQ(patch.wheel, 0.0);
  EXPECT_EQ(patches[1].wheel, 1.0);
  EXPECT_EQ(patch.x, of("x"));
  EXPECT_EQ(patch.y, of("y"));
  EXPECT_EQ(patch.z, of("z"));
  EXPECT_EQ(patch.rolling_radius, of("rolling_radius"));
  EXPECT_EQ(patch.s_wheel, of("s_wheel"));
  EXPECT_EQ(patch.normal_force, of("normal_force"));
  EXPECT_EQ(patch.spin_moment, of("spin_moment"));
  EXPECT_EQ(patch.approach, of("approach"));
  EXPECT_EQ(patch.friction_power, of("friction_power"));
  EXPECT_EQ(patch.pmax, of("pmax"));
  EXPECT_EQ(patch.semi_axes_longitudinal, of("semi_axes.longitudinal"));
  EXPECT_EQ(patch.semi_axes_lateral, of("semi_axes.lateral"));
  EXPECT_EQ(patch.creep_force_longitudinal, of("creep_force.longitudinal"));
  EXPECT_EQ(patch.creep_force_lateral, of("creep_force.lateral"));
  EXPECT_EQ(patch.creepage_longitudinal, of("creepage.longitudinal"));
  EXPECT_EQ(patch.creepage_lateral, of("creepage.lateral"));
  EXPECT_EQ(patch.creepage_spin, of("creepage.spin"));
  EXPECT_EQ(patch.angle, of("angle"));
  EXPECT_EQ(patch.longitudinal_force, of("longitudinal_force"));
  EXPECT_EQ(patch.lateral_force, of("lateral_force"));
  EXPECT_EQ(patch.vertical_force, of("vertical_force"));
  EXPECT_EQ(patch.pressure_force_x, of("pressure_force.x"));
  EXPECT_EQ(patch.pressure_force_y, of("pressure_force.y"));
  EXPECT_EQ(patch.pressure_force_z, of("pressure_force.z"));
  EXPECT_EQ(patch.coupling_weight, of("coupling_weight"));
}

/// As the F77 layer takes it.
struct FirstMembers {
  std::array<double, 22> members;
};

TEST(Patches, CanBeReadInPart) {
  const ScenePointer scene = solve_moving();
  constexpr double untouched = -7.0;
  std::array<FirstMembers, 9> first{};
  first.back().members.fill(untouched);
  std::array<wrc_patch, 8> patches{};
  std::int64_t count = 0;
  ASSERT_EQ(wrc_scene_patches(scene.get(), patches.data(), sizeof(wrc_patch), 8, &count), WRC_OK);
  ASSERT_EQ(wrc_scene_patches(scene.get(), reinterpret_cast<wrc_patch*>(first.data()),
                              sizeof(FirstMembers), 8, &count),
            WRC_OK)
      << wrc_scene_error(scene.get());
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    EXPECT_EQ(first[i].members[0], patches[i].wheel);
    EXPECT_EQ(first[i].members[7], patches[i].angle);
    EXPECT_EQ(first[i].members[11], patches[i].creep_force_longitudinal);
    EXPECT_EQ(first[i].members[12], patches[i].creep_force_lateral);
    EXPECT_EQ(first[i].members[14], patches[i].creepage_longitudinal);
    EXPECT_EQ(first[i].members[15], patches[i].creepage_lateral);
    EXPECT_EQ(first[i].members[16], patches[i].creepage_spin);
    EXPECT_EQ(first[i].members[17], patches[i].semi_axes_longitudinal);
    EXPECT_EQ(first[i].members[18], patches[i].semi_axes_lateral);
    EXPECT_EQ(first[i].members[20], patches[i].pmax);
    EXPECT_EQ(first[i].members[21], patches[i].friction_power);
  }
  EXPECT_EQ(first.back().members[0], untouched);
  EXPECT_EQ(wrc_scene_patches(scene.get(), patches.data(), sizeof(FirstMembers) - 8, 8, &count),
            WRC_INVALID_ARGUMENT);
}

TEST(RemovedResults, OfRollingContactNameTheirSuccessors) {
  wrc_rolling* rolling = nullptr;
  ASSERT_EQ(wrc_rolling_create(&rolling), WRC_OK);
  const std::vector<double> pressure(16, 100.0);
  EXPECT_EQ(wrc_rolling_set_grid(rolling, 4, 4, 1.0, 1.0), WRC_OK);
  EXPECT_EQ(wrc_rolling_set_pressure(rolling, pressure.data(), 16), WRC_OK);
  EXPECT_EQ(wrc_rolling_set_number(rolling, "longitudinal_creepage", -1e-3), WRC_OK);
  EXPECT_EQ(wrc_rolling_set_number(rolling, "lateral_creepage", -5e-4), WRC_OK);
  EXPECT_EQ(wrc_rolling_solve(rolling), WRC_OK);
  double value = 0.0;
  expect_error(rolling, wrc_rolling_number(rolling, "longitudinal_force", &value), WRC_UNKNOWN_NAME,
               "longitudinal_force is not a result any more: use creep_force.longitudinal");
  EXPECT_EQ(wrc_rolling_number(rolling, "creep_force.longitudinal", &value), WRC_OK);
  EXPECT_GT(value, 0.0);
  EXPECT_EQ(wrc_rolling_number(rolling, "force", &value), WRC_UNKNOWN_NAME);
  EXPECT_FALSE(contains(wrc_rolling_error(rolling), " longitudinal_force"))
      << "an old name is listed: " << wrc_rolling_error(rolling);
  wrc_rolling_destroy(rolling);
}

/// Numbers and fields of scenes in which some are zero by symmetry, by the side, or by sign.
TEST(Results, AreNeverMinusZero) {
  const auto scene_with = [](Values values) {
    ScenePointer scene = make_scene();
    set(scene.get(), {{"solve.accuracy", 1e-2}});
    solve(scene.get(), values);
    return scene;
  };
  std::vector<ScenePointer> scenes;
  scenes.push_back(scene_with({{"creepage.spin", 0.0}}));
  scenes.push_back(scene_with({{"creepage.longitudinal", -0.0}, {"pose.yaw", -0.0}}));
  scenes.push_back(scene_with({{"solve.model", "hertz"}}));
  scenes.push_back(scene_with({{"solve.until", "remesh"}}));
  scenes.push_back(scene_with({{"creepage.longitudinal", 1e-3}}));
  for (const ScenePointer& scene : scenes) {
    for (const std::string& name : number_names(scene.get())) {
      const double value = number_of(scene.get(), name.c_str());
      EXPECT_FALSE(value == 0.0 && std::signbit(value)) << name;
    }
    for (const std::string side : {"left.", "right."}) {
      for (const char* field : {"x", "y", "pressure", "traction_x", "traction_y", "slip_y"}) {
        for (const double value : field_of(scene.get(), side + field)) {
          ASSERT_FALSE(value == 0.0 && std::signbit(value)) << side << field;
        }
      }
    }
  }
}

TEST(Table, TakesEachKeyOnce) {
  const ScenePointer scene = make_small_scene();
  const std::array<double, 4> values{0.0, 1.0, 2.0, 3.0};
  const std::array<std::int64_t, 2> counts{2, 2};
  std::array<double, 4> table{-1.0, -1.0, -1.0, -1.0};
  expect_error(scene.get(),
               wrc_scene_tabulate(scene.get(), "pose.lateral pose.lateral", values.data(),
                                  counts.data(), "left.pmax", 1, nullptr, table.data()),
               WRC_INVALID_ARGUMENT, "pose.lateral", "twice");
  EXPECT_EQ(table[0], -1.0);
}

TEST(Names, ANumberIsNoTextAndATextIsNoNumber) {
  const ScenePointer scene = solve_moving();
  const char* text = nullptr;
  EXPECT_EQ(wrc_scene_text(scene.get(), "left.pmax", &text), WRC_UNKNOWN_NAME);
  EXPECT_STREQ(wrc_scene_error(scene.get()), "\"left.pmax\" is a number, not a text");
  double number = 0.0;
  EXPECT_EQ(wrc_scene_number(scene.get(), "left.model", &number), WRC_UNKNOWN_NAME);
  EXPECT_STREQ(wrc_scene_error(scene.get()), "\"left.model\" is a text, not a number");
}

TEST(Names, ErrorsAboutFieldsSayWhatIsMeant) {
  const ScenePointer scene = solve_moving();
  const auto message = [&scene](const char* name) {
    std::int64_t count = 0;
    EXPECT_EQ(wrc_scene_field(scene.get(), name, nullptr, 0, &count), WRC_UNKNOWN_NAME);
    return std::string(wrc_scene_error(scene.get()));
  };
  EXPECT_EQ(message("left.patches.0.presure"),
            "no field is named \"left.patches.0.presure\"; nearest: left.patches.0.pressure");
  EXPECT_EQ(message("left.whel_z"), "no field is named \"left.whel_z\"; nearest: left.wheel_z");
  EXPECT_NE(message("lefft.pressure").find("; nearest: "), std::string::npos);
  EXPECT_EQ(
      message("left.patches.9.pressure"),
      "no field is named \"left.patches.9.pressure\": the name is known, but this solution has "
      "no such field");
  EXPECT_EQ(message("left.pmax"), "\"left.pmax\" is a number, not a field");
  double number = 0.0;
  EXPECT_EQ(wrc_scene_number(scene.get(), "left.pressure", &number), WRC_UNKNOWN_NAME);
  EXPECT_STREQ(wrc_scene_error(scene.get()),
               "\"left.pressure\" names a field, not a number or a text");
  EXPECT_EQ(wrc_scene_number(scene.get(), "left.patches.0.presure", &number), WRC_UNKNOWN_NAME);
  EXPECT_STREQ(wrc_scene_error(scene.get()),
               "no result is named \"left.patches.0.presure\"; nearest: left.patches.0.pressure");
}

} // namespace
} // namespace names_test
