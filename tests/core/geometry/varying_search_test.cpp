/// Least distances on rails and wheels that vary, against closed forms and searches in one
/// variable.
#include "geometry/contact_search.hpp"
#include "geometry/varying_search.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/gap_field.hpp"
#include "geometry/varying_shapes.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "support/brute_force.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::varying_search_test {
namespace {

/// The largest value of a function of one variable between two places, by golden sections.
double largest(double low, double high, const std::function<double(double)>& function) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int i = 0; i < 80; ++i) {
    const double a = high - ratio * (high - low);
    const double b = low + ratio * (high - low);
    (function(a) > function(b) ? high : low) = function(a) > function(b) ? b : a;
  }
  return function(0.5 * (low + high));
}

constexpr double amplitude = 0.02;
constexpr double wave_number = 2.0 * std::numbers::pi / 40.0;

RailSurface corrugated_rail(double along) {
  return rail_of(crown_along(places_every(-60.0, 100.0, 0.5),
                             [](double x) { return amplitude * std::cos(wave_number * x); }),
                 along);
}

/// A cylinder at a place of a wave: by Newton's method for the slope along x.
TEST(VaryingSearch, FindsACylinderOnAWave) {
  const WheelSurface wheel(cylindrical_wheel(), wheelset);
  const double radius = wheelset.radius;
  for (const double along : {0.0, 3.0, 7.77, 12.0, 31.0}) {
    const RailSurface rail = corrugated_rail(along);
    VaryingSearch search(wheel, rail);
    ASSERT_TRUE(search.try_scan({}));
    double x = 0.0;
    const auto root = [&](double at) { return std::sqrt(radius * radius - at * at); };
    for (int i = 0; i < 50; ++i) {
      const double phase = wave_number * (along + x);
      const double slope = x / root(x) + amplitude * wave_number * std::sin(phase);
      const double second = radius * radius / std::pow(root(x), 3) +
                            amplitude * wave_number * wave_number * std::cos(phase);
      x -= second > 0.0 ? slope / second : 0.1 * slope;
    }
    const double distance = -root(x) - amplitude * std::cos(wave_number * (along + x));
    const VaryingSearch::Spot& least = search.least();
    EXPECT_NEAR(least.point.gap.value, distance, 1e-8) << along;
    EXPECT_NEAR(least.x, x, 1e-5) << along; // the spline's slope over the gap's curvature
    EXPECT_NEAR(least.y, 750.0, 1e-7) << along;
    const auto scans = search.scans(0.1);
    ASSERT_EQ(scans.size(), 1U) << along;
    const ContactCandidate& contact = scans[0].candidates.at(0);
    EXPECT_NEAR(contact.rail_rise, -amplitude * wave_number * std::sin(wave_number * (along + x)),
                1e-6);
    EXPECT_NEAR(contact.rail_angle, 0.0, 1e-12);
    EXPECT_NEAR(contact.wheel.wheel_angle, std::asin(x / radius), 1e-7);
  }
}

TEST(VaryingSearch, HasTheCurvatureOfTheGapAtACrest) {
  const WheelSurface wheel(cylindrical_wheel(), wheelset);
  const RailSurface rail = corrugated_rail(0.0);
  VaryingSearch search(wheel, rail);
  ASSERT_TRUE(search.try_scan({}));
  EXPECT_NEAR(search.least().point.gap.xx,
              1.0 / wheelset.radius + amplitude * wave_number * wave_number,
              3e-7); // of the cubic spline
  EXPECT_NEAR(search.least().point.gap.yy, 1.0 / crown, 1e-9);
}

/// Of the height of the wheel's centre over a rail whose top is at 0.
double centre_height(const WheelSurface& wheel, const RailSurface& rail) {
  VaryingSearch search(wheel, rail);
  EXPECT_TRUE(search.try_scan({}));
  return -search.least().point.gap.value;
}

