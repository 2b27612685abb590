// From raw points to the frame of a profile: kind, units, signs, order and origin.
#include "measured/settling.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "support/errors.hpp"

namespace wrc::test::settling_test {
namespace {

using namespace reading;

Settled settled(const std::vector<Position>& points, ProfileKind kind, Log& log,
                const ReadOptions& options = {}) {
  RawProfile raw;
  raw.points = points;
  raw.kind = kind;
  return settle(raw, options, log);
}

double largest_difference(const std::vector<Position>& found,
                          const std::vector<Position>& expected) {
  EXPECT_EQ(found.size(), expected.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    largest = std::max(
        {largest, std::abs(found[i][0] - expected[i][0]), std::abs(found[i][1] - expected[i][1])});
  }
  return largest;
}

TEST(Settling, PointsInTheFrameAreUnchangedWithoutAMessage) {
  Log log("file", true);
  const Settled wheel = settled(wheel_points(), ProfileKind::wheel, log);
  EXPECT_EQ(wheel.kind, ProfileKind::wheel);
  EXPECT_EQ(largest_difference(wheel.points, wheel_points()), 0.0);
  EXPECT_TRUE(log.corrections().empty());
  EXPECT_TRUE(wheel.dropped.empty());
}

TEST(Settling, UnitsSignsAndOrderAreFound) {
  for (const double scale : {1.0, 1e-3, 1e3}) {
    for (const double lateral : {1.0, -1.0}) {
      for (const double height : {1.0, -1.0}) {
        std::vector<Position> points = wheel_points();
        for (Position& point : points) {
          point = {scale * lateral * point[0], scale * height * point[1]};
        }
        Log log("file", false);
        const Settled wheel = settled(points, ProfileKind::wheel, log);
        EXPECT_LT(largest_difference(wheel.points, wheel_points()), 1e-11)
            << scale << lateral << height;
        EXPECT_EQ(log.corrections().empty(), scale == 1.0 && lateral == 1.0 && height == 1.0);
      }
    }
  }
}

TEST(Settling, TheTapingLineIsShiftedTo0) {
  std::vector<Position> points = wheel_points();
  for (Position& point : points) {
    point = {point[0] + 70.0, point[1] + 3.0};
  }
  ReadOptions options;
  options.origin = WheelOrigin::flange_back;
  Log log("file", false);
  const Settled wheel = settled(points, ProfileKind::wheel, log, options);
  EXPECT_LT(largest_difference(wheel.points, wheel_points()), 1e-6);
  // A shift replaces the origin, one of 0 too.
  for (const double shift : {-69.0, 0.0}) {
    options.lateral_shift = shift;
    EXPECT_GT(
        largest_difference(settled(points, ProfileKind::wheel, log, options).points, wheel.points),
        0.9)
        << shift;
  }
}

TEST(Settling, TheKindFollowsFromTheShape) {
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail}) {
    RawProfile raw;
    raw.points = kind == ProfileKind::wheel ? wheel_points() : rail_points();
    Log log("file", false);
    EXPECT_EQ(settle(raw, {}, log).kind, kind);
    EXPECT_GE(log.guesses(), 1U);
  }
}

/// Before the kind is decided: of a wheel, but not of a half rail, which is as high.
TEST(Settling, SwappedColumnsOfAnUnknownKindAreFound) {
  RawProfile raw;
  const Curve curve = standard_profile("S1002").curve;
  for (double arc = 0.0; arc < curve.length(); arc += 0.5)
    raw.points.push_back({curve.at(arc).height, curve.at(arc).lateral});
  Log log("file", false);
  const Settled wheel = settle(raw, {}, log);
  EXPECT_EQ(wheel.kind, ProfileKind::wheel);
  EXPECT_NEAR(wheel.points.front()[0], -70.0, 1e-9);
  EXPECT_TRUE(log.warnings().empty());

  RawProfile half_rail; // head, web and foot
  for (const Position& corner :
       {Position{0, 0}, Position{20, -1}, Position{36, -14}, Position{36, -35}, Position{10, -45},
        Position{8, -140}, Position{20, -160}, Position{75, -162}, Position{75, -172}})
    half_rail.points.push_back(corner);
  Log log_of_rail("file", false);
  EXPECT_EQ(settle(half_rail, {}, log_of_rail).points.front()[0], 0.0);
  EXPECT_TRUE(std::none_of(
      log_of_rail.corrections().begin(), log_of_rail.corrections().end(),
      [](const std::string& line) { return line.find("swapped") != std::string::npos; }));
}

TEST(Settling, TooFewPointsAreRefused) {
  Log log("file", false);
  expect_error(
      ErrorCode::file_malformed,
      [&] {
        settled({{0, 0}, {20, 1}, {40, 0}, {60, 1}}, ProfileKind::rail, log);
      },
      "4 points");
}

} // namespace
} // namespace wrc::test::settling_test
