/// Measured profiles as they were distributed, which stand outside the project: kind, signs, side
/// and origin as their list says, in strict mode where the format states them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/profile_shape.hpp"
#include "profile/readers.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::real_profiles_test {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(WRCONTACT_REFERENCE_DIR) / "real_profiles";

struct RealFile {
  const char* file;
  ProfileKind kind;
  bool strict;          ///< the format states all that is needed
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
    {"avg_wheel.whl", ProfileKind::wheel, true, {-68.5, 69.7}, {-32.3, 28.0}, {-56, -51}},
    {"worn_high_mileage.prw", ProfileKind::wheel, false, {-66.1, 73.4}, {-3.0, 35.4}, {-51, -47}},
    {"circ_r100.prw", ProfileKind::wheel, false, {-50, 50}, {-13.4, 0}, {-0.1, 0.1}},
    {"groove_r1025.prr", ProfileKind::rail, false, {-20.6, 20.6}, {0, 10.25}, {-20.6, 20.6}},
    {"avg_HR.BAN", ProfileKind::rail, true, {-46.6, 11.7}, {-25.4, -0.2}, {-9, -3}},
    {"avg_low2.ban", ProfileKind::rail, true, {-25.6, 54.1}, {-33.8, -0.2}, {19, 23}},
    {"rail_left_iter288.ban", ProfileKind::rail, true, {-37.3, 36.4}, {-37.3, -1.7}, {17, 23}},
    {"left-roller-v1-pre-dry.ban", ProfileKind::rail, true, {-38, 36.1}, {-31.2, 0.3}, {8, 14}},
    {"guard_rail_test.ban", ProfileKind::rail, true, {-130.6, 67.3}, {-49, 0}, {-126, -125}},
    {"site_b_hr.prr", ProfileKind::rail, true, {-36.9, 36.8}, {-37.9, 0}, {15, 22}},
};

class RealProfiles : public ::testing::TestWithParam<RealFile> {
protected:
  void SetUp() override {
    if (!std::filesystem::exists(path()))
      GTEST_SKIP() << "reference file " << path() << " is not there";
  }
  [[nodiscard]] static std::filesystem::path path() { return folder / GetParam().file; }
};

TEST_P(RealProfiles, AreReadAsTheirListSays) {
  const RealFile& file = GetParam();
  const ReadResult read = read_profile(path());
  EXPECT_EQ(read.profile.kind, file.kind);
  for (std::size_t i = 0; i < 2; ++i) {
    const Position extent = reading::extent_of(read.profile.points, i);
    const Position& expected = i == 0 ? file.lateral : file.height;
    EXPECT_NEAR(extent[0], expected[0], 0.5);
    EXPECT_NEAR(extent[1], expected[1], 0.5);
  }
  const Position top =
      *std::max_element(read.profile.points.begin(), read.profile.points.end(),
                        [](const Position& a, const Position& b) { return a[1] < b[1]; });
  EXPECT_GE(top[0], file.top_lateral[0]);
  EXPECT_LE(top[0], file.top_lateral[1]);
}

TEST_P(RealProfiles, PassStrictReadingWhereTheFormatStatesThem) {
  ReadOptions options;
  options.strict = true;
  try {
    (void)read_profile(path(), options);
    EXPECT_TRUE(GetParam().strict);
  } catch (const Error& error) {
    EXPECT_FALSE(GetParam().strict) << error.what();
  }
}

/// Centre height of a wheelset of nominal radius 460 whose wheels touch with their treads, mm.
constexpr double tread_tolerance = 3.0;

TEST_P(RealProfiles, WheelsTouchTheRailWithTheirTreads) {
  if (GetParam().kind != ProfileKind::wheel)
    GTEST_SKIP() << "a rail";
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = path().string();
  scene.until = Module::geometry;
  const SceneResult result = solve_scene(scene);
  EXPECT_NEAR(result.vertical, 460.0, tread_tolerance);
  EXPECT_TRUE(result.left->warnings.empty()) << result.left->warnings.front();
}

INSTANTIATE_TEST_SUITE_P(Files, RealProfiles, ::testing::ValuesIn(real_files),
                         [](const auto& instance) {
                           std::string name =
                               std::filesystem::path(instance.param.file).stem().string();
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

} // namespace
} // namespace wrc::test::real_profiles_test
