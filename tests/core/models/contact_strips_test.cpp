// Strips along the rail against bodies with closed forms and against differences.
#include "models/contact_strips.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/varying_search.hpp"
#include "geometry/varying_shapes.hpp"
#include "profile/profile.hpp"
#include "support/errors.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::contact_strips_test {
namespace {

constexpr WheelsetDimensions dimensions{1360.0, 70.0, 460.0};

/// A cylinder on a crown of 300 mm: curvatures are those of the bodies.
TEST(ContactStrips, CrossedCylindersHaveTheirOwnCurvatures) {
  const WheelSurface wheel(cylindrical_wheel(), dimensions);
  const RailSurface rail(circular_rail(300.0), {1435.0, 14.0, 0.0});
  const ContactStrips strips(wheel, rail, {});
  // The crown's middle is where the rail is highest.
  const double middle = rail.origin_y() - wheel.taping_line();
  const auto strip = strips.at(middle);
  ASSERT_TRUE(strip);
  EXPECT_NEAR(strip->longitudinal_curvature, 1.0 / 460.0, 1e-12);
  EXPECT_NEAR(strip->lateral_curvature, 1.0 / 300.0, 1e-7);
  EXPECT_NEAR(strip->rail_slope, 0.0, 1e-9);
  EXPECT_NEAR(strip->lateral_rate, 1.0, 1e-12);
  EXPECT_NEAR(strip->longitudinal_rate, 0.0, 1e-12);
  EXPECT_NEAR(strip->distance, -460.0, 1e-9);
  const auto beside = strips.at(middle + 5.0);
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->distance - strip->distance, 300.0 - std::sqrt(300.0 * 300.0 - 25.0), 1e-6);
}

/// A sphere about the middle of the axle has the same strips under any yaw.
TEST(ContactStrips, OfASphereDoNotDependOnYaw) {
  const WheelSurface wheel(spherical_wheel(1200.0), {0.0, 0.0, 1200.0});
  const RailSurface rail(circular_rail(300.0), {600.0, 14.0, 0.0}); // the sphere is 900 mm wide
  const ContactStrips straight(wheel, rail, {});
  const ContactStrips yawed(wheel, rail, {0.0, 0.03, 0.0});
  for (const double y : {rail.origin_y() - 20.0, rail.origin_y(), rail.origin_y() + 20.0}) {
    // The point over y has the same height, on another meridian.
    double s = y;
    for (int i = 0; i < 50; ++i) {
      const auto strip = yawed.at(s);
      ASSERT_TRUE(strip);
      s -= (strip->rail.y - y) / strip->lateral_rate;
    }
    const auto one = straight.at(y);
    const auto other = yawed.at(s);
    ASSERT_TRUE(one);
    ASSERT_TRUE(other);
    EXPECT_NEAR(other->distance, one->distance, 1e-6);
    EXPECT_NEAR(other->lateral_curvature, one->lateral_curvature, 1e-6);
  }
}

/// Rates and the least gap's curvature of a real pair, by differences along the wheel's profile.
TEST(ContactStrips, RatesAndCurvatureAreThoseOfDifferences) {
  const WheelSurface wheel(standard_profile("S1002"), dimensions);
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  const ContactStrips strips(wheel, rail, {2.0, 0.01, 0.0});
  constexpr double h = 1e-3;
  for (const double s : {-8.0, 3.3, 21.0}) {
    const auto before = strips.at(s - h);
    const auto here = strips.at(s);
    const auto after = strips.at(s + h);
    ASSERT_TRUE(before && here && after) << s;
    EXPECT_NEAR((after->rail.y - before->rail.y) / (2.0 * h), here->lateral_rate, 1e-5);
    EXPECT_NEAR((after->rail.x - before->rail.x) / (2.0 * h), here->longitudinal_rate, 1e-4);
    EXPECT_NEAR((after->rail.z - before->rail.z) / (after->rail.y - before->rail.y),
                here->rail_slope, 1e-6);
  }
}

/// The same bodies, known to be prismatic and through equal slices.
TEST(ContactStrips, BetweenTheRowsOfASearchAreThoseOfTheLocus) {
  const Profile e60 = standard_profile("60E1");
  const TrackDimensions track{1435.0, 14.0, 0.025};
  const WheelSurface wheel(standard_profile("S1002"), dimensions);
  const RailSurface rail(e60, track);
  const SlicedProfile slices = profile_of({-200.0, 200.0}, [&](double) { return e60.curve; });
  const RailSurface sliced = RailSurface(sliced_rail(slices), e60.curve, track).posed({}, 0.0);
  const Pose pose{2.0, 0.01, 0.0};
  VaryingSearch search(wheel, sliced);
  ASSERT_TRUE(search.try_scan(pose));
  const ContactScan scan = search.scans(0.1).front();
  const ContactStrips strips(wheel, rail, pose);
  const ContactStrips of_rows(wheel, sliced, pose, scan.samples);
  const double top = scan.candidates.front().wheel.lateral;
  for (const double s : {top - 3.1, top - 0.7, top, top + 2.3}) {
    const auto one = strips.at(s);
    const auto other = of_rows.at(s);
    ASSERT_TRUE(one && other) << s;
    EXPECT_NEAR(other->distance, one->distance, 1e-5) << s;
    EXPECT_LT(norm(other->rail - one->rail), 1e-2) << s; // the middle of a row for its least gap
    EXPECT_NEAR(other->rail_slope, one->rail_slope, 1e-4) << s;
    EXPECT_EQ(other->rail_rise, 0.0) << s;
    EXPECT_NEAR(other->lateral_rate, one->lateral_rate, 1e-4) << s;
    EXPECT_NEAR(other->longitudinal_rate, one->longitudinal_rate, 1e-2) << s;
    EXPECT_NEAR(other->longitudinal_curvature, one->longitudinal_curvature,
                5e-3 * one->longitudinal_curvature) // of the parabola 0.1 mm deep
        << s;
    EXPECT_NEAR(other->lateral_curvature, one->lateral_curvature, 2e-2 / 300.0) << s;
  }
  EXPECT_FALSE(of_rows.at(200.0));
  EXPECT_FALSE(ContactStrips(wheel, sliced, pose).at(top)); // without rows
}

