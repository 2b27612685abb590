#include "remesh/ray_rows.hpp"

#include <array>
#include <cmath>
#include <ostream>
#include <span>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "patches/contact_patches.hpp"
#include "remesh/undeformed_distance.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::ray_rows_test {
namespace {

/// Rows and single rays are solved to 1e-12 mm each. A surface that faces the ray at a flat angle
/// magnifies the rounding of coordinates of some hundred mm, 1e-13, by the angle's cosine.
constexpr double ray_tolerance = 2e-12;
/// Flatter than this, both roots stop where neither says anything about a contact.
constexpr double least_facing = 0.05;

struct Case {
  const char* wheel;
  double lateral;
  double yaw;
  GapConvention gap;
  double scale; ///< of the area, against the penetrated region
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.wheel << " y " << c.lateral << " yaw " << c.yaw
       << (c.gap == GapConvention::tangent ? " tangent" : " vertical") << " scale " << c.scale;
}

Profile wheel_named(const char* name) {
  return std::string_view(name) == "flank" ? wheel_with_flank() : standard_profile(name);
}

class RayRows : public testing::TestWithParam<Case> {};

TEST_P(RayRows, AgreeWithSingleRays) {
  const Case& c = GetParam();
  const WheelSurface wheel(wheel_named(c.wheel), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  EquilibriumRequest request;
  request.lateral = c.lateral;
  request.yaw = c.yaw;
  request.roll = 1e-3;
  request.right = false;
  const auto equilibrium = find_equilibrium({wheel, rail}, {wheel, rail}, request);
  constexpr double depth = 0.1;
  const ContactPatches found = find_contact_patches(equilibrium.left->scan, depth);
  const ContactPatch& patch = found.patches[found.main];
  const PosedPair pair{wheel, rail, equilibrium.left->pose, equilibrium.left->vertical - depth};
  const Vector3 origin{equilibrium.left->scan.candidates.front().wheel.position.x, patch.mean_y,
                       rail.graph().at_lateral(patch.mean_y).height};
  const ContactFrame frame = c.gap == GapConvention::tangent
                                 ? tangent_frame(origin, patch.angle)
                                 : vertical_frame(origin, Rotation(pair.pose));
  const Grid grid = grid_over(area_of(patch, rail, frame).widened(0.5 * (c.scale - 1.0)), 41, 53);
  const auto distance = sample_undeformed_distance(pair, frame, grid);
  std::size_t compared = 0;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const double value = distance[row * grid.longitudinal_count + column];
      const SurfacePlace place =
          surfaces_at(pair, frame, grid.longitudinal(column), grid.lateral(row));
      if (!place.on_rail || !place.on_wheel) {
        continue; // a single ray from the frame's origin may not find what its neighbours lead to
      }
      const double facing =
          std::cos(place.rail_angle) * frame.normal.z - std::sin(place.rail_angle) * frame.normal.y;
      if (facing < least_facing) {
        continue;
      }
      EXPECT_NEAR(value, dot(place.wheel - place.rail, frame.normal), ray_tolerance / facing)
          << row << ' ' << column;
      ++compared;
    }
  }
  EXPECT_GT(compared, grid.element_count() / 3);
}

// Tread, gauge corner, steep flange; a kink (the flank's foot) and steps (S1002 at s = -26 and -35)
// inside the area; yaw in both conventions; areas so large that rays run past the ends of the
// profiles.
INSTANTIATE_TEST_SUITE_P(Areas, RayRows,
                         testing::Values(Case{"S1002", 0.0, 0.0, GapConvention::tangent, 1.2},
                                         Case{"S1002", 3.0, 0.02, GapConvention::tangent, 1.2},
                                         Case{"S1002", 3.0, 0.02, GapConvention::vertical, 1.2},
                                         Case{"S1002", 3.0, 0.0, GapConvention::vertical, 1.2},
                                         Case{"S1002", 5.5, -0.05, GapConvention::tangent, 1.5},
                                         Case{"S1002", 7.5, 0.0, GapConvention::tangent, 1.5},
                                         Case{"S1002", 7.5, 0.02, GapConvention::tangent, 1.5},
                                         Case{"S1002", 7.5, 0.02, GapConvention::vertical, 1.5},
                                         Case{"S1002", 9.0, -0.05, GapConvention::tangent, 2.0},
                                         Case{"S1002", 3.0, 0.03, GapConvention::tangent, 6.0},
                                         Case{"LM", 6.0, 0.02, GapConvention::tangent, 1.5},
                                         Case{"flank", 5.5, 0.0, GapConvention::tangent, 12.0},
                                         Case{"flank", 5.5, 0.03, GapConvention::tangent, 12.0},
                                         Case{"flank", 5.5, 0.03, GapConvention::vertical, 14.0}));

/// With the profile's origin at the track's centre.
RailSurface level_rail(std::span<const Segment> segments) {
  return RailSurface({"rail", ProfileKind::rail, "", "", "", curve_of(segments)},
                     {1435.0, 14.0, 0.0, 0.0});
}

TEST(RayRowsKink, RowsAcrossAKinkMeetBothSides) {
  // A roof of slopes -1/2 and +1/2 under upright rays that run obliquely across its ridge.
  const std::array<Segment, 2> segments{
      Segment{"left", LineSegment{{{-20.0, -10.0}}, {{0.0, 0.0}}}},
      Segment{"right", LineSegment{{{0.0, 0.0}}, {{20.0, -10.0}}}}};
  const RailSurface rail = level_rail(segments);
  std::vector<double> longitudinal;
  for (int i = -15; i <= 15; ++i) {
    longitudinal.push_back(i + 0.25);
  }
  RaySurface surface(rail, longitudinal.size());
  const RowOfRays rays{
      {0.0, 0.0, 5.0}, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, longitudinal.data(), longitudinal.size()};
  surface.meet(rays, 0.25);
  for (std::size_t i = 0; i < longitudinal.size(); ++i) {
    ASSERT_TRUE(surface.met(i)) << longitudinal[i];
    EXPECT_NEAR(surface.position(i), -5.0 - 0.5 * std::abs(longitudinal[i]), 1e-12);
  }
}

TEST(RayRowsEnds, RaysBesideTheProfileMiss) {
  const std::array<Segment, 1> segments{
      Segment{"plate", LineSegment{{{-10.0, 0.0}}, {{10.0, 0.0}}}}};
  const RailSurface rail = level_rail(segments);
  const std::array<double, 4> longitudinal{-10.5, -9.5, 9.5, 10.5};
  RaySurface surface(rail, longitudinal.size());
  const bool all = surface.meet(
      {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, longitudinal.data(), longitudinal.size()},
      0.0);
  EXPECT_FALSE(all);
  EXPECT_FALSE(surface.met(0));
  EXPECT_TRUE(surface.met(1));
  EXPECT_TRUE(surface.met(2));
  EXPECT_FALSE(surface.met(3));
  surface.meet_none(longitudinal.size());
  EXPECT_FALSE(surface.met(1));
}

TEST(RayRowsSlices, AreLeftToSingleRays) {
  const RailSurface rail = rail_of(crown_along({0.0, 10.0}, [](double) { return 0.0; }), 5.0);
  const std::array<double, 2> longitudinal{-1.0, 1.0};
  RaySurface surface(rail, longitudinal.size());
  EXPECT_FALSE(surface.meet(
      {{0.0, 750.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, longitudinal.data(), 2}, 750.0));
  EXPECT_FALSE(surface.met(0));
}

} // namespace
} // namespace wrc::test::ray_rows_test
