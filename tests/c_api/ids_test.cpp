/// Numbers by id: what the calls by name do, all or nothing, and ids that are none.
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "all_results.hpp"
#include "owned_handles.hpp"
#include "wrcontact.hpp"

namespace ids_test {
namespace {

using Ids = std::vector<std::int32_t>;

std::int32_t key_id(wrc_scene* scene, const char* key) {
  std::int32_t id = -1;
  EXPECT_EQ(wrc_scene_key_id(scene, key, &id), WRC_OK) << key;
  return id;
}

std::int32_t number_id(wrc_scene* scene, const char* name) {
  std::int32_t id = -1;
  EXPECT_EQ(wrc_scene_number_id(scene, name, &id), WRC_OK) << name;
  return id;
}

wrc_status set_by_id(wrc_scene* scene, const Ids& ids, const std::vector<double>& values) {
  return wrc_scene_set_numbers_by_id(scene, ids.data(), values.data(),
                                     static_cast<std::int64_t>(ids.size()));
}

wrc_status read_by_id(wrc_scene* scene, const Ids& ids, std::vector<double>& values) {
  return wrc_scene_numbers_by_id(scene, ids.data(), values.data(),
                                 static_cast<std::int64_t>(ids.size()));
}

/// Everything a step of a vehicle simulation sets.
const std::vector<std::pair<const char*, double>> step{
    {"pose.lateral", 0.0031},       {"pose.yaw", 1e-3},         {"pose.roll", 2e-4},
    {"pose.vertical", 0.459878},    {"load.both", 7e4},         {"load.left", 8e4},
    {"motion.speed", 30.0},         {"motion.pitch", 65.0},     {"motion.lateral", 0.02},
    {"motion.yaw", -1e-3},          {"motion.curvature", 1e-3}, {"friction.coefficient", 0.4},
    {"solve.joining_distance", 0.0}};

/// In other units and the other frame, with creep forces.
ScenePointer make_step_scene() {
  ScenePointer scene = make_small_scene();
  set(scene.get(), {{"convention.units", "SI"},
                    {"convention.frame", "right-down"},
                    {"track.rail", "UIC60-Manchester"},
                    {"solve.creep", "fastsim"}});
  return scene;
}

/// Those of step, where z points down.
double turned(const std::string& key, double value) {
  return key == "pose.vertical" ? -value : value;
}

TEST(Units, AreThoseOfTheNumber) {
  const std::array<std::array<const char*, 3>, 13> units{{
      {"left.pmax", "MPa", "Pa"},
      {"roll", "rad", "rad"},
      {"vertical", "mm", "m"},
      {"left.area", "mm2", "m2"},
      {"wheelset.moment.z", "N mm", "N m"},
      {"left.patches.7.creepage.spin", "1/mm", "1/m"},
      {"left.patches.0.friction_power", "N mm/s", "N m/s"},
      {"right.sensitivities.pressure_force.z.vertical", "N/mm", "N/m"},
      {"left.sensitivities.at_load.vertical.roll", "mm/rad", "m/rad"},
      {"left.jacobian.moment.z.by.lateral_velocity", "N mm s/mm", "N m s/m"},
      {"left.patches.0.creep_force.lateral.by.spin", "N mm", "N m"},
      {"time_ms.total", "ms", "ms"},
      {"left.patch_count", "1", "1"},
  }};
  for (const auto& [name, in_mm, in_si] : units) {
    const ScenePointer scene = make_scene(); // needs no result
    const char* unit = nullptr;
    EXPECT_EQ(wrc_scene_number_unit(scene.get(), name, &unit), WRC_OK) << name;
    EXPECT_STREQ(unit, in_mm) << name;
    set(scene.get(), {{"convention.units", "SI"}});
    EXPECT_EQ(wrc_scene_number_unit(scene.get(), name, &unit), WRC_OK) << name;
    EXPECT_STREQ(unit, in_si) << name;
  }
  const ScenePointer scene = make_scene();
  const char* unit = nullptr;
  expect_error(scene.get(), wrc_scene_number_unit(scene.get(), "model", &unit), WRC_UNKNOWN_NAME,
               "model");
  expect_null_told(scene.get(), wrc_scene_number_unit(scene.get(), nullptr, &unit), "name");
  for (const auto& [key, in_mm, in_si] : {std::array{"load.both", "N", "N"},
                                          {"wear.energy_coefficient", "mm2/N", "m2/N"},
                                          {"friction.decay", "s/mm", "s/m"},
                                          {"creepage.left", "", ""},
                                          {"solve.side", "", ""}}) {
    EXPECT_EQ(wrc_scene_set_text(scene.get(), "convention.units", "mm"), WRC_OK);
    EXPECT_EQ(wrc_scene_key_unit(scene.get(), key, &unit), WRC_OK);
    EXPECT_STREQ(unit, in_mm) << key;
    EXPECT_EQ(wrc_scene_set_text(scene.get(), "convention.units", "SI"), WRC_OK);
    EXPECT_EQ(wrc_scene_key_unit(scene.get(), key, &unit), WRC_OK);
    EXPECT_STREQ(unit, in_si) << key;
  }
  expect_error(scene.get(), wrc_scene_key_unit(scene.get(), "left.pmax", &unit), WRC_UNKNOWN_NAME,
               "unknown key left.pmax");
  expect_null_told(scene.get(), wrc_scene_key_unit(scene.get(), nullptr, &unit), "key");
  expect_null_told(scene.get(), wrc_scene_key_unit(scene.get(), "load.both", nullptr), "unit");
  expect_null_told(scene.get(), wrc_scene_number_unit(scene.get(), "roll", nullptr), "unit");
}

TEST(Ids, SetWhatTheKeysSet) {
  const ScenePointer by_name = make_step_scene();
  const ScenePointer by_id = make_step_scene();
  Ids ids;
  std::vector<double> values;
  for (const auto& [key, value] : step) {
    set(by_name.get(), {{key, turned(key, value)}});
    ids.push_back(key_id(by_id.get(), key));
    values.push_back(turned(key, value));
  }
  ASSERT_EQ(set_by_id(by_id.get(), ids, values), WRC_OK) << wrc_scene_error(by_id.get());
  for (const char* key : {"pose.lateral", "pose.vertical", "load.left", "load.right", "motion.yaw",
                          "motion.curvature", "friction.left"}) {
    double one = 0.0;
    double other = 1.0;
    EXPECT_EQ(wrc_scene_get_number(by_name.get(), key, &one), WRC_OK) << key;
    EXPECT_EQ(wrc_scene_get_number(by_id.get(), key, &other), WRC_OK) << key;
    EXPECT_EQ(one, other) << key;
  }
  solve(by_name.get());
  solve(by_id.get());
  expect_same_bits(by_name.get(), by_id.get(), "set by name and by id");
}

/// By id all that there is by name, bit for bit.
void expect_all_numbers(wrc_scene* scene, const char* where) {
  const ScenePointer unsolved = make_scene(); // ids are the same for all
  Ids ids;
  std::vector<double> by_name;
  for (std::int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
    const char* name = wrc_scene_number_name(scene, i);
    ids.push_back(number_id(unsolved.get(), name));
    by_name.push_back(number_of(scene, name));
  }
  ASSERT_GT(ids.size(), 100U);
  std::vector<double> by_id(ids.size(), -1.0);
  ASSERT_EQ(read_by_id(scene, ids, by_id), WRC_OK) << wrc_scene_error(scene);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(by_id[i]), std::bit_cast<std::uint64_t>(by_name[i]))
        << where << ": " << wrc_scene_number_name(scene, static_cast<std::int64_t>(i));
  }
}

