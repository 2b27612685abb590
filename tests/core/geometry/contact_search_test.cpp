#include "geometry/contact_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/brute_force.hpp"
#include "support/errors.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::contact_search_test {
namespace {

/// Both ways resolve the least distance far below this, mm.
constexpr double distance_tolerance = 1e-6;
/// The place of a smooth least distance d0 + k s^2 / 2 is known to sqrt(2 error / k): with an error
/// of 1e-12 mm in brute force and the flattest k of these pairs, 1e-4 / mm, that is 1.4e-4 mm.
constexpr double place_tolerance = 1e-3;

struct Case {
  const char* wheel;
  const char* rail;
  double gauge_height;
  double back_to_back;
  double radius;
  double lateral;
  double yaw;
  double roll;
};

class ContactSearch : public testing::TestWithParam<Case> {};

TEST_P(ContactSearch, AgreesWithBruteForceInTwoDimensions) {
  const Case& c = GetParam();
  const WheelSurface wheel(standard_profile(c.wheel), {c.back_to_back, 70.0, c.radius});
  const RailSurface rail(standard_profile(c.rail), {1435.0, c.gauge_height, std::atan(0.025)});
  const Pose pose{c.lateral, c.yaw, c.roll};
  const ContactScan scan = search_contacts(wheel, rail, pose, 0.5);
  const ContactCandidate& contact = scan.candidates.front();
  const BruteForceContact reference = brute_force_contact(wheel, rail, pose);
  EXPECT_NEAR(contact.distance, reference.distance, distance_tolerance);
  // The locus must not be beaten by any point of the surface beyond rounding.
  EXPECT_LE(contact.distance, reference.distance + 1e-9);
  const bool near_jump =
      scan.candidates.size() > 1 && scan.candidates[1].distance - contact.distance < 1e-5;
  if (!near_jump) {
    EXPECT_NEAR(contact.wheel.position.x, reference.position.x, place_tolerance);
    EXPECT_NEAR(contact.wheel.position.y, reference.position.y, place_tolerance);
    EXPECT_NEAR(contact.wheel.position.z, reference.position.z, place_tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, ContactSearch,
                         testing::Values(Case{"S1002", "60E1", 14, 1360, 460, 0, 0, 0},
                                         Case{"S1002", "60E1", 14, 1360, 460, 5, 0, 3.4e-4},
                                         Case{"S1002", "60E1", 14, 1360, 460, -5, 0, -3.4e-4},
                                         Case{"S1002", "60E1", 14, 1360, 460, 3, 0.01, 1e-4},
                                         Case{"S1002", "60E1", 14, 1360, 460, -3, -0.03, 1e-3},
                                         Case{"S1002", "60E1", 14, 1360, 460, 6.5, 0.05, 2e-3},
                                         Case{"S1002", "60E1", 14, 1360, 460, 6.5, -0.05, -2e-3},
                                         Case{"S1002", "UIC60-Manchester", 14, 1360, 460, 7.5,
                                              0.024, 1e-3},
                                         Case{"S1002", "54E1", 14, 1360, 460, 2, 0.02, 0.0},
                                         Case{"LMA", "CHN60", 16, 1353, 430, -6, 0.05, 5e-4},
                                         Case{"LM-paper", "CHN60", 16, 1353, 420, 6, -0.05, 5e-4},
                                         Case{"LM", "CHN60", 16, 1353, 420, 10, 0.05, 4e-3}));

TEST(ContactSearchNearContacts, ListsTreadAndFlangeBesideAJump) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  const ContactScan scan = search_contacts(wheel, rail, {5.0, 0.0, 3.4e-4}, 0.1);
  ASSERT_GE(scan.candidates.size(), 2u);
  EXPECT_LT(scan.candidates[0].distance, scan.candidates[1].distance);
  // Two contacts about 10 mm apart on the wheel, less than 0.1 mm different in height.
  EXPECT_GT(std::abs(scan.candidates[0].wheel.lateral - scan.candidates[1].wheel.lateral), 5.0);
  for (const auto& candidate : scan.candidates) {
    EXPECT_LE(candidate.distance - scan.candidates[0].distance, 0.1);
  }
  // Every sample of the scan lies above the least distance.
  for (const auto& sample : scan.samples) {
    EXPECT_GE(sample.distance, scan.candidates[0].distance - 1e-12);
  }
}

TEST(ContactSearchNearContacts, NearToleranceOfZeroLeavesOneContact) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  EXPECT_EQ(search_contacts(wheel, rail, {5.0, 0.0, 3.4e-4}, 0.0).candidates.size(), 1u);
}

TEST(ContactSearchKinks, RidgeOfTheWheelIsTheContact) {
  // Cones of 1:10 that meet in a ridge at s = 4: it touches wherever the rail is flatter than that.
  const std::array<Segment, 2> segments{
      Segment{"inner", LineSegment{{{-66.0, -7.0}}, {{4.0, 0.0}}}},
      Segment{"outer", LineSegment{{{4.0, 0.0}}, {{54.0, -5.0}}}}};
  const Profile ridge{"ridge", ProfileKind::wheel, "", "", "", curve_of(segments)};
  const WheelSurface wheel(ridge, {1360.0, 70.0, 460.0});
  const RailSurface rail(circular_rail(300.0), {1435.0, 14.0, 0.0});
  const ContactScan scan = search_contacts(wheel, rail, {1.5, 0.0, 1e-3}, 0.0);
  EXPECT_NEAR(scan.candidates.front().wheel.lateral, 4.0, 1e-9);
  const BruteForceContact reference = brute_force_contact(wheel, rail, {1.5, 0.0, 1e-3});
  EXPECT_NEAR(scan.candidates.front().distance, reference.distance, distance_tolerance);
  // Followed from another roll it is the same.
  SideSearch search(wheel, rail);
  search.scan({1.5, 0.0, 1e-3});
  const LocusSpot found = search.least_spots(0.0).front();
  search.scan({1.5, 0.0, -4e-3});
  const auto followed = search.follow({1.5, 0.0, 1e-3}, search.least_spots(0.0).front());
  ASSERT_TRUE(followed.has_value());
  EXPECT_NEAR(followed->distance, found.distance, 1e-12);
}

/// The locus comes down to the edge of the chamfer from both flanks, whose ends are 43 to 85 mm
/// apart along it; with the largest yaw one of them is beyond the rail.
TEST(ContactSearch, TouchesARidgeUnderYawBetweenItsFlanks) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  for (const double yaw : {-0.1, 0.01, 0.1, 0.2}) {
    const Pose pose{-84.0, yaw, 0.0};
    const ContactScan scan = search_contacts(wheel, rail, pose, 0.0);
    EXPECT_NEAR(scan.candidates.front().wheel.lateral, 60.0, 1e-9) << yaw;
    for (const DistanceSample& sample : scan.samples) {
      EXPECT_GE(sample.distance, scan.candidates.front().distance - 1e-9) << yaw;
    }
    SideSearch search(wheel, rail);
    search.scan({-84.0, yaw, 1e-4});
    const auto followed = search.follow(pose, search.least_spots(0.0).front());
    ASSERT_TRUE(followed.has_value());
    EXPECT_NEAR(followed->distance, scan.candidates.front().distance, 1e-9) << yaw;
  }
}

