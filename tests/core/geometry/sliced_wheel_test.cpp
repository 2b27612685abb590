/// Wheels through slices: harmonics, flats, periodicity.
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/sliced_surface.hpp"
#include "geometry/varying_shapes.hpp"
#include "profile/profile.hpp"
#include "support/errors.hpp"

namespace wrc::test::sliced_wheel_test {
namespace {

constexpr double revolution = 2.0 * std::numbers::pi;

TEST(SlicedWheel, HarmonicsAreAddedToTheProfileInClosedForm) {
  const Curve curve = standard_profile("S1002").curve;
  const auto round = sliced_wheel(curve, 460.0, {});
  const auto wheel = sliced_wheel(curve, 460.0, {{1, 0.5, 0.3}, {20, 0.01, -1.0}});
  for (const double arc : {60.0, 70.0, 120.0})
    for (const double theta : {-4.0, 0.0, 0.7, 3.1, 100.0}) {
      const CurvePoint on_curve = curve.at(arc);
      EXPECT_EQ(round->sheets()[0].at(arc, theta).at[1], on_curve.height);
      const GraphPoint point = wheel->over(theta, on_curve.lateral).value();
      EXPECT_NEAR(point.height,
                  on_curve.height + 0.5 * std::cos(theta - 0.3) +
                      0.01 * std::cos(20.0 * theta + 1.0),
                  1e-12);
      EXPECT_NEAR(point.by_along, -0.5 * std::sin(theta - 0.3) - 0.2 * std::sin(20.0 * theta + 1.0),
                  1e-12);
      EXPECT_NEAR(point.by_along2,
                  -0.5 * std::cos(theta - 0.3) - 4.0 * std::cos(20.0 * theta + 1.0), 1e-11);
      EXPECT_NEAR(wheel->section(theta).at(arc).height, point.height, 1e-11);
    }
}

/// A chord flat of depth L^2 / 8r about theta = 0 in a cylinder.
SlicedProfile chord_flat(double radius, double length, double step) {
  const double half = std::asin(0.5 * length / radius);
  return profile_of(places_every(-0.2, 0.2, step), [&](double theta) {
    const double depth =
        std::abs(theta) < half ? radius - radius * std::cos(half) / std::cos(theta) : 0.0;
    return curve_of([&](double) { return Height{-depth, 0.0, 0.0}; });
  });
}

/// The flat and the waves of its spline end at 0.12 rad, reach is acos(1 - 3/450) = 0.12 rad.
TEST(SlicedWheel, IsRoundToARailThatDoesNotReachWhatVaries) {
  const WheelsetDimensions dimensions{1360.0, 70.0, 450.0};
  const auto flat = std::make_shared<const WheelSurface>(
      sliced_wheel(chord_flat(450.0, 50.0, 0.002), 450.0), dimensions, 0.0);
  const auto is_round = [&](double pitch, double yaw) {
    return turned(flat, pitch, yaw, false)->is_prismatic_along(along_track);
  };
  EXPECT_NEAR(flat->touch_angle(0.0, 0.0, false), std::acos(1.0 - 3.0 / 450.0), 1e-12);
  for (const double pitch : {0.25, 0.3, std::numbers::pi, -0.25, 0.25 + revolution, -7.0})
    EXPECT_TRUE(is_round(pitch, 0.0)) << pitch;
  for (const double pitch : {0.0, 0.1, -0.16, 0.1 + revolution})
    EXPECT_FALSE(is_round(pitch, 0.0)) << pitch;
  EXPECT_FALSE(is_round(0.3, 0.03)) << "under yaw flanks touch ahead of the axle";
  EXPECT_TRUE(is_round(0.5, 0.03));
  EXPECT_FALSE(turned(flat, 0.3, 0.0, true)->is_prismatic_along(along_track))
      << "on a rail that rises it is met ahead of the axle";
  EXPECT_TRUE(turned(flat, 0.5, 0.0, true)->is_prismatic_along(along_track));
  EXPECT_FALSE(is_round(std::numbers::pi, 0.2)) << "steep flanks touch anywhere";
  EXPECT_NEAR(turned(flat, 2.0, 0.0, false)->graph().at_lateral(3.0).height, 0.0, 1e-9);
  EXPECT_EQ(turned(flat, 2.0, 0.0, false), turned(flat, 2.1, 0.0, false))
      << "the same surface, made once";
  // What rises over the rest of the wheel is met from farther away.
  EXPECT_GT(flat->touch_angle(0.0, 2.0, false), flat->touch_angle(0.0, 0.0, false) + 0.02);
  const WheelSurface wavy = wavy_wheel(curve_of([](double) { return Height{}; }), {{1, 0.5, 0.0}});
  EXPECT_FALSE(wavy.round_at(1.0, 0.0, false));
}

TEST(SlicedWheel, ABumpIsMetFromFartherAwayThanAFlat) {
  const auto first_round = [](double depth) {
    const auto wheel = std::make_shared<const WheelSurface>(wheel_of(flattened_cylinder(
        450.0, 0.2, 0.002, [&](double theta) { return rounded_depth(theta, depth, 0.06); })));
    double pitch = 0.0;
    while (!turned(wheel, pitch, 0.0, false)->is_prismatic_along(along_track))
      pitch += 0.001;
    return pitch;
  };
  EXPECT_NEAR(first_round(-2.0) - first_round(2.0),
              std::acos(1.0 - 5.0 / 450.0) - std::acos(1.0 - 3.0 / 450.0), 2e-3);
}

TEST(SlicedWheel, AFlatHasTheDepthOfItsChordAndIsPeriodic) {
  const double radius = 450.0;
  const double length = 50.0;
  const SlicedSurface wheel = *sliced_wheel(chord_flat(radius, length, 0.002), radius);
  ASSERT_TRUE(wheel.sheets()[0].is_periodic());
  const auto at = [&](double theta) { return wheel.over(theta, 0.0).value(); };
  EXPECT_FALSE(wheel.nearest_end(0.0));
  EXPECT_NEAR(at(0.0).height, -length * length / (8.0 * radius), 1e-3);
  // Within the flat the polar radius is that of a plane: r cos(half) / cos(theta).
  const double half = std::asin(0.5 * length / radius);
  for (double theta = -0.045; theta < 0.045; theta += 0.0007)
    EXPECT_NEAR(radius + at(theta).height, radius * std::cos(half) / std::cos(theta), 1e-4);
  EXPECT_NEAR(at(std::numbers::pi).height, 0.0, 1e-6);
  for (const double theta : {-0.19, -0.03, 0.0, 0.11, 2.0}) {
    const GraphPoint here = at(theta);
    const GraphPoint there = at(theta + 3.0 * revolution);
    EXPECT_NEAR(here.height, there.height, 1e-12);
    EXPECT_NEAR(here.by_along, there.by_along, 1e-11);
  }
  const SurfaceSheet& sheet = wheel.sheets()[0];
  const std::size_t last = sheet.knots().size() - 2;
  const SheetPoint end =
      sheet.at(3, 0.1, {last, sheet.knots()[last + 1] - sheet.knots()[last], 1.0});
  const SheetPoint begin = sheet.at(3, 0.1, {0, sheet.knots()[1] - sheet.knots()[0], 0.0});
  EXPECT_NEAR(end.at[1], begin.at[1], 1e-13);
  EXPECT_NEAR(end.along[1], begin.along[1], 1e-12);
  EXPECT_NEAR(end.along2[1], begin.along2[1], 1e-12);
}

TEST(SlicedWheel, RefusesImpossibleRadiiAndHarmonics) {
  const Curve curve = standard_profile("S1002").curve;
  const auto refuses = [&](double radius, const RadiusHarmonic& harmonic, const char* part) {
    test::expect_error(
        ErrorCode::invalid_argument, [&] { (void)sliced_wheel(curve, radius, {harmonic}); }, part);
  };
  refuses(0.0, {}, "radius of the wheel = 0");
  refuses(20.0, {1, 25.0, 0.0}, "positive at all angles");
  refuses(460.0, {0, 1.0, 0.0}, "an order of 1 to 1000");
  refuses(460.0, {1001, 1.0, 0.0}, "an order of 1 to 1000");
  refuses(460.0, {2, NAN, 0.0}, "harmonic of order 2");
}

TEST(SlicedWheel, TheFilesOfExamplesMakeSurfaces) {
  const auto folder = std::filesystem::path(WRCONTACT_ORIGINAL_FILES_DIR) / "slices";
  if (!std::filesystem::exists(folder / "flat_d09.slcw"))
    GTEST_SKIP() << "no slices files in " << WRCONTACT_ORIGINAL_FILES_DIR;
  const SlicedProfile flat = read_sliced_profile(folder / "flat_d09.slcw");
  ASSERT_EQ(flat.slices.size(), 57U);
  const std::shared_ptr<const SlicedSurface> surface = sliced_wheel(flat, 450.0, {}, 0.0);
  const SurfaceSheet& sheet = surface->sheets()[0];
  const double middle = 0.5 * sheet.across().end;
  EXPECT_NEAR(sheet.at(middle, 0.0).at[1], -0.9, 0.02);
  EXPECT_NEAR(sheet.at(middle, 3.0).at[1], 0.0, 1e-3);
  EXPECT_NEAR(smoothing_length_of(flat, {}), 4.0 * 0.004453, 0.01 / 450.0);

  const SlicedProfile scanned = read_sliced_profile(folder / "S1002_flat.slcw");
  ASSERT_EQ(scanned.slices.size(), 258U);
  EXPECT_TRUE(sliced_wheel(scanned, 460.0)->sheets()[0].is_periodic());
}

} // namespace
} // namespace wrc::test::sliced_wheel_test
