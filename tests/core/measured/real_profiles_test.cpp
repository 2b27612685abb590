/// Measured profiles: kind, signs, side and origin as their list says. The points of the wheels are
/// in tests/reference; the files as they were distributed, read in strict mode too where the format
/// states what is needed, are not part of the project.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "measured/profile_shape.hpp"
#include "measured/readers.hpp"
#include "scene/solve_scene.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::real_profiles_test {
namespace {

struct RealFile {
  const char* file;
  ProfileKind kind;
  bool strict;          ///< the format states all that is needed, and noise is short
  Position lateral;     ///< of the profile, to 0.5 mm
  Position height;      ///< to 0.5 mm
  Position top_lateral; ///< where the flange tip or the crown is

  friend void PrintTo(const RealFile& real, std::ostream* out) { *out << real.file; }
};

/// From the list of the files: raw coordinates, turned and shifted as it says. Of a wheel that
/// counts from its flange back 70 mm are the taping line.
const RealFile real_files[] = {
    {"Car7216_0001r.whl", ProfileKind::wheel, true, {-70.2, 61.4}, {-22.1, 27.8}, {-56, -53}},
    {"Car7358_0001r.whl", ProfileKind::wheel, true, {-70.2, 61.9}, {-23.0, 27.0}, {-56, -52}},
    {"left-wheel-v1-pre-dry.whl",
     ProfileKind::wheel,
     true,
     {-69.9, 73.3},
     {-12.2, 28.2},
     {-53, -49}},
    {"whl_left_iter288.whl", ProfileKind::wheel, true, {-70.2, 75.1}, {-21.5, 28.4}, {-51, -47}},
    {"avg_wheel.whl", ProfileKind::wheel, false, {-68.5, 69.7}, {-32.3, 28.0}, {-56, -51}},
    {"worn_high_mileage.prw", ProfileKind::wheel, false, {-66.1, 73.4}, {-3.0, 35.4}, {-51, -47}},
    {"circ_r100.prw", ProfileKind::wheel, true, {-50, 50}, {-13.4, 0}, {-0.1, 0.1}},
    {"groove_r1025.prr", ProfileKind::rail, false, {-20.6, 20.6}, {0, 10.25}, {-20.6, 20.6}},
    {"avg_HR.BAN", ProfileKind::rail, false, {-46.6, 11.7}, {-25.4, -0.2}, {-9, -3}},
    {"avg_low2.ban", ProfileKind::rail, false, {-25.6, 54.1}, {-33.8, -0.2}, {19, 23}},
    {"rail_left_iter288.ban", ProfileKind::rail, true, {-37.3, 36.4}, {-37.3, -1.7}, {17, 23}},
    {"left-roller-v1-pre-dry.ban", ProfileKind::rail, true, {-38, 36.1}, {-31.2, 0.3}, {8, 14}},
    {"guard_rail_test.ban", ProfileKind::rail, true, {-130.6, 67.3}, {-49, 0}, {-126, -125}},
    {"site_b_hr.prr", ProfileKind::rail, true, {-36.9, 36.8}, {-37.9, 0}, {15, 22}},
};

void expect_as_listed(const RealFile& file, const Profile& profile) {
  EXPECT_EQ(profile.kind, file.kind);
  for (std::size_t i = 0; i < 2; ++i) {
    const Position extent = reading::extent_of(profile.points, i);
    const Position& expected = i == 0 ? file.lateral : file.height;
    EXPECT_NEAR(extent[0], expected[0], 0.5);
    EXPECT_NEAR(extent[1], expected[1], 0.5);
  }
  const Position top =
      *std::max_element(profile.points.begin(), profile.points.end(),
                        [](const Position& a, const Position& b) { return a[1] < b[1]; });
  EXPECT_GE(top[0], file.top_lateral[0]);
  EXPECT_LE(top[0], file.top_lateral[1]);
}

/// The points of a wheel's file in columns.
std::filesystem::path columns_of(const RealFile& file) {
  return reference_file("profiles/" + std::filesystem::path(file.file).stem().string() + ".txt");
}

ReadResult read_columns_of(const RealFile& file) {
  ReadOptions options;
  options.kind = file.kind;
  return read_profile(columns_of(file), options);
}

/// Whether a profile's warnings say that it is none of a rail.
bool seems_a_wheel(const Profile& profile) {
  return std::any_of(profile.warnings.begin(), profile.warnings.end(), [](const Warning& warning) {
    return warning.text.find("the shape is that of a wheel") != std::string::npos;
  });
}

class RealFiles : public ::testing::TestWithParam<RealFile> {};

TEST_P(RealFiles, AreReadAsTheirListStates) {
  const RealFile& file = GetParam();
  const std::string name = std::string("real_profiles/") + file.file;
  WRC_NEEDS_ORIGINAL(name);
  const ReadResult read = read_profile(original_file(name));
  expect_as_listed(file, read.profile);
  if (file.kind == ProfileKind::wheel) {
    EXPECT_EQ(read.profile.points, read_columns_of(file).profile.points);
  }
  EXPECT_FALSE(seems_a_wheel(read.profile));

  ReadOptions options;
  options.strict = true;
  try {
    (void)read_profile(original_file(name), options);
    EXPECT_TRUE(file.strict);
  } catch (const Error& error) {
    EXPECT_FALSE(file.strict) << error.what();
  }
}

class RealWheels : public ::testing::TestWithParam<RealFile> {};

TEST_P(RealWheels, AreReadAsTheirListStates) {
  expect_as_listed(GetParam(), read_columns_of(GetParam()).profile);
}

TEST_P(RealWheels, ShowIfTheyAreGivenAsARail) {
  ReadOptions options;
  options.kind = ProfileKind::rail;
  const bool is_disc = std::string(GetParam().file) == "circ_r100.prw";
  EXPECT_NE(seems_a_wheel(read_profile(columns_of(GetParam()), options).profile), is_disc);
}

/// Centre height of a wheelset of nominal radius 460 whose wheels touch with their treads, mm.
constexpr double tread_tolerance = 3.0;

TEST_P(RealWheels, TouchTheRailWithTheirTreads) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = columns_of(GetParam()).string();
  scene.until = Module::geometry;
  const SceneResult result = solve_scene(scene);
  EXPECT_NEAR(result.vertical, 460.0, tread_tolerance);
  EXPECT_TRUE(result.left->warnings.empty()) << result.left->warnings.front().text;
}

std::vector<RealFile> wheels() {
  std::vector<RealFile> found;
  std::copy_if(std::begin(real_files), std::end(real_files), std::back_inserter(found),
               [](const RealFile& file) { return file.kind == ProfileKind::wheel; });
  return found;
}

std::string name_of(const testing::TestParamInfo<RealFile>& instance) {
  std::string name = std::filesystem::path(instance.param.file).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, RealFiles, ::testing::ValuesIn(real_files), name_of);
INSTANTIATE_TEST_SUITE_P(Files, RealWheels, ::testing::ValuesIn(wheels()), name_of);

} // namespace
} // namespace wrc::test::real_profiles_test