TEST(ContactSearchFollow, FindsTheNearbyMinimumAtAnotherPose) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  SideSearch search(wheel, rail);
  for (const double yaw : {0.0, 0.02}) {
    search.scan({3.0, yaw, 2e-3});
    const LocusSpot from = search.least_spots(0.0).front();
    const auto followed = search.follow({3.0, yaw, 5e-4}, from);
    ASSERT_TRUE(followed.has_value());
    const ContactScan all = search_contacts(wheel, rail, {3.0, yaw, 5e-4}, 10.0);
    const bool known =
        std::any_of(all.candidates.begin(), all.candidates.end(), [&](const auto& candidate) {
          return std::abs(candidate.distance - followed->distance) < 1e-12;
        });
    EXPECT_TRUE(known) << yaw;
  }
}

TEST(ContactSearchErrors, WheelOffTheRail) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  const auto search = [&] { search_contacts(wheel, rail, {500.0, 0.0, 0.0}, 0.0); };
  expect_error(ErrorCode::no_contact, search, "wheel off the rail");
}

TEST(ContactSearchEnds, FlangeTipOnTheRailIsNotAProfileEnd) {
  // The tip is an arc of radius 12 about s = -55: the contact lies where its normal is the rail's.
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  const auto climbing = search_contacts(wheel, rail, {40.0, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(climbing.candidates.front().at_profile_end);
  EXPECT_NEAR(climbing.candidates.front().wheel.lateral,
              -55.0 + 12.0 * std::sin(climbing.candidates.front().rail_angle), 1e-6);
}

// With yaw the locus runs along the edge of the chamfer, which is a circle about the axle, for 36
// mm.
TEST(ContactSamples, FollowARidgeUnderYaw) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  ASSERT_EQ(wheel.ridges().size(), 1U);
  const std::size_t node = wheel.ridges()[0].node;
  const double s = wheel.nodes().lateral[node];
  const double rho = wheel.radius() + wheel.nodes().height[node];
  EXPECT_NEAR(s, 60.0, 1e-9);
  const Pose pose{-20.0, 0.08, 0.0};
  std::vector<Vector3> on_ridge;
  for (const DistanceSample& sample : search_contacts(wheel, rail, pose, 0.0).samples) {
    if (std::abs(sample.wheel.lateral - s) < 1e-9) {
      on_ridge.push_back(sample.wheel.position);
    }
  }
  ASSERT_GT(on_ridge.size(), 4U);
  EXPECT_GT(std::abs(on_ridge.back().x - on_ridge.front().x), 30.0);
  for (const Vector3& place : on_ridge) {
    const double y = place.y - pose.lateral;
    const double forward = std::cos(pose.yaw) * place.x + std::sin(pose.yaw) * y;
    const double across = std::cos(pose.yaw) * y - std::sin(pose.yaw) * place.x;
    EXPECT_NEAR(across, wheel.taping_line() + s, 1e-9);
    EXPECT_NEAR(std::hypot(forward, place.z), rho, 1e-9);
  }
  for (std::size_t i = 1; i < on_ridge.size(); ++i) {
    EXPECT_LT(std::abs(on_ridge[i].x - on_ridge[i - 1].x), 6.0);
    EXPECT_GT(on_ridge[i].y, on_ridge[i - 1].y);
  }
  const auto level = search_contacts(wheel, rail, {-20.0, 0.0, 0.0}, 0.0).samples;
  EXPECT_EQ(std::count_if(level.begin(), level.end(),
                          [s](const DistanceSample& sample) {
                            return std::abs(sample.wheel.lateral - s) < 1e-9;
                          }),
            1);
}

} // namespace
} // namespace wrc::test::contact_search_test
