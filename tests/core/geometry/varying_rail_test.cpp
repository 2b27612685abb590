/// Rails that vary: the files that CONTACT's examples come with, and gaps.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "geometry/varying_rail.hpp"
#include "geometry/varying_shapes.hpp"
#include "support/errors.hpp"

namespace wrc::test::varying_rail_test {
namespace {

TEST(VaryingRail, HasNothingInAGap) {
  SlicedProfile profile = profile_of({0.0, 10.0, 20.0, 30.0}, [](double) {
    return curve_of([](double y) { return crown_at(y); });
  });
  const double length = profile.slices[0].curve.length();
  profile.slices[0].features = profile.slices[1].features = {0.0, 20.0, {}, {}};
  profile.slices[2].features = profile.slices[3].features = {{}, {}, 30.0, length};
  const VaryingRail rail(profile);
  ASSERT_EQ(rail.sheets().size(), 2U);
  EXPECT_EQ(rail.along().begin, 0.0);
  EXPECT_EQ(rail.along().end, 30.0);
  EXPECT_TRUE(rail.over(5.0, -20.0));
  EXPECT_FALSE(rail.over(5.0, 20.0));
  EXPECT_FALSE(rail.over(15.0, -20.0));
  EXPECT_TRUE(rail.over(25.0, 20.0));
}

TEST(VaryingRail, TakesTheHighestOfItsSheets) {
  const Curve low = curve_of([](double y) { return Height{-1.0 + 0.01 * y, 0.01, 0.0}; });
  SlicedProfile profile = profile_of({0.0, 10.0}, [&](double) { return low; });
  const double length = low.length();
  for (ProfileSlice& slice : profile.slices)
    slice.features = {0.0, 20.0, length};
  profile.slices[0].features[0] = {}; // its left part is gone there
  const VaryingRail rail(profile);
  ASSERT_EQ(rail.sheets().size(), 1U);
  EXPECT_NEAR(rail.over(5.0, 10.0)->height, -0.9, 1e-12);
  EXPECT_FALSE(rail.over(5.0, -20.0));
}

std::filesystem::path shipped(const std::string& name) {
  return std::filesystem::path(WRCONTACT_ORIGINAL_FILES_DIR) / "slices" / name;
}

struct ShippedRail {
  const char* file;
  std::size_t slices;
  std::size_t sheets;
};

TEST(VaryingRail, TheFilesOfExamplesMakeSurfaces) {
  const ShippedRail files[] = {{"cross_nose.slcs", 21, 1},      {"wing_rail.slcs", 21, 1},
                               {"cross+wing.slcs", 21, 1},      {"cross+wing_extd.slcs", 31, 2},
                               {"uk_interrupt_v1.slcs", 20, 2}, {"uk_interrupt_v2.slcs", 20, 2}};
  if (!std::filesystem::exists(shipped(files[0].file)))
    GTEST_SKIP() << "no slices files in " << WRCONTACT_ORIGINAL_FILES_DIR;
  for (const ShippedRail& each : files) {
    const SlicedProfile profile = read_sliced_profile(shipped(each.file));
    EXPECT_EQ(profile.slices.size(), each.slices) << each.file;
    const VaryingRail rail(profile);
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

TEST(VaryingRail, ACrossingWithoutFeaturesFolds) {
  if (!std::filesystem::exists(shipped("uk_crossing.slcs")))
    GTEST_SKIP() << "no slices files in " << WRCONTACT_ORIGINAL_FILES_DIR;
  const SlicedProfile profile = read_sliced_profile(shipped("uk_crossing.slcs"));
  EXPECT_EQ(profile.slices.size(), 148U);
  test::expect_error(
      ErrorCode::invalid_argument, [&] { VaryingRail{profile}; },
      "the surface folds between slices",
      "47 and 48"); // where the nose begins
}

} // namespace
} // namespace wrc::test::varying_rail_test
