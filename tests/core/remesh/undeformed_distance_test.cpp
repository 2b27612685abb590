#include "remesh/undeformed_distance.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/wheelset_equilibrium.hpp"
#include "patches/plane_area.hpp"
#include "support/brute_force.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::undeformed_distance_test {
namespace {

/// Rays are solved to 1e-12 mm; coordinates of some hundred mm carry 1e-13 each.
constexpr double ray_tolerance = 1e-10;

constexpr double wheel_radius = 460.0;
constexpr double crown_radius = 300.0;

struct SimplePair {
  WheelSurface wheel{cylindrical_wheel(), {1360.0, 70.0, wheel_radius}};
  RailSurface rail{circular_rail(crown_radius), {1435.0, 14.0, 0.0}};
};

TEST(UndeformedDistance, CylinderOnACircularCrownInClosedForm) {
  const SimplePair pair;
  const double axis = 717.5 + 35.0; // of the rail
  constexpr double lift = 0.25;
  const PosedPair posed{pair.wheel, pair.rail, {}, wheel_radius + lift};
  for (const GapConvention gap : {GapConvention::vertical, GapConvention::tangent}) {
    const Vector3 origin{0.0, axis, 0.0};
    const ContactFrame frame = gap == GapConvention::vertical
                                   ? vertical_frame(origin, Rotation(posed.pose))
                                   : tangent_frame(origin, 0.0);
    const Grid grid = grid_over({-12.0, 8.0, -9.0, 9.0}, 17, 10);
    const auto distance = sample_undeformed_distance(posed, frame, grid);
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const double x = grid.longitudinal(column);
        const double y = grid.lateral(row);
        const double wheel_z = wheel_radius + lift - std::sqrt(wheel_radius * wheel_radius - x * x);
        const double rail_z = std::sqrt(crown_radius * crown_radius - y * y) - crown_radius;
        EXPECT_NEAR(distance[row * grid.longitudinal_count + column], wheel_z - rail_z,
                    ray_tolerance);
      }
    }
  }
}

TEST(UndeformedDistance, YawedCylinderOnACircularCrownInClosedForm) {
  // Under yaw the cylinder's axis turns in the plane: the wheel's height over (x, y) depends on
  // the distance to the axis, x cos(yaw) + (y - y_centre) sin(yaw).
  const SimplePair pair;
  const double axis = 717.5 + 35.0;
  const Pose pose{0.0, 0.03, 0.0};
  const PosedPair posed{pair.wheel, pair.rail, pose, wheel_radius};
  const ContactFrame frame = tangent_frame({-axis * std::tan(pose.yaw), axis, 0.0}, 0.0);
  const Grid grid = grid_over({-10.0, 10.0, -9.0, 9.0}, 9, 14);
  const auto distance = sample_undeformed_distance(posed, frame, grid);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const double x = frame.origin.x + grid.longitudinal(column);
      const double y = axis + grid.lateral(row);
      const double across = x * std::cos(pose.yaw) + y * std::sin(pose.yaw);
      const double wheel_z =
          wheel_radius - std::sqrt(wheel_radius * wheel_radius - across * across);
      const double rail_z =
          std::sqrt(crown_radius * crown_radius - grid.lateral(row) * grid.lateral(row)) -
          crown_radius;
      EXPECT_NEAR(distance[row * grid.longitudinal_count + column], wheel_z - rail_z,
                  ray_tolerance);
    }
  }
}

/// Signed distance functions whose zeros the rays look for, written out once more.
double above_rail(const RailSurface& rail, Vector3 place) {
  return place.z - rail_height(rail, place.y);
}

double below_wheel(const WheelSurface& wheel, const Pose& pose, double vertical, Vector3 place) {
  const double dx = place.x;
  const double dy = place.y - pose.lateral;
  const double x = std::cos(pose.yaw) * dx + std::sin(pose.yaw) * dy;
  const double y1 = -std::sin(pose.yaw) * dx + std::cos(pose.yaw) * dy;
  const double z1 = place.z - vertical;
  const double y = std::cos(pose.roll) * y1 + std::sin(pose.roll) * z1;
  const double z = -std::sin(pose.roll) * y1 + std::cos(pose.roll) * z1;
  const double rho = wheel.radius() + wheel.graph().at_lateral(y - wheel.taping_line()).height;
  return std::hypot(x, z) - rho;
}

