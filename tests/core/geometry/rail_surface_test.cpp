#include "geometry/rail_surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/spline.hpp"
#include "support/brute_force.hpp"

namespace wrc::test::rail_surface_test {
namespace {

constexpr double rounding = 1e-9; // mm

TEST(RailSurface, TopAndGaugeFaceAreWhereTheTrackPutsThem) {
  for (const auto name : standard_profile_names(ProfileKind::rail)) {
    for (const double cant : {0.0, std::atan(1.0 / 40.0), std::atan(1.0 / 30.0)}) {
      for (const double depth : {14.0, 16.0}) {
        const RailSurface rail(standard_profile(name), {1435.0, depth, cant});
        const Curve& curve = rail.graph().curve();
        double top = -1e9;
        double face = 1e9;
        for (double arc = 0.0; arc <= curve.length(); arc += 0.01) {
          top = std::max(top, curve.at(arc).height);
          if (curve.at(arc).height > -depth) {
            face = std::min(face, curve.at(arc).lateral);
          }
        }
        EXPECT_NEAR(top, 0.0, 1e-6) << name;
        EXPECT_NEAR(face, 717.5, 0.01) << name; // steps of 0.01 mm on a nearly upright face
      }
    }
  }
}

Profile rail_through(const std::vector<Position>& points) {
  Profile profile = standard_profile("60E1");
  profile.curve = curve_through(points);
  profile.points = points;
  return profile;
}

std::vector<Position> points_of_60e1() {
  const Curve curve = standard_profile("60E1").curve;
  std::vector<Position> points;
  for (double arc = 0.0; arc < curve.length(); arc += 0.25) {
    points.push_back({curve.at(arc).lateral, curve.at(arc).height});
  }
  return points;
}

/// EN 13848-1: the gauge is the least distance within the depth.
TEST(RailSurface, ALipCountsAsGaugeFace) {
  std::vector<Position> points = points_of_60e1();
  for (Position& point : points) {
    if (point[0] < 0.0) {
      point[0] -= 1.2 * std::exp(-std::pow((point[1] + 9.0) / 1.5, 2));
    }
  }
  const RailSurface rail(rail_through(points), {1435.0, 14.0, 0.025});
  const RailSurface plain(rail_through(points_of_60e1()), {1435.0, 14.0, 0.025});
  double least = 1e9;
  const Curve placed = rail_through(points).curve.moved(0.025, rail.origin_y(), 0.0);
  const double top = placed.at(arc_of_crown(placed)).height;
  for (double arc = 0.0; arc < placed.length(); arc += 0.001) {
    if (placed.at(arc).height > top - 14.0) {
      least = std::min(least, placed.at(arc).lateral);
    }
  }
  EXPECT_NEAR(least, 717.5, 1e-6);
  EXPECT_GT(rail.origin_y(), plain.origin_y() + 0.1) << "the lip is above the depth";
}

/// A guard rail on the gauge side, 25 mm above the head.
TEST(RailSurface, AGuardRailIsNotTheTop) {
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
  const std::vector<Position> head = points_of_60e1();
  points.insert(points.end(), head.begin(), head.end());
  const RailSurface guarded(rail_through(points), {1435.0, 14.0, 0.025});
  const RailSurface alone(rail_through(head), {1435.0, 14.0, 0.025});
  EXPECT_NEAR(guarded.origin_y(), alone.origin_y(), 1e-6);
  EXPECT_NEAR(guarded.graph().at_lateral(755.0).height, alone.graph().at_lateral(755.0).height,
              1e-6);
}

TEST(RailSurface, CantRaisesTheFieldSide) {
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(1.0 / 40.0)});
  const double middle = 753.0;
  EXPECT_GT(rail.graph().at_lateral(middle + 3.0).height,
            rail.graph().at_lateral(middle - 3.0).height);
}

TEST(RailSurface, ProfileFrameIsTheInverse) {
  const Profile profile = standard_profile("60E1");
  const RailSurface rail(profile, {1435.0, 14.0, 0.04});
  const Curve& placed = rail.graph().curve();
  for (double arc = 1.0; arc < placed.length(); arc += 7.3) {
    double lateral = 0.0;
    double height = 0.0;
    rail.to_profile_frame(placed.at(arc).lateral, placed.at(arc).height, lateral, height);
    EXPECT_NEAR(lateral, profile.curve.at(arc).lateral, rounding);
    EXPECT_NEAR(height, profile.curve.at(arc).height, rounding);
  }
}

TEST(RailSurface, HeightOverALateralCoordinateAgreesWithBisection) {
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(1.0 / 40.0)});
  for (double y = 718.0; y < 787.0; y += 0.37) {
    EXPECT_NEAR(rail.graph().at_lateral(y).height, rail_height(rail, y), rounding) << y;
  }
}

/// A roller has no gauge face: its axis is where a wheel has its taping line. A crown whose
/// measurement ends in the gauge corner is not one.
TEST(RailSurface, ARollerIsPlacedByItsAxis) {
  const auto arc = [](double radius, double half_width) {
    std::vector<Position> points;
    for (double y = -half_width; y <= half_width; y += 0.25) {
      points.push_back({y, std::sqrt(radius * radius - y * y) - radius});
    }
    Profile profile;
    profile.kind = ProfileKind::rail;
    profile.curve = curve_through(points);
    return profile;
  };
  const RailSurface roller(arc(300.0, 15.0), {1435.0, 14.0, 0.0});
  EXPECT_TRUE(roller.is_placed_by_axis());
  EXPECT_NEAR(roller.origin_y(), 750.0, 1e-12);
  EXPECT_NEAR(roller.origin_z(), 0.0, 1e-9);
  EXPECT_FALSE(RailSurface(standard_profile("60E1"), {1435.0, 14.0, 0.0}).is_placed_by_axis());
  EXPECT_THROW(RailSurface(arc(13.0, 10.0), {1435.0, 14.0, 0.0}), Error);
}

TEST(RailSurfaceErrors, GaugeHeightBelowTheProfile) {
  EXPECT_THROW(RailSurface(standard_profile("60E1"), {1435.0, 100.0, 0.025}), Error);
}

TEST(WheelSurfaceErrors, RadiusSmallerThanTheProfile) {
  EXPECT_THROW(WheelSurface(standard_profile("S1002"), {1360.0, 70.0, 2.0}), Error);
}

} // namespace
} // namespace wrc::test::rail_surface_test
