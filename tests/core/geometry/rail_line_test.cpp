/// Lines that meet rails through slices, against bisection along the line, and prismatic ones.
#include "geometry/rail_line.hpp"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"

namespace wrc::test::rail_line_test {
namespace {

/// A slope of 1:20 under waves of 50 mm, the crown's radius growing.
SlicedProfile rising_rail() {
  return profile_of(places_every(-100.0, 100.0, 5.0), [](double x) {
    return curve_of([&](double y) { return crown_at(y, 1.0 + 0.002 * x); })
        .moved(0.0, 0.0, 0.05 * x + 0.1 * std::sin(2.0 * std::numbers::pi * x / 50.0));
  });
}

/// Position along a line at which it passes through the highest surface.
double bisected(const RailSurface& rail, const SlicedSurface& slices, const Vector3& base,
                const Vector3& direction) {
  double low = -30.0;
  double high = 30.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    const Vector3 at = base + middle * direction;
    double lateral = 0.0;
    double height = 0.0;
    rail.to_profile_frame(at.y, at.z, lateral, height);
    (height < slices.over(rail.along() + at.x, lateral)->height ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void expect_met(const RailSurface& rail, double along_slope, double across_slope) {
  const auto slices = sliced_rail(rising_rail(), 0.0);
  RailLine line(rail);
  const double length = std::hypot(1.0, along_slope, across_slope);
  const Vector3 direction{along_slope / length, across_slope / length, 1.0 / length};
  for (double x = -40.0; x <= 40.0; x += 8.1)
    for (double y = 730.0; y <= 770.0; y += 4.3) {
      const Vector3 base{x, y, 0.05 * (rail.along() + x)};
      const auto position = line.meet(base, direction);
      ASSERT_TRUE(position) << x << ' ' << y;
      EXPECT_NEAR(*position, bisected(rail, *slices, base, direction), 2e-12) << x << ' ' << y;
    }
}

TEST(RailLine, MeetsTheSurfaceWhereBisectionDoes) {
  const RailSurface level = rail_of(rising_rail(), 10.0);
  TrackDimensions canted = level_track;
  canted.inclination = 0.025;
  const RailSurface inclined = rail_of(rising_rail(), -10.0, canted, {0.4, -0.2, 0.05});
  for (const RailSurface* rail : {&level, &inclined})
    for (const double along : {0.0, -0.05, 0.1})
      for (const double across : {0.0, 0.1, -0.3})
        expect_met(*rail, along, across);
}

/// Two parts: the left one ends at x = 60, the right one begins at 30; from lateral 0 to the right.
SlicedProfile two_parts() {
  SlicedProfile profile = crown_along(places_every(0.0, 90.0, 10.0), [](double) { return 0.0; });
  const double length = profile.slices[0].curve.length();
  for (ProfileSlice& slice : profile.slices) {
    slice.features.assign(3, std::nullopt);
    slice.features[1] = 0.5 * length;
    if (slice.place <= 60.0)
      slice.features[0] = 0.0;
    if (slice.place >= 30.0)
      slice.features[2] = length;
  }
  return profile;
}

TEST(RailLine, GoesOverFromOneSheetToTheNext) {
  const RailSurface rail = rail_of(two_parts(), 45.0);
  ASSERT_EQ(sliced_rail(two_parts(), 0.0)->sheets().size(), 2U);
  RailLine line(rail);
  for (double y = 725.0; y < 776.0; y += 0.37) { // on from where the last line met, over the seam
    const auto point = line.height(1.0, y);
    ASSERT_TRUE(point) << y;
    EXPECT_NEAR(point->height, crown_at(y - 750.0).value, 1e-9) << y;
    EXPECT_NEAR(point->by_lateral, crown_at(y - 750.0).first, 1e-9) << y;
  }
  for (const double y : {749.9999, 750.0, 750.0001}) { // at the seam, from either side
    line.restart();
    EXPECT_NEAR(line.meet({0.0, y, 0.0}, {0.0, 0.0, 1.0}).value(), crown_at(y - 750.0).value, 1e-9);
  }
}

TEST(RailLine, MeetsNothingInAGapAndBeyondTheEnds) {
  const RailSurface rail = rail_of(two_parts(), 45.0);
  RailLine line(rail);
  const Vector3 up{0.0, 0.0, 1.0};
  EXPECT_TRUE(line.meet({-20.0, 740.0, 0.0}, up)); // at 25: the left part alone
  EXPECT_FALSE(line.meet({-20.0, 760.0, 0.0}, up));
  EXPECT_FALSE(line.meet({20.0, 740.0, 0.0}, up)); // at 65: the right part alone
  EXPECT_TRUE(line.meet({20.0, 760.0, 0.0}, up));
  EXPECT_FALSE(line.meet({-46.0, 740.0, 0.0}, up));
  EXPECT_FALSE(line.meet({46.0, 760.0, 0.0}, up));
  EXPECT_FALSE(line.meet({0.0, 781.0, 0.0}, up));
  EXPECT_TRUE(line.meet({0.0, 779.0, 0.0}, up));
  EXPECT_FALSE(line.meet({0.0, 750.0, 0.0}, {1.0, 0.0, 0.001})); // along the rail
}

TEST(RailLine, ClampsToTheSectionAtTheWheelsetWhereNoRailIs) {
  const RailSurface rail = rail_of(two_parts(), 45.0);
  EXPECT_EQ(height_near(rail, 20.0, 740.0), rail.graph().at_lateral(740.0).height);
  EXPECT_NEAR(height_near(rail, 20.0, 760.0), crown_at(10.0).value, 1e-9);
  for (const double y : {740.0, 760.0})
    EXPECT_NEAR(graph_near(rail, 20.0, y).height, height_near(rail, 20.0, y), 1e-11) << y;
}

/// By how much the unit normal changes along a way.
Vector3 turn_of(const RailLine& line, const Vector3& way) {
  const SurfaceNormal surface = line.normal();
  const Vector3 change = dot(surface.across, way) * surface.by_across + way.x * surface.by_along;
  const double length = norm(surface.normal);
  const Vector3 unit = (1.0 / length) * surface.normal;
  return (1.0 / length) * (change - dot(unit, change) * unit);
}

/// The same rail, known to be prismatic and through equal slices.
TEST(RailLine, MeetsACurveAsItMeetsEqualSlices) {
  const SlicedProfile slices = crown_along({-100.0, 0.0, 100.0}, [](double) { return 0.0; });
  const RailSurface sliced = rail_of(slices);
  const RailSurface prismatic(first_of(slices, ProfileKind::rail), level_track);
  EXPECT_TRUE(prismatic.is_prismatic_along({-2.0, 0.0, 0.0}));
  EXPECT_FALSE(prismatic.is_prismatic_along({1.0, 1e-3, 0.0}));
  EXPECT_FALSE(sliced.is_prismatic_along(along_track));
  EXPECT_FALSE(prismatic.nearest_end(0.0));
  EXPECT_EQ(sliced.nearest_end(90.0).value().place, 100.0);
  EXPECT_EQ(sliced.nearest_end(90.0).value().distance, 10.0);
  RailLine one(prismatic, 750.0);
  RailLine other(sliced, 750.0);
  for (const double across : {0.0, 0.1, -0.3})
    for (double y = 728.0; y <= 772.0; y += 4.3) {
      const Vector3 base{3.0, y, -1.0};
      const Vector3 direction = (1.0 / std::hypot(1.0, across)) * Vector3{0.0, across, 1.0};
      const double met = one.meet(base, direction).value();
      EXPECT_NEAR(met, other.meet(base, direction).value(), 1e-11);
      EXPECT_NEAR(one.lateral(), other.lateral(), 1e-11);
      for (const double yaw : {0.0, 0.2}) {
        const Vector3 beside =
            std::cos(yaw) * cross(direction, along_track) - std::sin(yaw) * along_track;
        constexpr double step = 1e-4;
        const double rise =
            (RailLine(prismatic, 750.0).meet(base + step * beside, direction).value() - met) / step;
        EXPECT_NEAR(one.inclination(beside, direction), rise, 1e-6) << yaw;
        EXPECT_NEAR(other.inclination(beside, direction), rise, 1e-6) << yaw;
      }
      const Vector3 way = cross(one.normal().normal, along_track);
      EXPECT_LT(norm(turn_of(one, way) - turn_of(other, way)), 1e-9);
      EXPECT_NEAR(one.height(3.0, y).value().height, other.height(3.0, y).value().height, 1e-11);
      EXPECT_NEAR(one.height(3.0, y).value().by_lateral2, other.height(3.0, y).value().by_lateral2,
                  1e-9);
    }
}

} // namespace
} // namespace wrc::test::rail_line_test