TEST(Ids, ReadWhatTheNamesRead) {
  const ScenePointer scene = make_step_scene();
  wrc_scene* s = scene.get();
  for (const auto& [key, value] : step) {
    set(s, {{key, turned(key, value)}});
  }
  solve(s);
  expect_all_numbers(s, "a scene by itself");
  set(s, {{"convention.units", "mm"}, {"convention.frame", "left-up"}, {"pose.lateral", -2.0}});
  expect_all_numbers(s, "in another convention");
  const SolverPointer solver = make_solver();
  ASSERT_EQ(wrc_solver_solve(solver.get(), s), WRC_OK) << wrc_scene_error(s);
  expect_all_numbers(s, "a step of a solver");
  ASSERT_EQ(wrc_solve_batch(&s, 1, 1, nullptr), WRC_OK);
  expect_all_numbers(s, "a batch");
}

TEST(Ids, AbsentResultsAreNotANumber) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  Ids ids;
  for (const char* name :
       {"left.patch_count", "left.patches.0.pmax", "left.patches.1.pmax", "right.pmax",
        "left.patches.0.creep_force.lateral", "left.patches.0.parts.0.pmax", "wheelset.force.y",
        "left.near_contacts.3.x", "left.validity", "rolling_radius_difference"}) {
    ids.push_back(number_id(s, name)); // before there is a result
  }
  std::vector<double> values(ids.size(), 7.0);
  EXPECT_EQ(read_by_id(s, ids, values), WRC_NO_RESULT);
  EXPECT_EQ(values, std::vector(ids.size(), 7.0));
  solve(s, {{"solve.side", "left"}});
  ASSERT_EQ(read_by_id(s, ids, values), WRC_OK);
  EXPECT_EQ(values[0], 1.0);
  EXPECT_EQ(values[1], number_of(s, "left.pmax"));
  for (std::size_t i = 2; i < values.size(); ++i) {
    EXPECT_TRUE(std::isnan(values[i])) << i;
  }
}

