#include "geometry/wheelset_equilibrium.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "extent.hpp"
#include "support/brute_force.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::wheelset_equilibrium_test {
namespace {

/// What the equilibrium promises for both least distances, mm.
constexpr double least_distance_tolerance = 1e-9;

struct Pair {
  WheelSurface wheel;
  RailSurface rail;
};

Pair s1002_on(const char* rail) {
  return {WheelSurface(standard_profile("S1002"), {1360.0, 70.0, 460.0}),
          RailSurface(standard_profile(rail), {1435.0, 14.0, std::atan(1.0 / 40.0)})};
}

TEST(WheelsetEquilibrium, BothWheelsTouch) {
  const Pair pair = s1002_on("60E1");
  for (const double lateral : some_of({-8.0, -2.5, 0.0, 4.0, 6.5, 9.0}, 2)) {
    for (const double yaw : {0.0, -0.05}) {
      EquilibriumRequest request;
      request.lateral = lateral;
      request.yaw = yaw;
      const auto result =
          find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request);
      EXPECT_NEAR(result.left->vertical, result.right->vertical, least_distance_tolerance)
          << lateral << ' ' << yaw;
      // By brute force as well, which knows nothing of the contact locus.
      const Pose pose{lateral, yaw, result.roll};
      EXPECT_NEAR(brute_force_contact(pair.wheel, pair.rail, pose).distance + result.vertical, 0.0,
                  1e-6);
      EXPECT_NEAR(brute_force_contact(pair.wheel, pair.rail, mirrored(pose)).distance +
                      result.vertical,
                  0.0, 1e-6);
    }
  }
}

TEST(WheelsetEquilibrium, MirroredPoseSwapsTheSidesToTheLastBit) {
  const Pair pair = s1002_on("60E1");
  for (const double lateral : {0.0, 0.7, 3.0, 5.0, 7.3}) {
    for (const double yaw : {0.0, 0.004, 0.05}) {
      EquilibriumRequest request;
      request.lateral = lateral;
      request.yaw = yaw;
      const auto one = find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request);
      request.lateral = -lateral;
      request.yaw = -yaw;
      const auto other =
          find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request);
      EXPECT_EQ(one.roll, -other.roll);
      EXPECT_EQ(one.vertical, other.vertical);
      const auto& left = one.left->scan.candidates.front();
      const auto& right = other.right->scan.candidates.front();
      EXPECT_EQ(left.wheel.position.x, right.wheel.position.x);
      EXPECT_EQ(left.wheel.position.y, right.wheel.position.y);
      EXPECT_EQ(left.wheel.position.z, right.wheel.position.z);
      EXPECT_EQ(left.rail_angle, right.rail_angle);
    }
  }
}

TEST(WheelsetEquilibrium, CentredWheelsetDoesNotRoll) {
  const Pair pair = s1002_on("60E1");
  EXPECT_EQ(find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, {}).roll, 0.0);
}

TEST(WheelsetEquilibrium, RollAgreesWithAnIndependentProgram) {
  const nlohmann::json cases = reference_data("contact_cases.json").at("cases");
  const Pair pair = s1002_on("UIC60-Manchester");
  /// The cases give the roll of a trial with its own profile points; asked for is this, rad.
  constexpr double roll_tolerance = 2e-6;
  int compared = 0;
  for (const auto& entry : cases) {
    const double roll = entry.at("roll_rad");
    if (entry.at("set") != "table2_80kN" || roll == 0.0) {
      continue;
    }
    EquilibriumRequest request;
    request.lateral = entry.at("lateral_mm");
    const auto result = find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request);
    EXPECT_NEAR(result.roll, roll, roll_tolerance) << entry.at("id");
    ++compared;
  }
  EXPECT_EQ(compared, 6);
}

TEST(WheelsetEquilibrium, TheSearchKeepsLargeWheelsOnTheRails) {
  // A roll of 0.1 rad, half the limit, moves a contact by 0.1 radii: off the rail.
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  for (const double radius : {1000.0, 1500.0, 3000.0}) {
    const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, radius});
    for (const double lateral : {6.5, -6.5}) {
      EquilibriumRequest request;
      request.lateral = lateral;
      const auto result = find_equilibrium({wheel, rail}, {wheel, rail}, request);
      EXPECT_GT(result.roll * lateral, 0.0); // the wheel at the flange is lifted
      EXPECT_NEAR(result.left->vertical, result.right->vertical, 1e-9) << radius;
    }
  }
}

TEST(WheelsetEquilibrium, APrescribedRollLowersEachWheelSeparately) {
  const Pair pair = s1002_on("60E1");
  EquilibriumRequest request;
  request.lateral = 4.0;
  request.roll = 0.0;
  const auto result = find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request);
  EXPECT_EQ(result.roll, 0.0);
  EXPECT_GT(std::abs(result.left->vertical - result.right->vertical), 1e-3);
  EXPECT_EQ(result.vertical, std::max(result.left->vertical, result.right->vertical));
}

TEST(WheelsetEquilibrium, OnlyTheRequestedSideIsSearched) {
  const Pair pair = s1002_on("60E1");
  EquilibriumRequest request;
  request.roll = 0.0;
  request.right = false;
  const auto result = find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request);
  EXPECT_TRUE(result.left.has_value());
  EXPECT_FALSE(result.right.has_value());
}

TEST(WheelsetEquilibriumErrors, WheelsetBesideTheTrack) {
  const Pair pair = s1002_on("60E1");
  EquilibriumRequest request;
  request.lateral = 300.0;
  EXPECT_THROW(find_equilibrium({pair.wheel, pair.rail}, {pair.wheel, pair.rail}, request), Error);
}

} // namespace
} // namespace wrc::test::wheelset_equilibrium_test
