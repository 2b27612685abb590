/// Where sheets begin and end, and their smoothing length.
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/sliced_sheets.hpp"
#include "geometry/sliced_surface.hpp"
#include "geometry/varying_shapes.hpp"
#include "profile/limits.hpp"
#include "support/errors.hpp"

namespace wrc::test::sliced_sheets_test {
namespace {

constexpr std::nullopt_t absent = std::nullopt;
using Features = std::vector<std::optional<double>>;

SlicedProfile profile_with(const std::vector<Features>& features) {
  const Curve curve = curve_of([](double y) { return crown_at(y); });
  SlicedProfile profile =
      profile_of(places_every(0.0, 10.0 * static_cast<double>(features.size() - 1), 10.0),
                 [&](double) { return curve; });
  for (std::size_t i = 0; i < features.size(); ++i)
    profile.slices[i].features = features[i];
  return profile;
}

TEST(SlicedSheets, PartsThatBeginAndEndAreSeparateSheets) {
  // The wing ends after slice 3, the nose begins with slice 2; both are there in 2 and 3.
  const SlicedProfile profile = profile_with({{0.0, 10.0, 20.0, absent, absent},
                                              {0.0, 10.0, 20.0, 30.0, 50.0},
                                              {0.0, 11.0, 21.0, 31.0, 50.0},
                                              {absent, absent, 22.0, 32.0, 50.0},
                                              {absent, absent, absent, 32.0, 50.0}});
  const std::vector<SheetExtent> extents = sheet_extents(profile);
  ASSERT_EQ(extents.size(), 3U);
  const auto expect = [&](std::size_t i, std::size_t first_part, std::size_t last_part,
                          std::size_t first_slice, std::size_t last_slice) {
    EXPECT_EQ(extents[i].first_part, first_part) << i;
    EXPECT_EQ(extents[i].last_part, last_part) << i;
    EXPECT_EQ(extents[i].first_slice, first_slice) << i;
    EXPECT_EQ(extents[i].last_slice, last_slice) << i;
  };
  expect(0, 0, 1, 0, 2);
  expect(1, 2, 2, 1, 3);
  expect(2, 3, 3, 1, 4);
  const std::vector<SurfaceSheet> sheets = sheets_of(profile, 0.0, 0.0);
  ASSERT_EQ(sheets.size(), 3U);
  EXPECT_EQ(sheets[0].along().end, 20.0);
  EXPECT_EQ(sheets[1].along().begin, 10.0);
  EXPECT_EQ(sheets[2].along().end, 40.0);
}

TEST(SlicedSheets, SheetsMeetAtTheSlicesThatTheyShare) {
  const SlicedProfile profile =
      profile_with({{absent, 10.0, 50.0}, {0.0, 12.0, 50.0}, {0.0, 11.0, 50.0}, {0.0, 15.0, 50.0}});
  const std::vector<SurfaceSheet> sheets = sheets_of(profile, 0.0, 0.0);
  ASSERT_EQ(sheets.size(), 2U);
  for (const double x : {10.0, 20.0, 30.0}) {
    const SheetPoint left = sheets[0].at(sheets[0].across().end, x);
    const SheetPoint right = sheets[1].at(sheets[1].across().begin, x);
    EXPECT_NEAR(left.at[0], right.at[0], 1e-10);
    EXPECT_NEAR(left.at[1], right.at[1], 1e-10);
  }
}

TEST(SlicedSheets, APartInASingleSliceHasNoSheet) {
  const SlicedProfile profile = profile_with({{0.0, 10.0, 50.0}, {absent, 10.0, 50.0}});
  EXPECT_EQ(sheet_extents(profile).size(), 1U);
  const SlicedProfile none = profile_with({{0.0, 10.0, absent}, {absent, 10.0, 50.0}});
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)sheets_of(none, 0.0, 0.0); },
      "no part in two slices that follow each other");
}

TEST(SlicedSheets, RefusesMoreSheetsThanAreAllowed) {
  // The nose is there in two of three slices, again and again.
  std::vector<Features> features;
  for (std::size_t i = 0; i < 3 * SliceLimits::max_sheets; ++i)
    features.push_back(i % 3 < 2 ? Features{0.0, 10.0, 50.0} : Features{0.0, 10.0, absent});
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)sheet_extents(profile_with(features)); },
      "more than 1000");
}

TEST(SlicedSheets, SmoothingLengthIsThatGivenOrTheLists) {
  SlicedProfile profile = profile_with({{}, {}, {}, {}});
  EXPECT_EQ(smoothing_length_of(profile, {}), 0.0);
  EXPECT_EQ(smoothing_length_of(profile, 3.0), 3.0);
  profile.is_smoothed = true;
  EXPECT_EQ(smoothing_length_of(profile, {}), 40.0);
  EXPECT_EQ(smoothing_length_of(profile, 0.0), 0.0);
}

/// The unit is that of the caller's length: a wheel's key is in mm, its slices are in rad.
TEST(SlicedSheets, ASmoothingLengthTooLongForTheSlicesIsRefusedInItsOwnUnit) {
  const SlicedProfile rail = profile_with({{}, {}, {}, {}});
  EXPECT_NO_THROW((void)sheets_of(rail, 10000.0, 0.0));
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)sheets_of(rail, 12000.0, 0.0); },
      "= 12000 mm: at most 10000 mm, 1000 times the smallest distance between two slices, 10 mm");
  const Curve curve = curve_of([](double y) { return crown_at(y); });
  SlicedProfile wheel = profile_of({0.0, 0.01, 0.5, 3.0}, [&](double) { return curve; });
  wheel.kind = ProfileKind::wheel;
  EXPECT_NO_THROW((void)sliced_wheel(wheel, 460.0, {}, 4500.0));
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)sliced_wheel(wheel, 460.0, {}, 5000.0); },
      "= 5000 mm: at most 4600 mm, 1000 times the smallest distance between two slices, 4.6 mm");
  const double revolution = 2.0 * std::numbers::pi;
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)sheets_of(wheel, 11.0, revolution, {"rad"}); },
      "= 11 rad: at most 10 rad, 1000 times the smallest distance between two slices, 0.01 rad");
}

} // namespace
} // namespace wrc::test::sliced_sheets_test