template <class Function> double bisect(Function function, double low, double high) {
  const bool rising = function(high) > 0.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    ((function(middle) > 0.0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

struct RayCase {
  double lateral;
  double yaw;
  double roll;
  GapConvention gap;
};

class Rays : public testing::TestWithParam<RayCase> {};

TEST_P(Rays, AgreeWithBisection) {
  const RayCase& c = GetParam();
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  EquilibriumRequest request;
  request.lateral = c.lateral;
  request.yaw = c.yaw;
  request.roll = c.roll;
  request.right = false;
  const auto equilibrium = find_equilibrium({wheel, rail}, {wheel, rail}, request);
  const auto& contact = equilibrium.left->scan.candidates.front();
  constexpr double depth = 0.05;
  const double vertical = equilibrium.left->vertical - depth;
  const PosedPair posed{wheel, rail, equilibrium.left->pose, vertical};
  const Vector3 origin{contact.wheel.position.x, contact.wheel.position.y,
                       rail_height(rail, contact.wheel.position.y)};
  const ContactFrame frame = c.gap == GapConvention::vertical
                                 ? vertical_frame(origin, Rotation(posed.pose))
                                 : tangent_frame(origin, contact.rail_angle);
  const Grid grid = grid_over({-4.0, 4.0, -6.0, 6.0}, 8, 7);
  const auto distance = sample_undeformed_distance(posed, frame, grid);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const auto place = [&](double along_normal) {
        return frame.to_track(grid.longitudinal(column), grid.lateral(row), along_normal);
      };
      const double on_rail =
          bisect([&](double at) { return above_rail(rail, place(at)); }, -3.0, 3.0);
      const double on_wheel =
          bisect([&](double at) { return below_wheel(wheel, posed.pose, vertical, place(at)); },
                 -3.0, 3.0);
      EXPECT_NEAR(distance[row * grid.longitudinal_count + column], on_wheel - on_rail, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, Rays,
                         testing::Values(RayCase{0.0, 0.0, 0.0, GapConvention::vertical},
                                         RayCase{3.0, 0.0, 2e-3, GapConvention::vertical},
                                         RayCase{3.0, 0.04, -2e-3, GapConvention::vertical},
                                         RayCase{0.0, 0.0, 0.0, GapConvention::tangent},
                                         RayCase{-4.0, 0.0, 3e-3, GapConvention::tangent},
                                         RayCase{5.0, -0.05, 4e-4, GapConvention::tangent},
                                         RayCase{5.5, 0.0, 4e-4, GapConvention::tangent}));

TEST(UndeformedDistance, NoMaterialBeyondTheEndsOfTheProfiles) {
  const SimplePair pair;
  const double axis = 717.5 + 35.0;
  const PosedPair posed{pair.wheel, pair.rail, {}, wheel_radius};
  const ContactFrame frame = tangent_frame({0.0, axis, 0.0}, 0.0);
  // The rail ends 35 mm from its axis, the wheel's radius is 460 mm.
  const Grid grid = grid_over({-60.0, 60.0, -500.0, 500.0}, 24, 20);
  const auto distance = sample_undeformed_distance(posed, frame, grid);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const bool material = std::abs(grid.lateral(row)) < 35.0 &&
                            std::abs(grid.longitudinal(column)) < wheel_radius - 1.0;
      const double value = distance[row * grid.longitudinal_count + column];
      if (material) {
        EXPECT_LT(value, no_material_distance) << grid.lateral(row);
      } else {
        EXPECT_EQ(value, no_material_distance) << grid.lateral(row);
      }
    }
  }
}

} // namespace
} // namespace wrc::test::undeformed_distance_test
