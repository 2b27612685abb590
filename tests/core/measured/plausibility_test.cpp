// Points of a wheel and of a rail are plausible; each of what they are checked for shows.
#include "measured/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "measured/plausible_shapes.hpp"
#include "measured/profile_shape.hpp"
#include "samples.hpp"

namespace wrc::test::plausibility_test {
namespace {

using namespace reading;

constexpr double tape_offset = 70.0;

bool warns(const std::vector<Position>& points, ProfileKind profile, WarningClass kind) {
  Log log("file", false);
  check_points(points, profile, tape_offset, log);
  return std::any_of(log.warnings().begin(), log.warnings().end(),
                     [kind](const Warning& warning) { return warning.kind == kind; });
}

std::vector<Position> changed(std::vector<Position> points, double lateral, double height,
                              Position shift = {0.0, 0.0}) {
  for (Position& point : points) {
    point = {lateral * point[0] + shift[0], height * point[1] + shift[1]};
  }
  return points;
}

std::vector<Position> equal_points(const Curve& curve) {
  std::vector<Position> points;
  for (double arc = 0.0; arc < curve.length(); arc += 0.25) {
    const CurvePoint at = curve.at(arc);
    points.push_back({at.lateral, at.height});
  }
  return points;
}

TEST(Plausibility, WheelsAndRailsArePlausible) {
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail}) {
    Log log("file", true);
    const auto points = kind == ProfileKind::wheel ? wheel_points() : rail_points();
    EXPECT_NO_THROW(check_points(points, kind, tape_offset, log));
    EXPECT_TRUE(log.warnings().empty());
  }
}

TEST(Plausibility, WrongSignsShow) {
  EXPECT_TRUE(
      warns(changed(wheel_points(), 1.0, -1.0), ProfileKind::wheel, WarningClass::profile_signs));
  std::vector<Position> mirrored = changed(wheel_points(), -1.0, 1.0);
  std::reverse(mirrored.begin(), mirrored.end());
  EXPECT_TRUE(warns(mirrored, ProfileKind::wheel, WarningClass::profile_signs));
}

/// As the wheel is, and upside down, as the signs of a rail's file may turn it.
TEST(Plausibility, AWheelGivenAsARailShows) {
  for (const std::string_view name : standard_profile_names(ProfileKind::wheel)) {
    const std::vector<Position> points = equal_points(standard_profile(name).curve);
    for (const double sign : {1.0, -1.0}) {
      EXPECT_TRUE(
          warns(changed(points, 1.0, sign), ProfileKind::rail, WarningClass::profile_dimensions))
          << name << sign;
      EXPECT_TRUE(
          warns(changed(points, -1.0, sign), ProfileKind::rail, WarningClass::profile_dimensions))
          << name << sign;
    }
  }
  for (const std::string_view name : standard_profile_names(ProfileKind::rail)) {
    EXPECT_FALSE(warns(equal_points(standard_profile(name).curve), ProfileKind::rail,
                       WarningClass::profile_dimensions))
        << name;
  }
}

TEST(Plausibility, WrongOriginsShow) {
  EXPECT_TRUE(warns(changed(wheel_points(), 1.0, 1.0, {0.0, 5.0}), ProfileKind::wheel,
                    WarningClass::profile_origin));
  EXPECT_TRUE(warns(changed(wheel_points(), 1.0, 1.0, {70.0, 0.0}), ProfileKind::wheel,
                    WarningClass::profile_origin));
  EXPECT_TRUE(warns(changed(rail_points(), 1.0, 1.0, {0.0, 170.0}), ProfileKind::rail,
                    WarningClass::profile_origin));
}

TEST(Plausibility, WrongUnitsShow) {
  EXPECT_TRUE(warns(changed(wheel_points(), 2.0, 2.0), ProfileKind::wheel,
                    WarningClass::profile_dimensions));
}

/// Limits in a warning are those of the table.
TEST(Plausibility, AWarningGivesTheValueAndItsLimits) {
  Log log("file", false);
  const std::vector<Position> points = changed(wheel_points(), 2.0, 2.0);
  check_points(points, ProfileKind::wheel, tape_offset, log);
  const Position lateral = extent_of(points, 0);
  ASSERT_FALSE(plausible::width.holds(lateral[1] - lateral[0]));
  ASSERT_FALSE(log.warnings().empty());
  EXPECT_EQ(log.warnings().front().text, "width " + fixed_text(lateral[1] - lateral[0]) +
                                             " mm, expected 50 to 200; state the scale");
}

TEST(Plausibility, AMissingFlangeShows) {
  std::vector<Position> tread;
  for (double y = -40.0; y <= 60.0; y += 2.0) {
    tread.push_back({y, -y / 20.0});
  }
  EXPECT_TRUE(warns(tread, ProfileKind::wheel, WarningClass::profile_flange));
}

TEST(Plausibility, GapsStepsAndOverlapsShow) {
  std::vector<Position> points = rail_points();
  points.erase(points.begin() + 12, points.begin() + 18);
  EXPECT_TRUE(warns(points, ProfileKind::rail, WarningClass::profile_gap));
  points = rail_points();
  for (std::size_t i = 17; i < points.size(); ++i) {
    points[i][1] += 2.0;
  }
  EXPECT_TRUE(warns(points, ProfileKind::rail, WarningClass::profile_step));
  points = rail_points();
  std::swap(points[16], points[17]);
  EXPECT_TRUE(warns(points, ProfileKind::rail, WarningClass::profile_overlap));
}