TEST(Ids, ARefusedNumberChangesNothing) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  set(s, {{"pose.lateral", 1.0}, {"load.both", 7e4}});
  const Ids ids{key_id(s, "pose.lateral"), key_id(s, "load.both"), key_id(s, "material.poisson")};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.7, -0.1, nan}) {
    expect_error(s, set_by_id(s, ids, {3.0, 5e4, wrong}), WRC_INVALID_ARGUMENT,
                 "material.poisson = ", "must be between 0 and 0.5");
    double value = 0.0;
    EXPECT_EQ(wrc_scene_get_number(s, "pose.lateral", &value), WRC_OK);
    EXPECT_EQ(value, 1.0);
    EXPECT_EQ(wrc_scene_get_number(s, "load.right", &value), WRC_OK);
    EXPECT_EQ(value, 7e4);
  }
  // As by name: value and range in the units of the caller.
  set(s, {{"convention.units", "SI"}});
  expect_error(s, set_by_id(s, {ids[0]}, {30.0}), WRC_INVALID_ARGUMENT, "pose.lateral = 30",
               "between -10 and 10 m");
  expect_error(s, set_by_id(s, {key_id(s, "solve.threads")}, {1.5}), WRC_INVALID_ARGUMENT,
               "solve.threads = 1.5");
  expect_error(s, set_by_id(s, {key_id(s, "solve.side")}, {1.0}), WRC_INVALID_ARGUMENT,
               "solve.side = 1", "\"left\"");
}

TEST(Ids, IdsOfKeysAndResultsAreDistinct) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s);
  const std::int32_t roll = number_id(s, "roll");
  const std::int32_t lateral = key_id(s, "pose.lateral");
  for (const std::int32_t none : {roll, -1, INT32_MAX, INT32_MIN}) {
    expect_error(s, set_by_id(s, {lateral, none}, {2.0, 0.0}), WRC_INVALID_ARGUMENT, "ids[1] = ");
  }
  for (const std::int32_t none : {lateral, 0, -1, INT32_MAX, INT32_MIN}) {
    std::vector<double> values{7.0, 7.0};
    expect_error(s, read_by_id(s, {roll, none}, values), WRC_INVALID_ARGUMENT, "ids[1] = ");
    EXPECT_EQ(values, std::vector({7.0, 7.0}));
  }
  double value = 1.0;
  EXPECT_EQ(wrc_scene_get_number(s, "pose.lateral", &value), WRC_OK);
  EXPECT_EQ(value, 0.0);
}

