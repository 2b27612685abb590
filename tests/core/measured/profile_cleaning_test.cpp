// Each step of the cleaning takes away what it is for, says so, and leaves the rest.
#include "measured/profile_cleaning.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "support/errors.hpp"

namespace wrc::test::profile_cleaning_test {
namespace {

using namespace reading;

RawProfile raw_of(std::vector<Position> points) {
  RawProfile raw;
  raw.points = std::move(points);
  return raw;
}

TEST(ProfileCleaning, OnlyCoincidentPointsAreDuplicates) {
  Log log("file", false);
  RawProfile raw = raw_of({{0, 0}, {1, 0}, {1.005, 0}, {1.02, 0}, {2, 0}, {3, 0}});
  remove_doubles(raw, 0.01, log);
  const std::vector<Position> expected{{0, 0}, {1, 0}, {1.02, 0}, {2, 0}, {3, 0}};
  EXPECT_EQ(raw.points, expected);
  EXPECT_EQ(log.corrections().size(), 1U);
  remove_doubles(raw, 0.01, log);
  EXPECT_EQ(log.corrections().size(), 1U) << "nothing left to say";
}

TEST(ProfileCleaning, SinglePointsOffTheLineAreRemovedAndKeptForPictures) {
  Log log("file", false);
  std::vector<Position> points = rail_points();
  const std::vector<Position> clean = points;
  points.insert(points.begin() + 12, {points[12][0] - 1.0, points[12][1] + 6.0});
  const Position outlier = points[12];
  RawProfile raw = raw_of(points);
  remove_outliers(raw, log);
  EXPECT_EQ(raw.points, clean);
  ASSERT_EQ(raw.dropped.size(), 1U);
  EXPECT_EQ(raw.dropped.front(), outlier);
  EXPECT_EQ(log.guesses(), 1U) << "6 mm are no scatter";
}

/// A line that runs to its end and back beside itself is no profile.
TEST(ProfileCleaning, TwoScansThatDoNotFitAreNotPutInOrder) {
  for (const double apart : {0.5, 1.5}) {
    Log log("file", false);
    std::vector<Position> points;
    for (int i = 0; i < 200; ++i) {
      points.push_back({0.25 * i, 0.0});
      points.push_back({0.25 * i, apart});
    }
    RawProfile raw = raw_of(points);
    order_points(raw, log);
    EXPECT_EQ(raw.points, points) << apart;
    // One behind the other, both from the same end.
    std::ranges::stable_sort(points, {}, [](const Position& point) { return point[1]; });
    raw = raw_of(points);
    order_points(raw, log);
    EXPECT_EQ(raw.points, points) << apart;
  }
}

TEST(ProfileCleaning, ACornerIsNotAnOutlier) {
  Log log("file", false);
  std::vector<Position> points;
  for (int i = 0; i <= 20; ++i) {
    points.push_back({1.0 * i, i <= 10 ? 0.0 : -4.0 * (i - 10)});
  }
  RawProfile raw = raw_of(points);
  remove_outliers(raw, log);
  EXPECT_EQ(raw.points, points);
  EXPECT_TRUE(log.corrections().empty());
}

TEST(ProfileCleaning, DeepEndsAreCutOff) {
  Log log("file", false);
  std::vector<Position> points = rail_points();
  const std::size_t head = points.size();
  for (int i = 1; i <= 5; ++i) { // the web below both sides
    points.insert(points.begin(), {-10.0, -38.0 - 8.0 * i});
    points.push_back({10.0, -38.0 - 8.0 * i});
  }
  RawProfile raw = raw_of(points);
  cut_ends(raw, ProfileKind::rail, log);
  EXPECT_GE(raw.points.size(), head);
  for (const Position& point : raw.points) {
    EXPECT_GT(point[1], -41.0);
  }
  EXPECT_EQ(raw.points.size() + raw.dropped.size(), points.size());
}

/// An ellipse tells no running surface; that of a whole rail is opened at its foot.
TEST(ProfileCleaning, ClosedOutlinesAreOpenedOrRefused) {
  Log log("file", false);
  std::vector<Position> ring;
  for (int i = 0; i <= 40; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 40.0;
    ring.push_back({30.0 * std::cos(t), 20.0 * std::sin(t)});
  }
  ring.back() = ring.front();
  RawProfile raw = raw_of(ring);
  expect_error(
      ErrorCode::file_malformed, [&] { open_outline(raw, std::nullopt, log); }, "closed");
  std::vector<Position> head = rail_points();
  const std::vector<Position> open = head;
  head.push_back(head.front()); // closed by one long side
  RawProfile closed = raw_of(head);
  open_outline(closed, ProfileKind::rail, log);
  EXPECT_EQ(closed.points, open);
}

} // namespace
} // namespace wrc::test::profile_cleaning_test
