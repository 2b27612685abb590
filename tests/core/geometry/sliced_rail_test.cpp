/// Rails through slices: the files that CONTACT's examples come with, and gaps.
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/rail_line.hpp"
#include "geometry/sliced_surface.hpp"
#include "geometry/varying_shapes.hpp"
#include "profile/slice_matching.hpp"
#include "profile/spline.hpp"
#include "support/errors.hpp"

namespace wrc::test::sliced_rail_test {
namespace {

TEST(SlicedRail, HasNothingInAGap) {
  SlicedProfile profile = profile_of({0.0, 10.0, 20.0, 30.0}, [](double) {
    return curve_of([](double y) { return crown_at(y); });
  });
  const double length = profile.slices[0].curve.length();
  profile.slices[0].features = profile.slices[1].features = {0.0, 20.0, {}, {}};
  profile.slices[2].features = profile.slices[3].features = {{}, {}, 30.0, length};
  const SlicedSurface rail = *sliced_rail(profile);
  ASSERT_EQ(rail.sheets().size(), 2U);
  EXPECT_EQ(rail.along().begin, 0.0);
  EXPECT_EQ(rail.along().end, 30.0);
  EXPECT_TRUE(rail.over(5.0, -20.0));
  EXPECT_FALSE(rail.over(5.0, 20.0));
  EXPECT_FALSE(rail.over(15.0, -20.0));
  EXPECT_TRUE(rail.over(25.0, 20.0));
}

TEST(SlicedRail, TakesTheHighestOfItsSheets) {
  const Curve low = curve_of([](double y) { return Height{-1.0 + 0.01 * y, 0.01, 0.0}; });
  SlicedProfile profile = profile_of({0.0, 10.0}, [&](double) { return low; });
  const double length = low.length();
  for (ProfileSlice& slice : profile.slices)
    slice.features = {0.0, 20.0, length};
  profile.slices[0].features[0] = {}; // its left part is gone there
  const SlicedSurface rail = *sliced_rail(profile);
  ASSERT_EQ(rail.sheets().size(), 1U);
  EXPECT_NEAR(rail.over(5.0, 10.0)->height, -0.9, 1e-12);
  EXPECT_FALSE(rail.over(5.0, -20.0));
}

/// A part of a rail: a crown from one lateral place to another, and below it on the left, from
/// `groove` on, a groove and another crown 5 mm lower.
Curve crossing(double from, double to, double groove = 0.0) {
  std::vector<Position> points;
  const int count = static_cast<int>(std::lround((to - from) / 0.25));
  for (int i = 0; i <= count; ++i) {
    const double y = from + 0.25 * i;
    const double x = y - groove;
    const double depth =
        std::abs(x) < 10.0 ? 10.0 * (1.0 + std::cos(0.1 * std::numbers::pi * x)) : 0.0;
    points.push_back(
        {y, crown_at(y).value - depth - (x < 0.0 ? 5.0 * std::min(1.0, 0.1 * -x) : 0.0)});
  }
  return curve_through(points);
}

void add_features(SlicedProfile& profile) {
  std::vector<const Curve*> curves;
  for (const ProfileSlice& slice : profile.slices)
    curves.push_back(&slice.curve);
  const FoundFeatures found = find_features(curves);
  for (std::size_t i = 0; i < curves.size(); ++i)
    profile.slices[i].features = found.of_slices.at(i);
}

TEST(SlicedRail, IsNotChangedWhereSlicesAreCutAtOtherPlaces) {
  SlicedProfile profile = profile_of(places_every(0.0, 60.0, 10.0), [](double x) {
    return x < 15.0   ? crossing(-30.0, 30.0, -100.0)
           : x < 25.0 ? crossing(-30.0, 20.0, -100.0)
           : x < 45.0 ? crossing(-45.0, 40.0, -100.0)
                      : crossing(-20.0, 40.0, -100.0);
  });
  add_features(profile);
  const SlicedSurface rail = *sliced_rail(profile);
  for (double x = 0.5; x < 60.0; x += 1.0)
    for (double y = -19.0; y <= 19.5; y += 0.5) {
      const std::optional<GraphPoint> point = rail.over(x, y);
      ASSERT_TRUE(point) << x << ' ' << y;
      EXPECT_NEAR(point->height, crown_at(y).value, 2e-5) << x << ' ' << y;
      EXPECT_NEAR(point->by_along, 0.0, 2e-5) << x << ' ' << y;
    }
  for (double y = -44.5; y <= 39.5; y += 1.0)
    EXPECT_TRUE(rail.over(35.0, y)) << y; // no hole where the end of slice 1 would be
  EXPECT_FALSE(rail.over(15.0, 25.0));    // ends with slice 2
}

TEST(SlicedRail, PartsBeginAndEndWithTheSlicesThatHaveThem) {
  SlicedProfile profile = profile_of(places_every(0.0, 50.0, 10.0), [](double x) {
    return x < 15.0   ? crossing(5.0, 50.0)
           : x < 35.0 ? crossing(-50.0, 50.0)
                      : crossing(-50.0, -5.0);
  });
  add_features(profile);
  const SlicedSurface rail = *sliced_rail(profile);
  for (double x = 0.0; x <= 30.0; x += 2.5) // the wing on the right, up to slice 4
    for (double y = 12.0; y <= 49.0; y += 1.0)
      EXPECT_NEAR(rail.over(x, y).value().height, crown_at(y).value, 1e-4) << x << ' ' << y;
  for (double x = 20.0; x <= 50.0; x += 2.5) // the nose on the left, from slice 3 on
    for (double y = -49.0; y <= -12.0; y += 1.0)
      EXPECT_NEAR(rail.over(x, y).value().height, crown_at(y).value - 5.0, 1e-4) << x << ' ' << y;
  EXPECT_FALSE(rail.over(15.0, -20.0));
  EXPECT_FALSE(rail.over(35.0, 20.0));
}

std::filesystem::path shipped(const std::string& name) {
  return std::filesystem::path(WRCONTACT_ORIGINAL_FILES_DIR) / "slices" / name;
}

struct ShippedRail {
  const char* file;
  std::size_t slices;
  std::size_t sheets;
};

TEST(SlicedRail, TheFilesOfExamplesMakeSurfaces) {
  const ShippedRail files[] = {{"cross_nose.slcs", 21, 1},      {"wing_rail.slcs", 21, 1},
                               {"cross+wing.slcs", 21, 1},      {"cross+wing_extd.slcs", 31, 2},
                               {"uk_interrupt_v1.slcs", 20, 2}, {"uk_interrupt_v2.slcs", 20, 2}};
  if (!std::filesystem::exists(shipped(files[0].file)))
    GTEST_SKIP() << "no slices files in " << WRCONTACT_ORIGINAL_FILES_DIR;
  for (const ShippedRail& each : files) {
    const SlicedProfile profile = read_sliced_profile(shipped(each.file));
    EXPECT_EQ(profile.slices.size(), each.slices) << each.file;
    const SlicedSurface rail = *sliced_rail(profile);
    EXPECT_EQ(rail.sheets().size(), each.sheets) << each.file;
    for (const ProfileSlice& slice : profile.slices) { // interpolating: passes through the slices
      double off = 1e9;
      const CurvePoint middle = slice.curve.at(*slice.features[slice.features.size() - 2]);
      for (const SurfaceSheet& sheet : rail.sheets())
        for (double u = sheet.across().begin; u <= sheet.across().end; u += 0.01) {
          const Position at = sheet.at(u, slice.place).at;
          off = std::min(off, std::hypot(at[0] - middle.lateral, at[1] - middle.height));
        }
      EXPECT_LT(off, 0.01) << each.file << " at " << slice.place; // the step of u
    }
  }
}

/// Its running surface, along tracks that no moving edge crosses, against straight lines between
/// the slices, also where the nose begins and the wing ends: up to 0.006 mm, where the wing bends.
TEST(SlicedRail, ACrossingWithoutFeaturesMakesASurface) {
  if (!std::filesystem::exists(shipped("uk_crossing.slcs")))
    GTEST_SKIP() << "no slices files in " << WRCONTACT_ORIGINAL_FILES_DIR;
  const SlicedProfile profile = read_sliced_profile(shipped("uk_crossing.slcs"));
  ASSERT_EQ(profile.slices.size(), 148U);
  const SlicedSurface rail = *sliced_rail(profile);
  const auto is_straight = [&](double lateral, double begin, double end) {
    for (std::size_t i = 0; i + 1 < profile.slices.size(); ++i) {
      const double x = profile.slices[i].place;
      const double next = profile.slices[i + 1].place;
      if (x < begin || next > end)
        continue;
      const double middle =
          0.5 * (rail.over(x, lateral).value().height + rail.over(next, lateral).value().height);
      EXPECT_NEAR(rail.over(0.5 * (x + next), lateral).value().height, middle, 0.01)
          << "slices " << i + 1 << " and next, at " << lateral;
    }
  };
  is_straight(-10.0, -900.0, -350.0);
  is_straight(28.0, -600.0, 60.0);
  is_straight(50.0, 0.0, 300.0);
  is_straight(-15.0, 700.0, 2100.0);
}

/// Reach is 460 acos(1 - 3/460) = 52.6 mm, under yaw more; slices are 5 mm apart.
TEST(SlicedRail, IsAPrismToAWheelThatDoesNotReachWhatVaries) {
  const WheelSurface wheel(standard_profile("S1002"), wheelset);
  const auto rail_with = [](double rise) {
    const SlicedProfile dip = crown_along(places_every(0.0, 1000.0, 5.0), [&](double x) {
      return std::abs(x - 500.0) < 50.0
                 ? rise * std::pow(std::cos(0.01 * std::numbers::pi * (x - 500.0)), 4.0)
                 : 0.0;
    });
    return std::make_shared<const RailSurface>(sliced_rail(dip, 0.0), dip.slices.front().curve,
                                               level_track);
  };
  const auto rail = rail_with(-1.0);
  const auto is_prism = [&](const auto& of, double along, double yaw) {
    return posed(of, {}, along, wheel, yaw)->is_prismatic_along(along_track);
  };
  for (const double along : {60.0, 200.0, 300.0, 700.0, 940.0})
    EXPECT_TRUE(is_prism(rail, along, 0.0)) << along;
  for (const double along : {0.0, 40.0, 430.0, 500.0, 550.0, 960.0})
    EXPECT_FALSE(is_prism(rail, along, 0.0)) << along;
  EXPECT_FALSE(is_prism(rail, 300.0, 0.05));
  double flat = 300.0;
  double bump = 300.0;
  for (const auto high = rail_with(1.0); is_prism(high, bump, 0.0);)
    bump += 0.5;
  while (is_prism(rail, flat, 0.0))
    flat += 0.5;
  EXPECT_NEAR(flat - bump, 460.0 * (std::acos(1.0 - 4.0 / 460.0) - std::acos(1.0 - 3.0 / 460.0)),
              1.0);
  const RailDisplacement displacement{1.5, -0.25, 0.001};
  const auto prism = posed(rail, displacement, 200.0, wheel, 0.0);
  const RailSurface whole = rail->posed(displacement, 200.0);
  for (const double y : {740.0, 750.0, 765.0})
    EXPECT_NEAR(height_near(*prism, 0.0, y), height_near(whole, 0.0, y), 1e-9);
}

} // namespace
} // namespace wrc::test::sliced_rail_test
