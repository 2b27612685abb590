/// Sheets: what they reproduce exactly, their order, their derivatives, and folds.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/surface_sheet.hpp"
#include "geometry/varying_shapes.hpp"
#include "profile/profile.hpp"
#include "support/errors.hpp"

namespace wrc::test::surface_sheet_test {
namespace {

/// Sections through whole curves.
std::vector<SheetSection> sections_of(const SlicedProfile& profile) {
  std::vector<SheetSection> sections;
  for (const ProfileSlice& slice : profile.slices)
    sections.push_back(
        {sections.size() + 1, slice.place, &slice.curve, {0.0, slice.curve.length()}});
  return sections;
}

SurfaceSheet sheet_of(const SlicedProfile& profile, double smoothing = 0.0) {
  return SurfaceSheet(sections_of(profile), smoothing, 0.0);
}

TEST(SurfaceSheet, EqualSlicesAreTheConstantCurveToTheBit) {
  for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel})
    for (const auto name : standard_profile_names(kind)) {
      const Curve curve = standard_profile(name).curve;
      const SlicedProfile profile =
          profile_of({-24000.0, -3.0, 0.0, 7.0, 11.5}, [&](double) { return curve; });
      for (const double smoothing : {0.0, 20.0}) {
        const SurfaceSheet sheet = sheet_of(profile, smoothing);
        for (double arc = -1.0; arc < curve.length() + 1.0; arc += 0.37)
          for (const double along : {-24000.0, -17.0, -1.234, 0.0, 7.77, 12.0}) {
            const CurvePoint expected = curve.at(arc);
            const SheetPoint point = sheet.at(arc, along);
            ASSERT_EQ(point.at[0], expected.lateral) << name;
            ASSERT_EQ(point.at[1], expected.height);
            ASSERT_EQ(point.across[0], expected.tangent_lateral);
            ASSERT_EQ(point.across[1], expected.tangent_height);
            ASSERT_EQ(point.across2[0], expected.second_lateral);
            ASSERT_EQ(point.across2[1], expected.second_height);
            ASSERT_EQ(point.along, Position{});
            ASSERT_EQ(point.across_along, Position{});
            ASSERT_EQ(point.along2, Position{});
          }
      }
    }
}

TEST(SurfaceSheet, ATiltedPrismaticRailIsExact) {
  // Turned about the y axis: the section across at x is z0(y) / cos + x tan.
  const double angle = 0.05;
  const SlicedProfile profile = profile_of({-40.0, 0.0, 10.0, 13.0, 60.0}, [&](double x) {
    return curve_of([&](double y) { return crown_at(y, 1.0 / std::cos(angle)); })
        .moved(0.0, 0.0, x * std::tan(angle));
  });
  for (const double smoothing : {0.0, 25.0}) {
    const SurfaceSheet sheet = sheet_of(profile, smoothing);
    for (double x = -40.0; x <= 60.0; x += 3.3)
      for (double y = -29.0; y <= 29.0; y += 1.7) {
        const auto point = sheet.over(x, y);
        ASSERT_TRUE(point);
        const Height z = crown_at(y, 1.0 / std::cos(angle));
        EXPECT_NEAR(std::cos(angle) * point->height - std::sin(angle) * x, crown_at(y).value, 1e-9);
        EXPECT_NEAR(point->by_along, std::tan(angle), 1e-9);
        EXPECT_NEAR(point->by_lateral, z.first, 1e-9);
        EXPECT_NEAR(point->by_lateral2, z.second, 1e-8);
        EXPECT_NEAR(point->by_along2, 0.0, 1e-9);
        EXPECT_NEAR(point->by_along_lateral, 0.0, 1e-9);
      }
  }
}

/// z = crown + A cos(k x) with slices at a distance: the largest errors of height, slope and
/// curvature away from the ends.
std::array<double, 3> errors_of_waves(double step) {
  constexpr double amplitude = 0.1;
  const double k = 2.0 * std::numbers::pi / 100.0;
  const SlicedProfile profile = profile_of(places_every(-200.0, 200.0, step), [&](double x) {
    return curve_of([](double y) { return crown_at(y); })
        .moved(0.0, 0.0, amplitude * std::cos(k * x));
  });
  const SurfaceSheet sheet = sheet_of(profile);
  std::array<double, 3> errors{};
  for (double x = -100.0; x <= 100.0; x += 0.61)
    for (const double y : {-20.0, 0.0, 3.0}) {
      const GraphPoint point = *sheet.over(x, y);
      const double wave = amplitude * std::cos(k * x);
      errors[0] = std::max(errors[0], std::abs(point.height - crown_at(y).value - wave));
      errors[1] = std::max(errors[1], std::abs(point.by_along + k * amplitude * std::sin(k * x)));
      errors[2] = std::max(errors[2], std::abs(point.by_along2 + k * k * wave));
    }
  return errors;
}