TEST(VaryingSearch, HoldsAChordUpByItsEnds) {
  const double radius = 450.0;
  const double length = 50.0;
  const double half = std::asin(0.5 * length / radius);
  const auto wheel = flattened_cylinder(
      radius, 0.2, 0.0005, [&](double theta) { return chord_depth(theta, radius, length); });
  const RailSurface rail(circular_rail(crown), level_track);
  // Splines round the kinks at its ends by up to 0.002 mm, over two slices.
  for (const double pitch : {0.0, 0.01, -0.02, 0.04, -0.05, 0.1}) {
    const double expected =
        std::abs(pitch) < half ? radius * std::cos(half - std::abs(pitch)) : radius;
    EXPECT_NEAR(centre_height(wheel_of(wheel, pitch), rail), expected, 2e-3) << pitch;
  }
  EXPECT_NEAR(radius - centre_height(wheel_of(wheel), rail), length * length / (8.0 * radius),
              2e-3);
}

TEST(VaryingSearch, HoldsARoundedFlatUpWhereASearchOverTheAngleDoes) {
  const double radius = 450.0;
  const double half = 0.06;
  for (const double depth : {0.2, 2.0}) {
    const auto wheel = flattened_cylinder(
        radius, 0.2, 0.001, [&](double theta) { return rounded_depth(theta, depth, half); });
    const RailSurface rail(circular_rail(crown), level_track);
    for (const double pitch : {0.0, 0.013, -0.03, 0.05, -0.09}) {
      const auto height = [&](double theta) {
        return (radius - rounded_depth(theta, depth, half)) * std::cos(theta - pitch);
      };
      double expected = 0.0;
      for (double from = -0.15; from < 0.15; from += 0.005)
        expected = std::max(expected, largest(from, from + 0.005, height));
      EXPECT_NEAR(centre_height(wheel_of(wheel, pitch), rail), expected, 2e-5)
          << depth << ' ' << pitch;
    }
  }
}

TEST(VaryingSearch, FollowsEccentricAndPolygonalWheels) {
  const Curve cylinder = cylindrical_wheel().curve;
  const RailSurface rail(circular_rail(crown), level_track);
  for (const auto& [order, size] : {std::pair(1, 0.5), {3, 0.1}, {20, 0.02}})
    for (const double pitch : {0.0, 0.4, -2.0, 5.0}) {
      const auto height = [order = order, size = size, pitch](double from_bottom) {
        // Polar radius, seen from the centre.
        return (460.0 + size * std::cos(order * (pitch + from_bottom) - 0.3)) *
               std::cos(from_bottom);
      };
      double expected = 0.0;
      for (double from = -0.1; from < 0.1; from += 0.01)
        expected = std::max(expected, largest(from, from + 0.01, height));
      const WheelSurface wheel = wavy_wheel(cylinder, {{order, size, 0.3}}, pitch);
      EXPECT_NEAR(centre_height(wheel, rail), expected, 1e-9) << order << ' ' << pitch;
      if (order == 1) { // a circle about a centre that is shifted, to first order
        EXPECT_NEAR(centre_height(wheel, rail), 460.0 + size * std::cos(pitch - 0.3),
                    size * size / 460.0);
      }
    }
}

TEST(VaryingSearch, FindsBothEndsOfAFlat) {
  const double half = 0.06;
  const auto wheel = flattened_cylinder(
      450.0, 0.2, 0.001, [&](double theta) { return rounded_depth(theta, 2.0, half); });
  const RailSurface rail(circular_rail(crown), level_track);
  const WheelSurface down = wheel_of(wheel);
  VaryingSearch search(down, rail);
  ASSERT_TRUE(search.try_scan({}));
  auto scans = search.scans(0.5);
  ASSERT_EQ(scans.size(), 2U);
  const ContactCandidate& one = scans[0].candidates.at(0);
  const ContactCandidate& other = scans[1].candidates.at(0);
  EXPECT_NEAR(one.distance, other.distance, 1e-9);
  EXPECT_NEAR(one.wheel.position.x, -other.wheel.position.x, 1e-6);
  EXPECT_GT(std::abs(one.wheel.position.x), 20.0);
  const WheelSurface turned = wheel_of(wheel, 0.004); // the end at -half comes nearer, ahead
  VaryingSearch next(turned, rail);
  ASSERT_TRUE(next.try_scan({}));
  scans = next.scans(0.5);
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_LT(scans[0].candidates.at(0).distance, scans[1].candidates.at(0).distance);
  EXPECT_GT(scans[0].candidates.at(0).wheel.position.x, 0.0);
}

