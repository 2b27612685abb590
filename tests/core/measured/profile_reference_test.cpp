/// Built-in profiles against the points of the Manchester benchmark (tests/reference), and readers
/// against its files, which are not part of the project.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "measured/reader_formats.hpp"
#include "measured/readers.hpp"
#include "nearest.hpp"
#include "samples.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::profile_reference_test {
namespace {

constexpr const char* s1002_columns = "profiles/S1002-Manchester.txt";
constexpr const char* uic60_columns = "profiles/UIC60-Manchester.txt";

/// Keeps every point of the files.
ReadOptions all_points() {
  ReadOptions options;
  options.least_point_distance = 1e-9;
  return options;
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The points of a file in columns, without the spline between them.
std::vector<Position> points_of(const std::string& file) {
  reading::Log log(file, true);
  return reading::read_columns(content_of(reference_file(file)), log).points;
}

void expect_on(const Curve& curve, const std::vector<Position>& points) {
  for (const Position& point : points) {
    EXPECT_LT(distance_from(curve, point), 1e-12); // arithmetic of the curve
  }
}

/// The points have eight digits: half a unit of the last is 5e-7 mm in each coordinate.
constexpr double rounding = 1e-6;

TEST(ReferenceProfiles, S1002MeetsTheManchesterPoints) {
  const std::vector<Position> points = points_of(s1002_columns);
  EXPECT_EQ(points.size(), 399U);
  const Curve standard = standard_profile("S1002").curve;
  double largest = 0.0;
  for (const Position& point : points)
    largest = std::max(largest, distance_from(standard, point));
  EXPECT_LT(largest, 1e-5);
  RecordProperty("largest_distance_pm", static_cast<int>(largest * 1e9));

  const Curve read = read_profile(reference_file(s1002_columns), all_points()).profile.curve;
  expect_on(read, points);
  EXPECT_LT(read.at(0.0).lateral, -69.0);
  EXPECT_NEAR(read.at(read.length()).lateral, 60.0, rounding);
}

TEST(ReferenceProfiles, Uic60MeetsTheManchesterPoints) {
  const std::vector<Position> points = points_of(uic60_columns);
  expect_on(read_profile(reference_file(uic60_columns), all_points()).profile.curve, points);
  // They are the profile shifted by (-7.491702, -0.093557), depth downwards, then inclined 1:40
  // towards the gauge side.
  const Curve standard = standard_profile("UIC60-Manchester")
                             .curve.moved(0.0, -7.491702, 0.093557)
                             .moved(std::atan(1.0 / 40.0), 0.0, 0.0);
  double largest = 0.0;
  std::size_t count = 0;
  for (const Position& point : points) {
    if (-point[1] >= 34.0)
      continue; // corner of the points' source, which is not modelled
    largest = std::max(largest, distance_from(standard, point));
    ++count;
  }
  EXPECT_GE(count, 380U);
  EXPECT_LT(largest, 1e-4);
  RecordProperty("largest_distance_pm", static_cast<int>(largest * 1e9));
}

TEST(ReferenceFiles, SimpackWheelIsReadAsItsHeaderStates) {
  WRC_NEEDS_ORIGINAL("MBench_S1002_v3.prw");
  ReadOptions options = all_points();
  options.strict = true;
  const ReadResult read = read_profile(original_file("MBench_S1002_v3.prw"), options);
  EXPECT_EQ(read.profile.kind, ProfileKind::wheel);
  EXPECT_NE(read.profile.title.find("S1002"), std::string::npos);
  EXPECT_TRUE(says(read, "lateral mirrored as mirror.y = 1 requests"));
  EXPECT_TRUE(says(read, "order reversed as inversion = 1 requests"));
  // The first of 400 points is commented out.
  EXPECT_EQ(read.profile.points, points_of(s1002_columns));
}

TEST(ReferenceFiles, SimpackRailIsReadAsItsHeaderStates) {
  WRC_NEEDS_ORIGINAL("MBench_UIC60_v3.prr");
  const ReadResult read = read_profile(original_file("MBench_UIC60_v3.prr"), all_points());
  EXPECT_EQ(read.profile.kind, ProfileKind::rail);
  EXPECT_EQ(read.profile.points, points_of(uic60_columns));
}

TEST(ReferenceFiles, MiniprofFileHoldsTheSimpackPoints) {
  WRC_NEEDS_ORIGINAL("MBench_UIC60_v3.ban");
  const std::filesystem::path file = original_file("MBench_UIC60_v3.ban");
  const ReadResult ban = read_profile(file, all_points());
  const Curve simpack = read_profile(reference_file(uic60_columns), all_points()).profile.curve;
  EXPECT_EQ(ban.profile.kind, ProfileKind::rail);
  reading::Log log("ban", false);
  const reading::RawProfile raw = reading::read_miniprof(content_of(file), 0, log);
  EXPECT_GE(raw.points.size(), 476U); // 495, of which 19 are quoted
  for (const Position& point : raw.points)
    EXPECT_LT(distance_from(simpack, {-point[0], -point[1]}), 1e-12);
  EXPECT_TRUE(says(ban, "19 rows after the header skipped as comments"));
  EXPECT_TRUE(says(ban, "rail head bulged down"));
  EXPECT_TRUE(says(ban, "XYPoints"));
}

TEST(ReferenceFiles, MiniprofHeightIsAGuessThatStrictReadingRefuses) {
  WRC_NEEDS_ORIGINAL("MBench_UIC60_v3.ban");
  ReadOptions options;
  options.strict = true;
  EXPECT_THROW((void)read_profile(original_file("MBench_UIC60_v3.ban"), options), Error);
  options.mirror_height = true;
  EXPECT_NO_THROW((void)read_profile(original_file("MBench_UIC60_v3.ban"), options));
}

} // namespace
} // namespace wrc::test::profile_reference_test
