/// The crown is that of the head, beside whatever stands on the gauge side.
#include "profile/crown.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::crown_test {
namespace {

std::size_t crown(const std::vector<double>& heights) {
  return crown_among(heights);
}

TEST(Crown, IsTheHighestPlaceOfARail) {
  EXPECT_EQ(crown({-30.0, -1.0, 0.0, -1.0, -37.0}), 2U);
  EXPECT_EQ(crown({3.0}), 0U);
  EXPECT_EQ(crown({-30.0, 0.0, 0.0, -40.0}), 1U);
}

TEST(Crown, IsNotTheEdgeOfAGuardRail) {
  EXPECT_EQ(crown({0.0, 20.0, 19.0, -30.0, -14.0, -1.0, 0.0, -1.0, -37.0}), 6U);
}

TEST(Crown, IsNotWhatLiesBesideTheHead) {
  EXPECT_EQ(crown({-30.0, 0.0, -60.0, -29.0}), 1U) << "planks behind the field side";
}

TEST(Crown, MayBeThatOfABladeOrBesideAGroove) {
  EXPECT_EQ(crown({-30.0, 3.0, -30.0, 0.0, -37.0}), 1U) << "a blade stands a few mm higher";
  EXPECT_EQ(crown({0.0, 20.0, 4.0, 10.0, -5.0}), 1U) << "no groove";
  EXPECT_EQ(crown({-12.0, -45.0, -20.0, 0.0, -37.0}), 3U) << "a grooved rail's lip";
}

} // namespace
} // namespace wrc::test::crown_test