/// Places along are taken from the axle: nothing else depends on where the rail's origin is.
TEST(VaryingSearch, SeesTheSameWhereRailAndWheelsetAreMovedAlong) {
  const WheelSurface wheel(standard_profile("S1002"), wheelset);
  const Pose pose{2.0, 0.01, 0.005};
  const auto rail_at = [](double shift) {
    return rail_of(profile_of(places_every(-60.0 + shift, 60.0 + shift, 2.0),
                              [&](double x) {
                                return curve_of([&](double y) {
                                  return crown_at(y, 1.0 + 0.1 * std::sin(0.1 * (x - shift)));
                                });
                              }),
                   2.5 + shift);
  };
  const RailSurface rail = rail_at(0.0);
  VaryingSearch search(wheel, rail);
  ASSERT_TRUE(search.try_scan(pose));
  for (const double shift : {1024.0, -4096.0}) { // places are rounded to 1e-12 mm there
    const RailSurface moved = rail_at(shift);
    VaryingSearch there(wheel, moved);
    ASSERT_TRUE(there.try_scan(pose));
    EXPECT_NEAR(there.least().point.gap.value, search.least().point.gap.value, 1e-11);
    EXPECT_NEAR(there.least().x, search.least().x, 1e-8);
    EXPECT_NEAR(there.least().y, search.least().y, 1e-7);
  }
}

/// One profile as a rail that varies, and as a wheel, against the locus of bodies that do not.
TEST(VaryingSearch, FindsWhatTheLocusFindsOnOneProfile) {
  const Profile s1002 = standard_profile("S1002");
  const Profile e60 = standard_profile("60E1");
  const TrackDimensions track{1435.0, 14.0, 0.025, {}};
  const WheelSurface round(s1002, wheelset);
  const RailSurface constant(e60, track);
  const SlicedProfile slices =
      profile_of(places_every(-200.0, 200.0, 100.0), [&](double) { return e60.curve; });
  const RailSurface varying =
      RailSurface(sliced_rail(slices, 0.0), e60.curve, track).posed({}, 0.0);
  const WheelSurface wavy = wavy_wheel(s1002.curve, {{7, 0.0, 0.0}}, 0.4);
  for (const Pose& pose : {Pose{0.0, 0.0, 0.0}, Pose{3.0, 0.01, 0.002}, Pose{6.5, -0.02, 0.01},
                           Pose{-6.0, 0.03, -0.01}}) {
    const ContactScan scan = search_contacts(round, constant, pose, 0.1);
    for (const auto& [wheel, rail] :
         {std::pair(&round, &varying), {&wavy, &constant}, {&wavy, &varying}}) {
      VaryingSearch search(*wheel, *rail);
      ASSERT_TRUE(search.try_scan(pose));
      const auto found = search.scans(0.1);
      const ContactCandidate& contact = found.at(0).candidates.at(0);
      const ContactCandidate& expected = scan.candidates.at(0);
      EXPECT_NEAR(contact.distance, expected.distance, 1e-9) << pose.lateral;
      EXPECT_NEAR(contact.wheel.position.x, expected.wheel.position.x, 1e-6) << pose.lateral;
      EXPECT_NEAR(contact.wheel.position.y, expected.wheel.position.y, 1e-6) << pose.lateral;
      EXPECT_NEAR(contact.wheel.lateral, expected.wheel.lateral, 1e-6) << pose.lateral;
      EXPECT_NEAR(contact.rail_angle, expected.rail_angle, 1e-7) << pose.lateral;
      EXPECT_NEAR(contact.wheel.wheel_angle, expected.wheel.wheel_angle, 1e-7) << pose.lateral;
    }
  }
}

