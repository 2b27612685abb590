#include "patches/depth_estimate.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/wheelset_equilibrium.hpp"
#include "patches/contact_patches.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::depth_estimate_test {
namespace {

constexpr double modulus = 115384.6;

ContactScan scan_of(const Profile& wheel, const Profile& rail, double lateral) {
  EquilibriumRequest request;
  request.lateral = lateral;
  request.roll = 0.0;
  request.right = false;
  const WheelSurface wheel_surface(wheel, {1360.0, 70.0, 460.0});
  const RailSurface rail_surface(rail, {1435.0, 14.0, rail.name == "circle" ? 0.0 : 0.025});
  return find_equilibrium({wheel_surface, rail_surface}, {wheel_surface, rail_surface}, request)
      .left->scan;
}

TEST(DepthEstimate, HertzForSmoothBodiesAtAnyLoad) {
  // Radii 300 and 460 mm are nearly those of a sphere: 9 Q^2 = 16 R E*^2 d^3, 1/R of their mean.
  // Also far below the distance of the scan's nodes.
  const ContactScan scan = scan_of(cylindrical_wheel(), circular_rail(300.0), 0.0);
  const double radius = 1.0 / (0.5 * (1.0 / 300.0 + 1.0 / 460.0));
  for (const double load : {1e-9, 1.0, 1e4, 3e5}) {
    const double hertz = std::cbrt(9.0 * load * load / (16.0 * radius * modulus * modulus));
    EXPECT_NEAR(estimate_depth(scan, modulus, load, LoadDirection::vertical), hertz, 0.05 * hertz)
        << load;
  }
}

TEST(DepthEstimate, CountsEveryPatch) {
  // Crown and a flank of 60 degrees, which touches 0.06 mm later.
  const ContactScan corner = scan_of(wheel_with_flank(), circular_rail(300.0), -1.35);
  constexpr double depth = 0.12;
  const ContactPatches found = find_contact_patches(corner, depth);
  ASSERT_EQ(found.patches.size(), 2u);
  const auto on_flank = [&](const auto& place) {
    return place.wheel.position.y < found.patches[0].limit_last;
  };
  ContactScan crown_only = corner;
  std::erase_if(crown_only.samples, on_flank);
  std::erase_if(crown_only.candidates, on_flank);
  for (const LoadDirection direction : {LoadDirection::vertical, LoadDirection::main_normal}) {
    const double one = estimate_load(crown_only, modulus, depth, direction);
    const double both = estimate_load(corner, modulus, depth, direction);
    EXPECT_GT(both, 1.02 * one);
    EXPECT_LT(both, 2.0 * one);
  }
}

TEST(DepthEstimate, AlongTheNormalOfTheMainPatch) {
  const ContactScan scan = scan_of(standard_profile("S1002"), standard_profile("60E1"), 6.0);
  const ContactPatches found = find_contact_patches(scan, 0.02);
  ASSERT_EQ(found.patches.size(), 1u);
  EXPECT_NEAR(estimate_load(scan, modulus, 0.02, LoadDirection::vertical),
              estimate_load(scan, modulus, 0.02, LoadDirection::main_normal) *
                  std::cos(found.patches[0].angle),
              1e-9);
}

/// A last secant step, whose load is not computed, leaves no more than a bracket would.
TEST(DepthEstimate, FindsTheLoadToAMillionth) {
  for (const double lateral : {-4.0, 0.0, 3.0}) {
    const ContactScan scan = scan_of(standard_profile("S1002"), standard_profile("60E1"), lateral);
    for (const double load : {1e3, 2e4, 8e4, 3e5}) {
      const double depth = estimate_depth(scan, modulus, load, LoadDirection::vertical);
      EXPECT_NEAR(estimate_load(scan, modulus, depth, LoadDirection::vertical) / load, 1.0, 2e-6)
          << lateral << ' ' << load;
    }
  }
}

TEST(DepthEstimate, InvertsTheLoadOverAllMagnitudes) {
  for (const double lateral : {0.0, 5.0, 5.5, 6.5}) {
    const ContactScan scan = scan_of(standard_profile("S1002"), standard_profile("60E1"), lateral);
    double before = 0.0;
    for (double load = 1e-12; load < 1e9; load *= 10.0) {
      const double depth = estimate_depth(scan, modulus, load, LoadDirection::vertical);
      EXPECT_GT(depth, before) << lateral << ' ' << load;
      EXPECT_LE(depth, 50.0);
      before = depth;
    }
    EXPECT_EQ(estimate_depth(scan, modulus, 1e20, LoadDirection::vertical), 50.0);
  }
}

} // namespace
} // namespace wrc::test::depth_estimate_test
