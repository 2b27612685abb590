// Slices that are the same everywhere make a profile that does not vary.
#include "profile/sliced_profile.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "profile/spline.hpp"

namespace wrc::test::sliced_profile_test {
namespace {

Curve slice_of_height(double height) {
  std::vector<Position> points;
  for (int i = 0; i <= 10; ++i) {
    points.push_back({4.0 * i, height + 0.01 * i * i});
  }
  return curve_through(points);
}

SlicedProfile two_slices(double height) {
  SlicedProfile profile;
  profile.slices.push_back({0.0, slice_of_height(0.0), {0.0, 40.0}});
  profile.slices.push_back({100.0, slice_of_height(height), {0.0, 40.0}});
  return profile;
}

TEST(SlicedProfile, HasEqualSlicesToTheLastBit) {
  EXPECT_TRUE(has_equal_slices(two_slices(0.0)));
  EXPECT_FALSE(has_equal_slices(two_slices(1e-12)));
}

TEST(SlicedProfile, AnAbsentPartMakesSlicesUnequal) {
  SlicedProfile profile = two_slices(0.0);
  profile.slices.back().features.back().reset();
  EXPECT_FALSE(has_equal_slices(profile));
}

} // namespace
} // namespace wrc::test::sliced_profile_test
