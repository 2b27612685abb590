#include "remesh/surface_rays.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::surface_rays_test {
namespace {

constexpr double ray_tolerance = 1e-11; // coordinates of some hundred mm carry 1e-13 each
constexpr double wheel_radius = 460.0;
constexpr double crown_radius = 300.0;
constexpr double axis = 717.5 + 35.0; // of the rail

class SurfaceRays : public testing::Test {
protected:
  const WheelSurface wheel{cylindrical_wheel(), {1360.0, 70.0, wheel_radius}};
  const RailSurface rail{circular_rail(crown_radius), {1435.0, 14.0, 0.0}};
  const PosedPair pair{wheel, rail, {}, wheel_radius + 0.25};
};

TEST_F(SurfaceRays, MeetTheCylinderOfTheWheel) {
  const ContactFrame frame = tangent_frame({0.0, axis, 0.0}, 0.2);
  WheelRay ray(pair, frame);
  for (const double longitudinal : {0.0, 15.0, -40.0}) {
    const auto met = ray.solve(longitudinal, 3.0);
    ASSERT_TRUE(met);
    const Vector3 place = frame.to_track(longitudinal, 3.0, *met);
    EXPECT_NEAR(std::hypot(place.x, place.z - pair.vertical), wheel_radius, ray_tolerance);
    EXPECT_LT(place.z, pair.vertical); // from below
    EXPECT_NEAR(ray.lateral(), place.y - wheel.taping_line(), ray_tolerance);
  }
}

/// On a circle the angle to the track plane is that of the radius to the upright.
TEST_F(SurfaceRays, TheRailsInclinationIsToTheRowsOfTheFrame) {
  for (const double angle : {0.0, 0.1, -0.05}) {
    const ContactFrame frame = tangent_frame({0.0, axis, 0.0}, angle);
    RailRay ray(rail, frame);
    for (const double lateral : {-20.0, 0.0, 5.0}) {
      ASSERT_TRUE(ray.solve(0.0, lateral));
      const double of_circle = ray.line().angle() - frame.angle();
      EXPECT_NEAR(ray.inclination(lateral), std::tan(of_circle), ray_tolerance) << angle;
    }
  }
}

/// Where the slope along is not that of the plane, the section across x is beside the plane of
/// rays.
TEST_F(SurfaceRays, InclinationsOfAWaveAreSlopesOfRayLengths) {
  const RailSurface wave = rail_of(crown_along(places_every(-60.0, 60.0, 1.0), [](double x) {
    return 0.5 * std::cos(2.0 * std::numbers::pi * x / 100.0);
  }));
  constexpr double step = 1e-3;
  for (const double angle : {0.0, 0.08})
    for (const double rise : {0.0, 0.1}) {
      const double y = wave.origin_y() - crown_radius * std::sin(angle);
      const ContactFrame frame = tangent_frame({0.0, y, 0.0}, angle, rise);
      RailRay ray(wave, frame);
      const double low = ray.solve(15.0, -step).value();
      const double high = ray.solve(15.0, step).value();
      ASSERT_TRUE(ray.solve(15.0, 0.0));
      EXPECT_NEAR(ray.inclination(0.0), (high - low) / (2.0 * step), 1e-8) << angle << ' ' << rise;
    }
}

TEST_F(SurfaceRays, MissBesideTheSurface) {
  const ContactFrame frame = tangent_frame({0.0, axis, 0.0}, 0.0);
  RailRay rail_ray(rail, frame);
  WheelRay wheel_ray(pair, frame);
  EXPECT_FALSE(rail_ray.solve(0.0, 36.0));
  EXPECT_FALSE(wheel_ray.solve(0.0, 80.0));
  EXPECT_FALSE(wheel_ray.solve(wheel_radius + 1.0, 0.0));
  rail_ray.restart();
  EXPECT_TRUE(rail_ray.solve(0.0, 34.0));
}

} // namespace
} // namespace wrc::test::surface_rays_test
