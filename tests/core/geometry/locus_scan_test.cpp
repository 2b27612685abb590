#include "geometry/locus_scan.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/simple_profiles.hpp"

namespace wrc::test::locus_scan_test {
namespace {

struct Surfaces {
  WheelSurface wheel{cylindrical_wheel(), {1360.0, 70.0, 460.0}};
  RailSurface rail{circular_rail(300.0), {1435.0, 14.0, 0.0}};
};

TEST(LocusScan, NodesOfACylinderLieARadiusBelowTheAxle) {
  const Surfaces surfaces;
  LocusScan scan(surfaces.wheel, surfaces.rail);
  scan.run(LocusPose(Pose{2.0, 0.0, 0.0}));
  ASSERT_LT(scan.first(), scan.last());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t node = scan.first(); node < scan.last(); ++node) {
    if (!scan.over_rail(node)) {
      continue;
    }
    const Vector3 position = scan.position(node);
    EXPECT_EQ(position.x, 0.0);
    EXPECT_NEAR(position.y,
                surfaces.wheel.taping_line() + 2.0 + surfaces.wheel.nodes().lateral[node], 1e-12);
    EXPECT_NEAR(position.z, -460.0, 1e-12);
    const HeightFunction& rail = surfaces.rail.graph().heights();
    EXPECT_NEAR(scan.distance(node), -460.0 - rail.at(position.y).height, 1e-11);
    EXPECT_NEAR(scan.rail_slope(node), rail.at(position.y).slope, 1e-12);
    least = std::min(least, scan.distance(node));
  }
  EXPECT_EQ(scan.least(), least);
}

TEST(LocusScan, OnlyNodesOverTheRailCount) {
  const Surfaces surfaces;
  LocusScan scan(surfaces.wheel, surfaces.rail);
  scan.run(LocusPose(Pose{0.0, 0.0, 0.0}));
  const HeightFunction& rail = surfaces.rail.graph().heights();
  for (std::size_t node = 0; node < surfaces.wheel.nodes().lateral.size(); ++node) {
    const double y = surfaces.wheel.taping_line() + surfaces.wheel.nodes().lateral[node];
    EXPECT_EQ(scan.over_rail(node), y >= rail.begin() && y <= rail.end()) << y;
  }
  EXPECT_FALSE(scan.over_rail(1000000));
  scan.run(LocusPose(Pose{500.0, 0.0, 0.0}));
  EXPECT_TRUE(std::isinf(scan.least()));
}

} // namespace
} // namespace wrc::test::locus_scan_test