TEST(SurfaceSheet, ASinusoidalRailConvergesToItsClosedForm) {
  const auto coarse = errors_of_waves(10.0);
  const auto fine = errors_of_waves(5.0);
  EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 4.0, 0.15);
  EXPECT_NEAR(std::log2(coarse[1] / fine[1]), 3.0, 0.15);
  EXPECT_NEAR(std::log2(coarse[2] / fine[2]), 2.0, 0.15);
  EXPECT_LT(fine[0], 3e-6);        // mm, of 0.1
  EXPECT_LT(fine[2], 0.01 * 4e-4); // 1/mm
}

/// A crown that turns, widens and rises, with features that move.
SlicedProfile turning(double step) {
  SlicedProfile profile = profile_of(places_every(0.0, 60.0, step), [](double x) {
    return curve_of([&](double y) { return crown_at(y, 1.0 + 0.01 * x); })
        .moved(0.001 * x, 0.1 * x, 0.02 * std::sin(0.1 * x));
  });
  for (ProfileSlice& slice : profile.slices)
    slice.features = {0.0, 20.0 + 0.1 * slice.place, slice.curve.length()};
  return profile;
}

SurfaceSheet turning_sheet() {
  static const SlicedProfile profile = turning(5.0);
  std::vector<SheetSection> sections = sections_of(profile);
  for (std::size_t i = 0; i < sections.size(); ++i)
    sections[i].features = {0.0, *profile.slices[i].features[1], *profile.slices[i].features[2]};
  return SurfaceSheet(sections, 0.0, 0.0);
}

TEST(SurfaceSheet, DerivativesAreThoseOfItsPoints) {
  const SurfaceSheet sheet = turning_sheet();
  constexpr double step = 1e-4;
  const auto slope = [](const Position& after, const Position& before, std::size_t i) {
    return (after[i] - before[i]) / (2.0 * step);
  };
  for (double u = 1.03; u < 58.0; u += 3.31)
    for (double x = 0.77; x < 59.0; x += 4.13) {
      const SheetPoint p = sheet.at(u, x);
      const SheetPoint left = sheet.at(u - step, x);
      const SheetPoint right = sheet.at(u + step, x);
      const SheetPoint behind = sheet.at(u, x - step);
      const SheetPoint ahead = sheet.at(u, x + step);
      for (const std::size_t i : {0U, 1U}) {
        EXPECT_NEAR(p.across[i], slope(right.at, left.at, i), 1e-8);
        EXPECT_NEAR(p.along[i], slope(ahead.at, behind.at, i), 1e-8);
        EXPECT_NEAR(p.across2[i], slope(right.across, left.across, i), 1e-7);
        EXPECT_NEAR(p.along2[i], slope(ahead.along, behind.along, i), 1e-7);
        EXPECT_NEAR(p.across_along[i], slope(ahead.across, behind.across, i), 1e-7);
        EXPECT_NEAR(p.across_along[i], slope(right.along, left.along, i), 1e-7);
      }
    }
}

TEST(SurfaceSheet, IsC2AcrossFeaturesAndAlongKnots) {
  const SurfaceSheet sheet = turning_sheet();
  const auto expect_equal = [](const SheetPoint& a, const SheetPoint& b) {
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_NEAR(a.at[i], b.at[i], 1e-10);
      EXPECT_NEAR(a.across[i], b.across[i], 1e-10);
      EXPECT_NEAR(a.along[i], b.along[i], 1e-10);
      EXPECT_NEAR(a.across2[i], b.across2[i], 1e-9);
      EXPECT_NEAR(a.across_along[i], b.across_along[i], 1e-10);
      EXPECT_NEAR(a.along2[i], b.along2[i], 1e-10);
    }
  };
  const std::span<const double> starts = sheet.starts();
  for (std::size_t piece = 1; piece + 1 < starts.size(); ++piece)
    expect_equal(sheet.at(piece - 1, starts[piece] - starts[piece - 1], sheet.locate(12.3)),
                 sheet.at(piece, 0.0, sheet.locate(12.3)));
  for (std::size_t knot = 1; knot + 1 < sheet.knots().size(); ++knot)
    expect_equal(sheet.at(7, 0.1, {knot - 1, sheet.knots()[knot] - sheet.knots()[knot - 1], 1.0}),
                 sheet.at(7, 0.1, {knot, sheet.knots()[knot + 1] - sheet.knots()[knot], 0.0}));
}

