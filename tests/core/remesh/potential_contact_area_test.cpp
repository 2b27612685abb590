#include "remesh/potential_contact_area.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/wheelset_equilibrium.hpp"
#include "simple_profiles.hpp"

namespace wrc::test {
namespace {

ContactScan scan_of(const Profile& wheel, const Profile& rail, double lateral) {
  EquilibriumRequest request;
  request.lateral = lateral;
  request.roll = 0.0;
  request.right = false;
  const WheelSurface wheel_surface(wheel, {1360.0, 70.0, 460.0});
  const RailSurface rail_surface(rail, {1435.0, 14.0, rail.name == "circle" ? 0.0 : 0.025});
  return find_equilibrium(wheel_surface, rail_surface, request).left->scan;
}

TEST(PenetrationRegion, ParabolasInClosedForm) {
  // Lowered by d, a cylinder of radius R penetrates a crown of radius r over +-sqrt(2 r d) across
  // and +-sqrt(2 R d) along. Circles are not parabolas, and the ends are interpolated between
  // nodes of the scan, so a few per cent are allowed.
  const ContactScan scan = scan_of(cylindrical_wheel(), circular_rail(300.0), 0.0);
  constexpr double depth = 0.1;
  const PenetrationRegion region = find_penetration_region(scan, depth);
  const double half_width = std::sqrt(2.0 * 300.0 * depth);
  EXPECT_NEAR(region.y_last - region.y_first, 2.0 * half_width, 0.03 * half_width);
  EXPECT_NEAR(region.half_length, std::sqrt(2.0 * 460.0 * depth), 0.03 * region.half_length);
  EXPECT_NEAR(region.mean_angle, 0.0, 1e-3);
  EXPECT_NEAR(region.mean_y, 752.5, 0.1);
  EXPECT_FALSE(region.other_regions);
}

TEST(PenetrationRegion, GrowsWithTheDepth) {
  const ContactScan scan = scan_of(standard_profile("S1002"), standard_profile("60E1"), 3.0);
  double width = 0.0;
  for (double depth = 1e-9; depth < 0.3; depth *= 3.0) {
    const PenetrationRegion region = find_penetration_region(scan, depth);
    EXPECT_GE(region.y_last - region.y_first, width);
    width = region.y_last - region.y_first;
    const double contact_y = scan.candidates.front().wheel.position.y;
    EXPECT_LE(region.y_first, contact_y);
    EXPECT_GE(region.y_last, contact_y);
  }
}

TEST(PenetrationRegion, JoinsTwoLobesAndReportsAnotherPlane) {
  const ContactScan lobes =
      scan_of(standard_profile("S1002"), standard_profile("UIC60-Manchester"), 5.0);
  const PenetrationRegion joined = find_penetration_region(lobes, 0.08);
  EXPECT_GT(joined.y_last - joined.y_first, 12.0); // both lobes, 10 mm apart
  // Crown and gauge corner at once, 35 mm apart: the corner is 0.06 mm from a flank of 60 degrees.
  const ContactScan corner = scan_of(wheel_with_flank(), circular_rail(300.0), -1.35);
  EXPECT_FALSE(find_penetration_region(corner, 0.03).other_regions);
  const PenetrationRegion deep = find_penetration_region(corner, 0.1);
  EXPECT_TRUE(deep.other_regions);
  EXPECT_NEAR(deep.other_wheel_lateral, -31.15, 0.5);
}

TEST(EstimateDepth, IsNearHertzForSmoothBodies) {
  const ContactScan scan = scan_of(cylindrical_wheel(), circular_rail(300.0), 0.0);
  constexpr double modulus = 115384.6;
  for (const double load : {1.0, 1e4, 3e5}) {
    // Hertz with nearly round contact: approach = (9 Q^2 / (16 R E*^2))^(1/3), 1/R of the mean.
    const double radius = 1.0 / (0.5 * (1.0 / 300.0 + 1.0 / 460.0));
    const double hertz = std::cbrt(9.0 * load * load / (16.0 * radius * modulus * modulus));
    // A start for coarse solutions: contacts narrower than the scan's nodes are seen too narrow.
    const double estimate = estimate_depth(scan, modulus, load);
    EXPECT_LT(estimate, 1.5 * hertz) << load;
    EXPECT_GT(estimate, hertz / 1.5) << load;
  }
}

TEST(EstimateDepth, GrowsWithTheLoadOverAllMagnitudes) {
  for (const double lateral : {0.0, 5.0, 5.5}) {
    const ContactScan scan = scan_of(standard_profile("S1002"), standard_profile("60E1"), lateral);
    double before = 0.0;
    for (double load = 1e-12; load < 1e9; load *= 10.0) {
      const double depth = estimate_depth(scan, 115384.6, load);
      EXPECT_GT(depth, before) << lateral << ' ' << load;
      EXPECT_LE(depth, 50.0);
      before = depth;
    }
    // More than any wheel carries: the search ends at its limit.
    EXPECT_EQ(estimate_depth(scan, 115384.6, 1e20), 50.0);
  }
}

TEST(PlaneArea, GridFillsTheAreaWithEqualElements) {
  const Grid grid = grid_over({-3.0, 5.0, 1.0, 2.0}, 4, 10);
  EXPECT_DOUBLE_EQ(grid.lateral_step, 2.0);
  EXPECT_DOUBLE_EQ(grid.longitudinal_step, 0.1);
  EXPECT_DOUBLE_EQ(grid.lateral(0), -2.0);
  EXPECT_DOUBLE_EQ(grid.lateral(3), 4.0);
  EXPECT_DOUBLE_EQ(grid.longitudinal(9), 1.95);
}

} // namespace
} // namespace wrc::test