/// A rail through slices, and rows on it, given by their places on the wheel and their curvatures.
class StripsOfRows : public testing::Test {
protected:
  struct Row {
    double s;
    double curvature;
  };
  [[nodiscard]] static std::vector<DistanceSample> rows_of(const std::vector<Row>& rows) {
    std::vector<DistanceSample> samples;
    for (const Row& row : rows) {
      const double y = 750.0 + 0.5 * static_cast<double>(samples.size());
      samples.push_back({{{0.0, y, 0.0}, row.s, row.curvature}, 0.0, 0.0, 0.0});
    }
    return samples;
  }
  [[nodiscard]] ContactStrips strips(const std::vector<DistanceSample>& rows,
                                     const Pose& pose = {}) const {
    return {wheel_, rail_, pose, rows};
  }

private:
  WheelSurface wheel_{cylindrical_wheel(), dimensions};
  RailSurface rail_ = rail_of(crown_along({-100.0, 100.0}, [](double) { return 0.0; }));
};

/// A cubic through these is negative between the second and the third.
TEST_F(StripsOfRows, HaveCurvatureBesideTheEndOfAFlat) {
  const double flat = 5.6e-5;
  const auto rows =
      rows_of({{0.0, flat}, {0.5, flat}, {1.0, flat}, {1.5, 39.0 * flat}, {2.0, 39.0 * flat}});
  for (double s = 0.0; s <= 2.0; s += 0.05) {
    const auto strip = strips(rows).at(s);
    ASSERT_TRUE(strip) << s;
    EXPECT_GE(strip->longitudinal_curvature, (1.0 - 1e-12) * flat) << s;
    EXPECT_LE(strip->longitudinal_curvature, (1.0 + 1e-12) * 39.0 * flat) << s;
  }
}

TEST_F(StripsOfRows, RefuseRowsThatTurnBackAlongTheWheel) {
  const auto rows = rows_of({{0.0, 2e-3}, {0.5, 2e-3}, {0.4, 2e-3}, {0.9, 2e-3}, {1.4, 2e-3}});
  expect_error(
      ErrorCode::invalid_argument,
      [&] {
        (void)strips(rows, {0.0, 0.12, 0.0}).at(0.45);
      },
      "turn back", "0.45", "half-space");
}

TEST_F(StripsOfRows, SayWhatATouchLacks) {
  const auto refused = [&](const std::vector<Row>& rows, const std::string& text) {
    expect_error(
        ErrorCode::no_contact, [&] { (void)strips(rows_of(rows)).touching_at(0.25, "hertz"); },
        "\"hertz\"", "0.25", text);
  };
  refused({{0.0, 2e-3}, {0.5, 2e-3}, {1.0, 2e-3}}, "fewer than 4 rows");
  refused({{0.0, -2e-3}, {0.5, -2e-3}, {1.0, -2e-3}, {1.5, -2e-3}}, "no curvature along the rail");
}

/// On the crest of a wave.
TEST(ContactStrips, CompareTheGapAlongTheRailWithItsParabola) {
  const WheelSurface wheel(cylindrical_wheel(), dimensions);
  const double amplitude = 0.02;
  const double wave_number = 2.0 * std::numbers::pi / 40.0;
  const RailSurface rail = rail_of(crown_along(places_every(-60.0, 60.0, 1.0), [&](double x) {
    return amplitude * std::cos(wave_number * x);
  }));
  VaryingSearch search(wheel, rail);
  ASSERT_TRUE(search.try_scan({}));
  const ContactScan scan = search.scans(0.1).front();
  const ContactStrips strips(wheel, rail, {}, scan.samples);
  const auto strip = strips.at(scan.candidates.front().wheel.lateral);
  ASSERT_TRUE(strip);
  for (const double half : {1.0, 4.0, 12.0}) {
    double largest = 0.0;
    const double parabola = 0.5 * strip->longitudinal_curvature;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const double x = share * half;
      const double gap =
          460.0 - std::sqrt(460.0 * 460.0 - x * x) + amplitude * (1.0 - std::cos(wave_number * x));
      largest = std::max(largest, std::abs(gap - parabola * x * x));
    }
    EXPECT_NEAR(strips.difference_along(*strip, half), largest / (parabola * half * half), 1e-4)
        << half;
  }
  EXPECT_EQ(strips.difference_along(*strip, 70.0), 1.0); // beyond the slices
  const RailSurface prismatic(circular_rail(300.0), level_track);
  EXPECT_EQ(ContactStrips(wheel, prismatic, {}).difference_along(*strip, 12.0), 0.0);
}

TEST(ContactStrips, EndWithTheProfiles) {
  const WheelSurface wheel(standard_profile("S1002"), dimensions);
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  const ContactStrips strips(wheel, rail, {});
  EXPECT_FALSE(strips.at(-200.0));
  EXPECT_FALSE(strips.at(200.0));
  EXPECT_TRUE(strips.at(0.0));
}

} // namespace
} // namespace wrc::test::contact_strips_test