/// Rollers and discs have neither flange nor head, and any width.
TEST(Plausibility, DiscsNeedNoFlange) {
  const auto disc = [](double radius, double half_width, double slope) {
    std::vector<Position> points;
    for (double y = -half_width; y <= half_width; y += 0.5) {
      points.push_back({y, std::sqrt(radius * radius - y * y) - radius + slope * y});
    }
    return points;
  };
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail}) {
    for (const double radius : {30.0, 300.0, 1e5}) {
      Log log("file", true);
      EXPECT_NO_THROW(check_points(disc(radius, 15.0, 0.0), kind, tape_offset, log)) << radius;
      EXPECT_EQ(log.corrections().size(), 1U);
    }
  }
  EXPECT_TRUE(disc_radius_of(disc(300.0, 15.0, 0.0)));
  EXPECT_FALSE(disc_radius_of(disc(1e5, 15.0, 0.05))) << "a cone";
  EXPECT_FALSE(disc_radius_of(changed(disc(300.0, 15.0, 0.0), 1.0, 1.0, {15.0, 0.0})))
      << "its edge";
  EXPECT_FALSE(disc_radius_of(wheel_points()));
  EXPECT_FALSE(disc_radius_of(rail_points()));
  std::vector<Position> hole = disc(300.0, 30.0, 0.0);
  hole.erase(hole.begin() + 50, hole.begin() + 70);
  EXPECT_TRUE(warns(hole, ProfileKind::rail, WarningClass::profile_gap));
}

TEST(Plausibility, HeightAtTheTapingLineIsBetweenThePoints) {
  const std::vector<Position> points{{-3.0, 0.4}, {-1.0, 0.2}, {3.0, -0.6}};
  ASSERT_TRUE(height_at_taping_line(points));
  EXPECT_NEAR(*height_at_taping_line(points), 0.0, 1e-12);
  EXPECT_FALSE(height_at_taping_line(std::span(points).first(2)));
}

/// Waves as short as two points of an amplitude of 0.05 mm make pressures; arcs make none.
TEST(Plausibility, ScatterShowsAndShapeDoesNot) {
  std::vector<Position> arc;
  for (int i = 0; i <= 280; ++i) {
    const double y = 0.25 * i - 35.0;
    arc.push_back({y, std::sqrt(300.0 * 300.0 - y * y) - 300.0});
  }
  EXPECT_FALSE(scatter_of(arc).matters());
  for (std::size_t i = 0; i < arc.size(); ++i) {
    arc[i][1] += 0.05 * std::sin(12.9898 * static_cast<double>(i * i));
  }
  EXPECT_TRUE(scatter_of(arc).matters());
  // By the median, which of waves is not that of normal noise.
  EXPECT_NEAR(scatter_of(arc).deviation, 0.05 / std::numbers::sqrt2, 0.015);
}

/// Rounding alone has a deviation of 0.29 digits; points that are off by several digits have more.
TEST(Plausibility, ScatterOfDigitsIsRecognised) {
  const auto rounded = [](double noise) {
    std::vector<Position> points;
    for (int i = 0; i <= 280; ++i) {
      const double y = 0.25 * i - 35.0;
      const double z = std::sqrt(300.0 * 300.0 - y * y) - 300.0 +
                       noise * std::sin(12.9898 * static_cast<double>(i * i));
      points.push_back({y + 7.0, std::round(1e3 * z) / 1e3 - 0.3});
    }
    return scatter_of(points);
  };
  EXPECT_TRUE(rounded(0.0).is_of_digits);
  EXPECT_NEAR(rounded(0.0).deviation, 0.29e-3, 0.06e-3);
  EXPECT_FALSE(rounded(0.003).is_of_digits);
}

/// A guard rail 25 mm above the head does not say where the running surface is: its end is kept,
/// its height is right, and a gap in it has a warning.
TEST(Plausibility, AGuardRailIsNotTheCrown) {
  std::vector<Position> points;
  for (double y = -110.0; y <= -90.0; y += 0.5) {
    points.push_back({y, 25.0});
  }
  for (double z = 24.5; z > -36.0; z -= 0.5) {
    points.push_back({-90.0 + 0.02 * (25.0 - z), z});
  }
  for (double y = -88.0; y < -40.0; y += 0.5) {
    points.push_back({y, -37.0});
  }
  for (const Position& point : equal_points(standard_profile("60E1").curve)) {
    if (point[0] < 2.0 || point[0] > 10.0) {
      points.push_back(point);
    }
  }
  ReadOptions options;
  options.mirror_height = false;
  options.kind = ProfileKind::rail;
  const ReadResult read = profile_through(points, "guarded", options);
  EXPECT_EQ(read.measured.back(), points.back());
  std::vector<WarningClass> kinds;
  for (const Warning& warning : read.profile.warnings) {
    kinds.push_back(warning.kind);
  }
  EXPECT_EQ(std::ranges::count(kinds, WarningClass::profile_origin), 0);
  EXPECT_EQ(std::ranges::count(kinds, WarningClass::profile_gap), 1);
}

} // namespace
} // namespace wrc::test::plausibility_test