TEST(SurfaceSheet, TheGraphHasTheDerivativesOfItsHeights) {
  const SurfaceSheet sheet = turning_sheet();
  constexpr double step = 1e-3;
  for (double x = 2.3; x < 58.0; x += 7.7)
    for (double y = -20.0; y < 28.0; y += 5.3) {
      const GraphPoint p = *sheet.over(x, y);
      const auto height = [&](double dx, double dy) { return sheet.over(x + dx, y + dy)->height; };
      EXPECT_NEAR(p.height, sheet.at(p.across, x).at[1], 1e-12);
      EXPECT_NEAR(sheet.at(p.across, x).at[0], y, 1e-12);
      EXPECT_NEAR(p.by_along, (height(step, 0) - height(-step, 0)) / (2 * step), 1e-7);
      EXPECT_NEAR(p.by_lateral, (height(0, step) - height(0, -step)) / (2 * step), 1e-7);
      EXPECT_NEAR(p.by_along2, (height(step, 0) - 2 * p.height + height(-step, 0)) / (step * step),
                  1e-6);
      EXPECT_NEAR(p.by_lateral2,
                  (height(0, step) - 2 * p.height + height(0, -step)) / (step * step), 1e-6);
      EXPECT_NEAR(
          p.by_along_lateral,
          (height(step, step) - height(step, -step) - height(-step, step) + height(-step, -step)) /
              (4 * step * step),
          1e-6);
    }
  EXPECT_FALSE(sheet.over(-0.1, 0.0)); // before the first slice
  EXPECT_FALSE(sheet.over(60.1, 0.0));
  EXPECT_FALSE(sheet.over(0.0, 31.0));
}

TEST(SurfaceSheet, SharesOfSlicesArePlaces) {
  const SurfaceSheet sheet = turning_sheet(); // 13 slices, 5 mm apart
  EXPECT_EQ(sheet.place_at(0.0), 0.0);
  EXPECT_NEAR(sheet.place_at(0.5), 30.0, 1e-12);
  EXPECT_EQ(sheet.place_at(1.0), 60.0);
}

TEST(SurfaceSheet, AShiftAlongOfAllSlicesShiftsTheSurface) {
  const SlicedProfile profile = turning(5.0);
  SlicedProfile shifted = profile;
  for (ProfileSlice& slice : shifted.slices)
    slice.place += 1024.0;
  const SurfaceSheet sheet = sheet_of(profile);
  const SurfaceSheet other = sheet_of(shifted);
  for (double x = 0.0; x < 60.0; x += 1.25)
    EXPECT_NEAR(sheet.at(17.0, x).at[1], other.at(17.0, x + 1024.0).at[1], 1e-12);
}

TEST(SurfaceSheet, RefusesFoldsWithTheNumbersOfTheSlices) {
  SlicedProfile profile = profile_of({0.0, 10.0, 20.0, 30.0}, [](double) {
    return curve_of([](double y) { // a ridge of 45 degrees on both sides
      const double root = std::hypot(y, 1.0);
      return Height{-4.0 * root, -4.0 * y / root, -4.0 / (root * root * root)};
    });
  });
  std::vector<SheetSection> sections = sections_of(profile);
  for (SheetSection& section : sections)
    section.features = {0.0, 100.0, section.curve->length()};
  sections[2].features[1] = 150.0; // on the other flank
  sections[2].number = 17;
  test::expect_error(
      ErrorCode::invalid_argument, [&] { SurfaceSheet(sections, 0.0, 0.0); },
      "the surface folds between slices 2 and 17, at lateral ", ", 17 and 4: features must join");
}

TEST(SurfaceSheet, RefusesWhatDoesNotMakeASurface) {
  const SlicedProfile profile = turning(30.0);
  std::vector<SheetSection> sections = sections_of(profile);
  const auto refuses = [&](const char* part) {
    test::expect_error(
        ErrorCode::invalid_argument, [&] { SurfaceSheet(sections, 0.0, 0.0); }, part);
  };
  sections[1].features = {0.0, 10.0, 60.0};
  refuses("features of slice 2 = 3: at least 2, the number of the other slices");
  sections[1].features = {20.0, 20.0};
  refuses("features of slice 2 = 20 after 20");
  sections.resize(1);
  refuses("number of slices = 1: at least 2");
  sections.assign(5000, sections_of(profile)[0]);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    sections[i].place = static_cast<double>(i);
    sections[i].features = {0.0, 60.0 - 1e-4 * static_cast<double>(i)};
  }
  std::vector<Curve::Piece> pieces(4000, {{0, 0, 1, 0, 0, 0}, {0.2, 0, 1, 0, 0, 0}, 0.2});
  const Curve line(pieces);
  for (SheetSection& section : sections) {
    section.curve = &line;
    section.features.back() += 700.0;
  }
  refuses("at most 2097152; use fewer slices");
}

} // namespace
} // namespace wrc::test::surface_sheet_test
