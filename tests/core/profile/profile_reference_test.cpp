/// Built-in profiles and readers against published files, which stand outside the project.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "nearest.hpp"
#include "profile/reader_formats.hpp"
#include "profile/readers.hpp"

namespace wrc::test::profile_reference_test {
namespace {

const std::filesystem::path reference = WRCONTACT_REFERENCE_DIR;

#define NEEDS(file)                                                                                \
  if (!std::filesystem::exists(reference / (file)))                                                \
  GTEST_SKIP() << "reference file " << (reference / (file)) << " is not there"

/// Keeps every point of the files.
ReadOptions all_points() {
  ReadOptions options;
  options.least_point_distance = 1e-9;
  return options;
}

std::string content_of(const std::string& file) {
  std::ifstream stream(reference / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The points of a Simpack file, height of a rail upwards, without the spline between them.
std::vector<Position> simpack_points(const std::string& file, double up) {
  reading::Log log(file, true);
  std::vector<Position> points = reading::read_simpack(content_of(file), log).points;
  for (Position& point : points)
    point[1] *= up;
  return points;
}

/// The files print eight digits: half a unit of the last is 5e-7 mm in each coordinate.
constexpr double rounding = 1e-6;

TEST(ReferenceProfiles, S1002MeetsTheManchesterPoints) {
  NEEDS("MBench_S1002_v3.prw");
  const ReadResult read = read_profile(reference / "MBench_S1002_v3.prw", all_points());
  EXPECT_EQ(read.profile.kind, ProfileKind::wheel);
  EXPECT_NE(read.profile.title.find("S1002"), std::string::npos);
  const Curve standard = standard_profile("S1002").curve;
  double largest = 0.0;
  std::size_t count = 0;
  for (const Position& point : simpack_points("MBench_S1002_v3.prw", 1.0)) {
    largest = std::max(largest, distance_from(standard, point));
    EXPECT_LT(distance_from(read.profile.curve, point), 1e-12); // arithmetic of the curve
    ++count;
  }
  EXPECT_EQ(count, 399U); // the first of 400 is commented out
  EXPECT_LT(read.profile.curve.at(0.0).lateral, -69.0);
  EXPECT_NEAR(read.profile.curve.at(read.profile.curve.length()).lateral, 60.0, rounding);
  EXPECT_LT(largest, 1e-5);
  RecordProperty("largest_distance_pm", static_cast<int>(largest * 1e9));
}

TEST(ReferenceProfiles, S1002FileHasNoGuesses) {
  NEEDS("MBench_S1002_v3.prw");
  ReadOptions options;
  options.strict = true;
  const ReadResult read = read_profile(reference / "MBench_S1002_v3.prw", options);
  const auto says = [&](const std::string& text) {
    return std::any_of(read.corrections.begin(), read.corrections.end(),
                       [&](const std::string& line) { return line.find(text) == 0; });
  };
  EXPECT_TRUE(says("lateral mirrored as mirror.y = 1 requests"));
  EXPECT_TRUE(says("order reversed as inversion = 1 requests"));
}

TEST(ReferenceProfiles, Uic60MeetsTheManchesterPoints) {
  NEEDS("MBench_UIC60_v3.prr");
  const Curve read = read_profile(reference / "MBench_UIC60_v3.prr", all_points()).profile.curve;
  // The file holds the profile shifted by (-7.491702, -0.093557), depth downwards, then inclined
  // 1:40 towards the gauge side.
  const Curve standard = standard_profile("UIC60-Manchester")
                             .curve.moved(0.0, -7.491702, 0.093557)
                             .moved(std::atan(1.0 / 40.0), 0.0, 0.0);
  double largest = 0.0;
  std::size_t count = 0;
  for (const Position& point : simpack_points("MBench_UIC60_v3.prr", -1.0)) {
    EXPECT_LT(distance_from(read, point), 1e-12); // arithmetic of the curve
    if (-point[1] >= 34.0)
      continue; // corner of the file's source, which is not modelled
    largest = std::max(largest, distance_from(standard, point));
    ++count;
  }
  EXPECT_GE(count, 380U);
  EXPECT_LT(largest, 1e-4);
  RecordProperty("largest_distance_pm", static_cast<int>(largest * 1e9));
}

TEST(ReferenceProfiles, MiniprofFileHoldsTheSimpackPoints) {
  NEEDS("MBench_UIC60_v3.ban");
  NEEDS("MBench_UIC60_v3.prr");
  const ReadResult ban = read_profile(reference / "MBench_UIC60_v3.ban", all_points());
  const Curve prr = read_profile(reference / "MBench_UIC60_v3.prr", all_points()).profile.curve;
  EXPECT_EQ(ban.profile.kind, ProfileKind::rail);
  reading::Log log("ban", false);
  const reading::RawProfile raw = reading::read_miniprof(content_of("MBench_UIC60_v3.ban"), log);
  EXPECT_GE(raw.points.size(), 476U); // 495, of which 19 are quoted
  for (const Position& point : raw.points)
    EXPECT_LT(distance_from(prr, {-point[0], -point[1]}), 1e-12);
  const auto says = [&](const std::string& text) {
    return std::any_of(ban.corrections.begin(), ban.corrections.end(),
                       [&](const std::string& line) { return line.find(text) != line.npos; });
  };
  EXPECT_TRUE(says("19 rows after the header skipped as comments"));
  EXPECT_TRUE(says("rail head bulged down"));
  EXPECT_TRUE(says("XYPoints"));
}

TEST(ReferenceProfiles, MiniprofHeightIsAGuessThatStrictReadingRefuses) {
  NEEDS("MBench_UIC60_v3.ban");
  ReadOptions options;
  options.strict = true;
  EXPECT_THROW((void)read_profile(reference / "MBench_UIC60_v3.ban", options), Error);
  options.mirror_height = true;
  EXPECT_NO_THROW((void)read_profile(reference / "MBench_UIC60_v3.ban", options));
}

} // namespace
} // namespace wrc::test::profile_reference_test
