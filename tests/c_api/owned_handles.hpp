/// Handles that clean up after themselves, and files in a folder of the test's own (several builds
/// may be tested at once).
#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "extent.hpp"
#include "wrcontact.h"

using wrc::test::by_extent;
using wrc::test::some_of;

using ScenePointer = std::unique_ptr<wrc_scene, void (*)(wrc_scene*)>;
using NormalPointer = std::unique_ptr<wrc_normal, void (*)(wrc_normal*)>;
using ProfilePointer = std::unique_ptr<wrc_profile, void (*)(wrc_profile*)>;

inline ScenePointer make_scene() {
  wrc_scene* scene = nullptr;
  EXPECT_EQ(wrc_scene_create(&scene), WRC_OK);
  return {scene, wrc_scene_destroy};
}

using Value = std::variant<double, const char*, std::vector<double>>;
using Values = std::initializer_list<std::pair<const char*, Value>>;

inline wrc_status set_value(wrc_scene* scene, const char* key, const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return wrc_scene_set_number(scene, key, *number);
  }
  if (const auto* text = std::get_if<const char*>(&value)) {
    return wrc_scene_set_text(scene, key, *text);
  }
  const auto& all = std::get<std::vector<double>>(value);
  return wrc_scene_set_numbers(scene, key, all.data(), static_cast<std::int64_t>(all.size()));
}

inline void set(wrc_scene* scene, Values values) {
  for (const auto& [key, value] : values) {
    EXPECT_EQ(set_value(scene, key, value), WRC_OK) << key << ": " << wrc_scene_error(scene);
  }
}

/// Sets the values and solves.
inline void solve(wrc_scene* scene, Values values = {}) {
  set(scene, values);
  EXPECT_EQ(wrc_scene_solve(scene), WRC_OK) << wrc_scene_error(scene);
}

/// A scene on a small grid, which is solved in milliseconds.
inline ScenePointer make_small_scene() {
  ScenePointer scene = make_scene();
  set(scene.get(), {{"solve.grid", std::vector{24.0, 20.0}}});
  return scene;
}

inline NormalPointer make_normal() {
  wrc_normal* normal = nullptr;
  EXPECT_EQ(wrc_normal_create(&normal), WRC_OK);
  return {normal, wrc_normal_destroy};
}

inline ProfilePointer make_profile() {
  wrc_profile* profile = nullptr;
  EXPECT_EQ(wrc_profile_create(&profile), WRC_OK);
  return {profile, wrc_profile_destroy};
}

inline double number_of(wrc_scene* scene, const char* name) {
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(scene, name, &value), WRC_OK) << name;
  return value;
}

inline std::vector<std::string> words_of(const char* text) {
  std::istringstream from(text);
  return {std::istream_iterator<std::string>(from), {}};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::string error_of(const wrc_scene* handle) {
  return wrc_scene_error(handle);
}
inline std::string error_of(const wrc_normal* handle) {
  return wrc_normal_error(handle);
}
inline std::string error_of(const wrc_rolling* handle) {
  return wrc_rolling_error(handle);
}
inline std::string error_of(const wrc_profile* handle) {
  return wrc_profile_error(handle);
}

/// A call on a handle that failed as it should, with a text that has these parts.
template <class Handle, class... Parts>
void expect_error(const Handle* handle, wrc_status status, wrc_status expected,
                  const Parts&... parts) {
  EXPECT_EQ(status, expected) << error_of(handle);
  for (const std::string& part : {std::string(parts)...}) {
    EXPECT_TRUE(contains(error_of(handle), part)) << part << " is not in: " << error_of(handle);
  }
}

/// Plans lines of this length, doubled and rounded up, unless the process has.
inline void plan_length(std::int64_t length) {
  const NormalPointer normal = make_normal();
  const std::vector<double> gap(static_cast<std::size_t>(4 * length), 0.0);
  EXPECT_EQ(wrc_normal_set_grid(normal.get(), length, 4, 0.1, 0.1), WRC_OK);
  EXPECT_EQ(wrc_normal_set_distance(normal.get(), gap.data(), 4 * length), WRC_OK);
  EXPECT_EQ(wrc_normal_set_number(normal.get(), "approach", 1e-3), WRC_OK);
  EXPECT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
}

/// The same for an argument that must not be NULL.
template <class Handle>
void expect_null_told(const Handle* handle, wrc_status status, const char* argument) {
  expect_error(handle, status, WRC_INVALID_ARGUMENT, std::string(argument) + " = NULL");
}

class WithFolder : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("wrcontact_") + test->test_suite_name() + '_' + test->name() + '_' +
               std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
    return path(name);
  }

private:
  std::filesystem::path folder_;
};
