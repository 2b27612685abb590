/// Scenes through the C interface: keys, statuses, and handles that a failure leaves alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "owned_handles.hpp"

namespace scene_test {
namespace {

TEST(Library, NamesItsVersionAndEveryStatus) {
  EXPECT_STREQ(wrc_version(), WRCONTACT_EXPECTED_VERSION);
  std::set<std::string> names;
  for (wrc_status status = WRC_OK; status <= WRC_BUSY; ++status) {
    const std::string name = wrc_status_name(status);
    EXPECT_NE(name, "unknown status") << status;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
  EXPECT_STREQ(wrc_status_name(-1), "unknown status");
  EXPECT_STREQ(wrc_status_name(WRC_BUSY + 1), "unknown status");
}

TEST(SceneHandle, CreateRefusesNull) {
  EXPECT_EQ(wrc_scene_create(nullptr), WRC_INVALID_ARGUMENT);
  wrc_scene_destroy(nullptr);
}

TEST(SceneHandle, EveryFunctionRefusesANullHandle) {
  double value = 0.0;
  const char* text = nullptr;
  std::int64_t count = 0;
  EXPECT_EQ(wrc_scene_set_number(nullptr, "pose.lateral", 0.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_set_text(nullptr, "solve.side", "left"), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_set_numbers(nullptr, "solve.grid", &value, 1), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_solve(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_number(nullptr, "roll", &value), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_text(nullptr, "model", &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_field(nullptr, "left.x", &value, 1, &count), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_number_count(nullptr), 0);
  EXPECT_EQ(wrc_scene_number_name(nullptr, 0), nullptr);
  EXPECT_EQ(wrc_scene_text_count(nullptr), 0);
  EXPECT_EQ(wrc_scene_text_name(nullptr, 0), nullptr);
  EXPECT_TRUE(contains(wrc_scene_error(nullptr), "NULL"));
}

TEST(SceneHandle, NullArgumentsAreNamed) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  expect_null_told(s, wrc_scene_set_number(s, nullptr, 0.0), "key");
  expect_null_told(s, wrc_scene_set_text(s, nullptr, "left"), "key");
  expect_null_told(s, wrc_scene_set_text(s, "solve.side", nullptr), "value");
  const double grid[] = {8.0, 8.0};
  expect_null_told(s, wrc_scene_set_numbers(s, nullptr, grid, 2), "key");
  expect_null_told(s, wrc_scene_set_numbers(s, "solve.grid", nullptr, 2), "values");
  expect_error(s, wrc_scene_set_numbers(s, "solve.grid", grid, -1), WRC_INVALID_ARGUMENT,
               "count = -1");
  expect_error(s, wrc_scene_set_numbers(s, "solve.grid", nullptr, 0), WRC_INVALID_ARGUMENT,
               "solve.grid = []");

  solve(s);
  double value = 0.0;
  const char* text = nullptr;
  std::int64_t count = 0;
  expect_null_told(s, wrc_scene_number(s, nullptr, &value), "name");
  expect_null_told(s, wrc_scene_number(s, "roll", nullptr), "value");
  expect_null_told(s, wrc_scene_text(s, nullptr, &text), "name");
  expect_null_told(s, wrc_scene_text(s, "model", nullptr), "value");
  expect_null_told(s, wrc_scene_field(s, nullptr, &value, 1, &count), "name");
  expect_null_told(s, wrc_scene_field(s, "left.x", &value, 1, nullptr), "count");
  expect_null_told(s, wrc_scene_field(s, "left.x", nullptr, 1, &count), "values");
}

TEST(SceneHandle, ErrorTextIsClearedByTheNextSuccess) {
  const ScenePointer scene = make_scene();
  EXPECT_STREQ(wrc_scene_error(scene.get()), "");
  EXPECT_EQ(wrc_scene_set_number(scene.get(), "pose.lateral", 1e9), WRC_INVALID_ARGUMENT);
  EXPECT_STRNE(wrc_scene_error(scene.get()), "");
  set(scene.get(), {{"pose.lateral", 1.0}});
  EXPECT_STREQ(wrc_scene_error(scene.get()), "");
}

TEST(SceneKeys, AllHaveNameDefaultAllowedAndMeaning) {
  std::set<std::string> names;
  const std::int64_t count = wrc_scene_key_count();
  ASSERT_GT(count, 0);
  for (std::int64_t i = 0; i < count; ++i) {
    std::array<const char*, 4> texts{};
    ASSERT_EQ(wrc_scene_key(i, &texts[0], &texts[1], &texts[2], &texts[3]), WRC_OK);
    for (const char* text : texts) {
      ASSERT_NE(text, nullptr) << i;
      EXPECT_GT(std::string(text).size(), 0U) << texts[0];
    }
    EXPECT_TRUE(names.insert(texts[0]).second) << texts[0];
  }
  for (const std::string& key :
       words_of("track.gauge track.gauge_height track.inclination track.rail wheelset.wheel "
                "wheelset.back_to_back wheelset.tape_offset wheelset.radius "
                "material.youngs_modulus material.poisson material.wheel.youngs_modulus "
                "material.wheel.poisson material.rail.youngs_modulus material.rail.poisson "
                "pose.lateral pose.yaw pose.roll pose.vertical load.both load.left "
                "load.right load.of solve.side solve.method solve.model solve.accuracy "
                "solve.accuracy_of solve.grid solve.tolerance solve.threads")) {
    EXPECT_TRUE(names.contains(key)) << key;
  }
}

TEST(SceneKeys, IndexAndPointersAreChecked) {
  const char* text = nullptr;
  EXPECT_EQ(wrc_scene_key(-1, &text, &text, &text, &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_key(wrc_scene_key_count(), &text, &text, &text, &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_key(0, nullptr, &text, &text, &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_key(0, &text, nullptr, &text, &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_key(0, &text, &text, nullptr, &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_key(0, &text, &text, &text, nullptr), WRC_INVALID_ARGUMENT);
}

/// A default as it is told: a number, a text in quotes, or a list of zeros.
wrc_status set_default(wrc_scene* scene, const std::string& key, const std::string& value) {
  if (value.starts_with('"')) {
    return wrc_scene_set_text(scene, key.c_str(), value.substr(1, value.size() - 2).c_str());
  }
  if (value.starts_with("[0.0")) {
    const std::vector<double> zeros(static_cast<std::size_t>(std::ranges::count(value, ',')) + 1);
    return wrc_scene_set_numbers(scene, key.c_str(), zeros.data(), std::ssize(zeros));
  }
  return wrc_scene_set_number(scene, key.c_str(), std::stod(value));
}

TEST(SceneKeys, SettingEveryDefaultChangesNothing) {
  const ScenePointer untouched = make_small_scene();
  solve(untouched.get());
  const ScenePointer scene = make_scene();
  for (std::int64_t i = 0; i < wrc_scene_key_count(); ++i) {
    const char* name = nullptr;
    const char* value = nullptr;
    const char* allowed = nullptr;
    const char* meaning = nullptr;
    ASSERT_EQ(wrc_scene_key(i, &name, &value, &allowed, &meaning), WRC_OK);
    if (value == std::string("none") || name == std::string("solve.grid")) {
      continue; // no value stands for these
    }
    EXPECT_EQ(set_default(scene.get(), name, value), WRC_OK)
        << name << ": " << wrc_scene_error(scene.get());
  }
  solve(scene.get(), {{"solve.grid", std::vector{24.0, 20.0}}});
  for (const char* name : {"roll", "vertical", "left.pmax", "right.approach", "left.area"}) {
    EXPECT_EQ(number_of(scene.get(), name), number_of(untouched.get(), name)) << name;
  }
}

TEST(SceneKeys, AnUnknownKeyIsReportedWithTheKnownOnes) {
  const ScenePointer scene = make_scene();
  const double value = 1.0;
  expect_error(scene.get(), wrc_scene_set_number(scene.get(), "pose.latteral", 1.0),
               WRC_UNKNOWN_NAME, "pose.latteral", "pose.lateral");
  EXPECT_EQ(wrc_scene_set_text(scene.get(), "", "x"), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_scene_set_numbers(scene.get(), "grid", &value, 1), WRC_UNKNOWN_NAME);
}

TEST(SceneKeys, AWrongTypeIsRefusedWithTheKeyAndAllowedValues) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  const double grid[] = {8.0, 8.0};
  expect_error(s, wrc_scene_set_number(s, "solve.side", 1.0), WRC_INVALID_ARGUMENT,
               "solve.side = 1", "\"left\"");
  expect_error(s, wrc_scene_set_text(s, "pose.lateral", "3"), WRC_INVALID_ARGUMENT,
               "pose.lateral = \"3\"");
  EXPECT_EQ(wrc_scene_set_numbers(s, "pose.lateral", grid, 2), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_set_number(s, "solve.grid", 8.0), WRC_INVALID_ARGUMENT);
  expect_error(s, wrc_scene_set_text(s, "solve.side", "middle"), WRC_INVALID_ARGUMENT, "middle");
}

TEST(SceneKeys, ValuesOutOfRangeAreRefused) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {nan, infinity, -infinity, 1e300}) {
    for (std::int64_t i = 0; i < wrc_scene_key_count(); ++i) {
      const char* name = nullptr;
      const char* text = nullptr;
      ASSERT_EQ(wrc_scene_key(i, &name, &text, &text, &text), WRC_OK);
      EXPECT_EQ(wrc_scene_set_number(s, name, value), WRC_INVALID_ARGUMENT) << name;
    }
  }
  EXPECT_EQ(wrc_scene_set_number(s, "material.poisson", 0.500001), WRC_INVALID_ARGUMENT);
  set(s, {{"material.poisson", 0.5}});
  EXPECT_EQ(wrc_scene_set_number(s, "load.both", -1.0), WRC_INVALID_ARGUMENT);
  for (const auto& grid : {std::array{0.0, 8.0}, std::array{8.5, 8.0}, std::array{8.0, 8193.0},
                           std::array{nan, 8.0}}) {
    EXPECT_EQ(wrc_scene_set_numbers(s, "solve.grid", grid.data(), 2), WRC_INVALID_ARGUMENT);
  }
  const std::array three{8.0, 8.0, 8.0};
  EXPECT_EQ(wrc_scene_set_numbers(s, "solve.grid", three.data(), 3), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_set_text(s, "track.inclination", "1:0"), WRC_INVALID_ARGUMENT);
  set(s, {{"track.inclination", "1:20"}});
}

TEST(SceneKeys, AFailedCallDoesNotChangeTheScene) {
  const ScenePointer plain = make_small_scene();
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  const double grid[] = {0.0, 8.0};
  EXPECT_NE(wrc_scene_set_number(s, "pose.lateral", 2e4), WRC_OK);
  EXPECT_NE(wrc_scene_set_number(s, "load.both", -5.0), WRC_OK);
  EXPECT_NE(wrc_scene_set_text(s, "solve.side", "none"), WRC_OK);
  EXPECT_NE(wrc_scene_set_text(s, "track.rail", ""), WRC_OK);
  EXPECT_NE(wrc_scene_set_numbers(s, "solve.grid", grid, 2), WRC_OK);
  solve(s);
  solve(plain.get());
  EXPECT_EQ(number_of(s, "left.pmax"), number_of(plain.get(), "left.pmax"));
  EXPECT_EQ(number_of(s, "right.pmax"), number_of(plain.get(), "right.pmax"));
}

TEST(SceneKeys, LaterSettingsOfASubjectReplaceEarlierOnes) {
  constexpr double load_balance = 1e-9; // the load is met exactly but for rounding
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"load.both", 60000.0}, {"load.left", 50000.0}});
  EXPECT_NEAR(number_of(s, "left.vertical_force"), 50000.0, 50000.0 * load_balance);
  EXPECT_NEAR(number_of(s, "right.vertical_force"), 60000.0, 60000.0 * load_balance);
  solve(s, {{"load.both", 70000.0}});
  EXPECT_NEAR(number_of(s, "left.vertical_force"), 70000.0, 70000.0 * load_balance);
  solve(s, {{"load.both", 40000.0}, {"load.of", "normal"}});
  EXPECT_NEAR(number_of(s, "left.normal_force"), 40000.0, 40000.0 * load_balance);
}

TEST(SceneExtremes, LoadsIndistinguishableFromZeroGiveNoContact) {
  const ScenePointer scene = make_small_scene();
  // On steel the boundary is near 2e-7 N.
  for (const double load : {5e-324, 1e-300, 1e-30, 1e-12, 1e-7}) {
    solve(scene.get(), {{"load.both", load}});
    EXPECT_EQ(number_of(scene.get(), "left.normal_force"), 0.0) << load;
    const char* warning = nullptr;
    ASSERT_EQ(wrc_scene_text(scene.get(), "left.warnings.0", &warning), WRC_OK);
    EXPECT_TRUE(contains(warning, "treated as zero load")) << warning;
  }
  for (const double load : {1e-6, 1e-3}) {
    solve(scene.get(), {{"load.both", load}});
    EXPECT_NEAR(number_of(scene.get(), "left.vertical_force"), load, 1e-6 * load);
  }
}

TEST(SceneExtremes, AnAbsurdOverlapIsRefused) {
  const ScenePointer scene = make_small_scene();
  for (const double load : {1e9, 1e10, 1e12}) {
    set(scene.get(), {{"load.both", load}});
    EXPECT_EQ(wrc_scene_solve(scene.get()), WRC_INVALID_ARGUMENT) << load;
    EXPECT_TRUE(contains(wrc_scene_error(scene.get()), "50 mm")) << wrc_scene_error(scene.get());
  }
  solve(scene.get(), {{"load.both", 5e8}});
  EXPECT_NEAR(number_of(scene.get(), "left.vertical_force"), 5e8, 500.0);
  set(scene.get(), {{"pose.vertical", 409.0}});
  expect_error(scene.get(), wrc_scene_solve(scene.get()), WRC_INVALID_ARGUMENT,
               "pose.vertical = 409");
  solve(scene.get(), {{"pose.vertical", 411.0}});
}

} // namespace
} // namespace scene_test
