// Contact on a ridge of the wheel that lies in part beyond the rail.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "geometry/contact_search.hpp"
#include "support/brute_force.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::partial_ridge_test {
namespace {

/// As in contact_search_test.cpp.
constexpr double distance_tolerance = 1e-6;
/// Of heights of 5 m.
constexpr double rounding = 1e-9;

/// The chamfer's edge of a large wheel crosses the rail's gauge corner: less than half of it lies
/// over the rail. Its lowest place was missed, 27 mm below what was taken for the first contact.
TEST(PartialRidge, ContainsTheFirstContact) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 5000.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  const Pose pose{-50.0, 0.2, -0.014};
  const ContactScan scan = search_contacts(wheel, rail, pose, 0.5);
  const double reference = brute_force_contact(wheel, rail, pose).distance;
  EXPECT_NEAR(scan.candidates.front().distance, reference, distance_tolerance);
}

/// No place of a scan is lower than the first contact, wherever ridges end.
TEST(PartialRidge, NoSampleIsBelowTheFirstContact) {
  std::mt19937_64 random(4901);
  const auto between = [&random](double least, double greatest) {
    constexpr double steps = 9007199254740992.0; // 2^53
    return least + (greatest - least) * (static_cast<double>(random() >> 11U) / steps);
  };
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  int over_the_rail = 0;
  for (const char* name : {"S1002", "LM", "LMA"}) {
    for (int i = 0; i < 400; ++i) {
      const WheelSurface wheel(standard_profile(name), {1360.0, 70.0, between(1000.0, 5000.0)});
      const Pose pose{between(-60.0, 60.0), between(-0.2, 0.2), between(-0.03, 0.03)};
      SideSearch search(wheel, rail);
      if (!search.try_scan(pose)) {
        continue;
      }
      ++over_the_rail;
      const ContactScan scan = contacts_of(search, 0.1);
      const auto lowest = std::ranges::min_element(scan.samples, {}, &DistanceSample::distance);
      EXPECT_GE(lowest->distance, scan.candidates.front().distance - rounding)
          << name << ", radius " << wheel.radius() << ", lateral " << pose.lateral << ", yaw "
          << pose.yaw << ", roll " << pose.roll;
    }
  }
  EXPECT_GT(over_the_rail, 600);
}

} // namespace
} // namespace wrc::test::partial_ridge_test