TEST(VaryingSearch, DerivativeByRollIsThatOfDifferences) {
  const Curve s1002 = standard_profile("S1002").curve;
  const WheelSurface wheel = wavy_wheel(s1002, {{9, 0.05, 0.0}}, 0.1);
  const RailSurface rail = corrugated_rail(4.0);
  constexpr double roll_here = -0.001; // on the crown, not on its edge
  const auto distance = [&](double roll) {
    VaryingSearch search(wheel, rail);
    EXPECT_TRUE(search.try_scan({-15.0, 0.02, roll}));
    return search.least().point.gap.value;
  };
  VaryingSearch search(wheel, rail);
  ASSERT_TRUE(search.try_scan({-15.0, 0.02, roll_here}));
  const double step = 1e-6;
  EXPECT_NEAR(search.by_roll(search.least()),
              (distance(roll_here + step) - distance(roll_here - step)) / (2.0 * step), 1e-4);
  const auto followed = search.follow({-15.0, 0.02, roll_here + 1e-4}, search.least());
  ASSERT_TRUE(followed);
  EXPECT_NEAR(followed->point.gap.value, distance(roll_here + 1e-4), 1e-10);
}

/// Where the rail begins, on its edges and far above the least distance, where bodies end on both
/// sides of a row's least distance or the distance falls there.
TEST(VaryingSearch, HasCurvaturesAtTheEndsOfBodies) {
  const Curve s1002 = standard_profile("S1002").curve;
  for (const double along : {-59.0, 0.0, 99.5})
    for (const Pose& pose :
         {Pose{0.0, 0.0, 0.0}, Pose{-32.0, -0.125, -0.015}, Pose{6.4, 0.0, 0.017}}) {
      const WheelSurface wheel = wavy_wheel(s1002, {{1, 0.5, 0.0}}, 0.07);
      const RailSurface rail = corrugated_rail(along);
      VaryingSearch search(wheel, rail);
      ASSERT_TRUE(search.try_scan(pose)) << along << ' ' << pose.lateral;
      for (const ContactScan& scan : search.scans(0.1))
        for (const DistanceSample& sample : scan.samples) {
          ASSERT_TRUE(std::isfinite(sample.wheel.normal_curvature));
          ASSERT_GT(sample.wheel.normal_curvature, 0.0) << along << ' ' << pose.lateral;
        }
    }
}

/// The parabola of a row goes on without a jump as the top between the ends of a flat sinks below
/// the depth at which it is drawn.
TEST(VaryingSearch, HasAContinuousCurvatureBesideASecondMinimum) {
  const auto wheel = flattened_cylinder(
      450.0, 0.2, 0.001, [](double theta) { return rounded_depth(theta, 0.5, 0.06); });
  const RailSurface rail(circular_rail(crown), level_track);
  double before = 0.0;
  for (double pitch = 0.0029; pitch < 0.0038; pitch += 5e-5) {
    const WheelSurface turned = wheel_of(wheel, pitch);
    VaryingSearch search(turned, rail);
    ASSERT_TRUE(search.try_scan({}));
    const double curvature = search.scans(0.1)[0].candidates.at(0).wheel.normal_curvature;
    if (before > 0.0) {
      EXPECT_NEAR(curvature, before, 0.15 * before) << pitch;
    }
    before = curvature;
  }
}

TEST(VaryingSearch, SeesNothingWhereNoRailIsBelow) {
  const WheelSurface wheel(standard_profile("S1002"), wheelset);
  const RailSurface rail = corrugated_rail(0.0);
  VaryingSearch search(wheel, rail);
  EXPECT_FALSE(search.try_scan({300.0, 0.0, 0.0}));
  EXPECT_TRUE(search.try_scan({0.0, 0.0, 0.0}));
}

} // namespace
} // namespace wrc::test::varying_search_test
