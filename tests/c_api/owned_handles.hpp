/// Handles that clean up after themselves, and files in a folder of the test's own (several builds
/// may be tested at once).
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>

#include <unistd.h>

#include <gtest/gtest.h>

#include "wrcontact.h"

using ScenePointer = std::unique_ptr<wrc_scene, void (*)(wrc_scene*)>;
using NormalPointer = std::unique_ptr<wrc_normal, void (*)(wrc_normal*)>;
using ProfilePointer = std::unique_ptr<wrc_profile, void (*)(wrc_profile*)>;

inline ScenePointer make_scene() {
  wrc_scene* scene = nullptr;
  EXPECT_EQ(wrc_scene_create(&scene), WRC_OK);
  return {scene, wrc_scene_destroy};
}

/// A scene on a small grid, which is solved in milliseconds.
inline ScenePointer make_small_scene() {
  ScenePointer scene = make_scene();
  const double grid[] = {24.0, 20.0};
  EXPECT_EQ(wrc_scene_set_numbers(scene.get(), "solve.grid", grid, 2), WRC_OK);
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

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
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