TEST(Ids, UnknownNamesHaveNoId) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  std::int32_t id = 7;
  expect_error(s, wrc_scene_key_id(s, "pose.latteral", &id), WRC_UNKNOWN_NAME, "pose.latteral",
               "pose.lateral");
  expect_error(s, wrc_scene_number_id(s, "left.pmaximum", &id), WRC_UNKNOWN_NAME, "left.pmaximum");
  expect_error(s, wrc_scene_number_id(s, "left.patches.1024.pmax", &id), WRC_INVALID_ARGUMENT,
               "left.patches.1024.pmax", "1023");
  expect_error(s, wrc_scene_number_id(s, "left.patches.0.parts.255.pmax", &id),
               WRC_INVALID_ARGUMENT, "254");
  EXPECT_EQ(id, 7);
  EXPECT_EQ(wrc_scene_number_id(s, "left.patches.1023.parts.254.pmax", &id), WRC_OK);
}

TEST(Ids, ArgumentsAreChecked) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s);
  std::int32_t id = 0;
  double value = 0.0;
  expect_null_told(s, wrc_scene_key_id(s, nullptr, &id), "key");
  expect_null_told(s, wrc_scene_key_id(s, "pose.lateral", nullptr), "id");
  expect_null_told(s, wrc_scene_number_id(s, nullptr, &id), "name");
  expect_null_told(s, wrc_scene_number_id(s, "roll", nullptr), "id");
  expect_null_told(s, wrc_scene_set_numbers_by_id(s, nullptr, &value, 1), "ids");
  expect_null_told(s, wrc_scene_set_numbers_by_id(s, &id, nullptr, 1), "values");
  expect_null_told(s, wrc_scene_numbers_by_id(s, nullptr, &value, 1), "ids");
  expect_null_told(s, wrc_scene_numbers_by_id(s, &id, nullptr, 1), "values");
  for (const std::int64_t count : {std::int64_t{-1}, (std::int64_t{1} << 20) + 1, INT64_MAX}) {
    expect_error(s, wrc_scene_set_numbers_by_id(s, &id, &value, count), WRC_INVALID_ARGUMENT,
                 "count = ");
    expect_error(s, wrc_scene_numbers_by_id(s, &id, &value, count), WRC_INVALID_ARGUMENT,
                 "count = ");
  }
  EXPECT_EQ(wrc_scene_set_numbers_by_id(s, nullptr, nullptr, 0), WRC_OK);
  EXPECT_EQ(wrc_scene_numbers_by_id(s, nullptr, nullptr, 0), WRC_OK);
  EXPECT_EQ(wrc_scene_key_id(nullptr, "pose.lateral", &id), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_number_id(nullptr, "roll", &id), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_set_numbers_by_id(nullptr, &id, &value, 1), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_numbers_by_id(nullptr, &id, &value, 1), WRC_INVALID_ARGUMENT);
}

TEST(Ids, InCxxAreThoseOfAnyScene) {
  wrcontact::Scene scene;
  scene.set("solve.grid", std::vector{24.0, 20.0});
  const std::array keys{scene.key_id("pose.lateral"), scene.key_id("load.both")};
  const std::vector names{scene.number_id("left.vertical_force"),
                          scene.number_id("left.patches.4.pmax")};
  scene.set_numbers_by_id(keys, std::vector{2.0, 6e4});
  EXPECT_EQ(scene.get_number("pose.lateral"), 2.0);
  std::array<double, 2> values{};
  EXPECT_THROW(scene.numbers_by_id(names, values), wrcontact::Error);
  ASSERT_TRUE(scene.solve());
  scene.numbers_by_id(names, values);
  EXPECT_EQ(values[0], scene.number("left.vertical_force"));
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_THROW(scene.set_numbers_by_id(keys, std::array{1.0}), wrcontact::Error);
  EXPECT_THROW(scene.set_numbers_by_id(keys, std::array{1.0, -1.0}), wrcontact::Error);
  EXPECT_THROW(scene.numbers_by_id(std::array{-1}, std::array{1.0}), wrcontact::Error);
  EXPECT_THROW((void)scene.key_id("pose.latteral"), wrcontact::Error);
  EXPECT_EQ(scene.get_number("pose.lateral"), 2.0);
}

} // namespace
} // namespace ids_test
