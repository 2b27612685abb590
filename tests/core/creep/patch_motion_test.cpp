// Creepages at other places of a plane, and those of a wheel from its motion or as given.
#include "creep/patch_motion.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "records/wheel_result.hpp"

namespace wrc::test::patch_motion_test {
namespace {

/// A rigid field: places are reached in any order, and spin is the same everywhere.
TEST(PatchMotion, CreepagesAreARigidField) {
  const Creepages at{1e-3, -2e-3, 4e-4};
  const Creepages there = creepages_at(at, 3.0, -5.0);
  EXPECT_DOUBLE_EQ(there.longitudinal, 1e-3 + 4e-4 * 5.0);
  EXPECT_DOUBLE_EQ(there.lateral, -2e-3 + 4e-4 * 3.0);
  EXPECT_EQ(there.spin, at.spin);
  const Creepages back = creepages_at(there, -3.0, 5.0);
  EXPECT_NEAR(back.longitudinal, at.longitudinal, 1e-18);
  EXPECT_NEAR(back.lateral, at.lateral, 1e-18);
}

/// A patch 4 mm behind and 6 mm beside the plane's origin, on either side.
class GivenCreepages : public testing::Test {
protected:
  GivenCreepages() {
    for (PatchResult* one : {&whole_, &patch_}) {
      one->frame.longitudinal = {1.0, 0.0, 0.0};
      one->frame.lateral = {0.0, 1.0, 0.0};
      one->frame.normal = {0.0, 0.0, 1.0};
    }
    patch_.frame.origin = {-4.0, 6.0, 0.0};
    request_.creepages = {1e-3, 2e-3, 3e-4};
    request_.speed = 2e4;
  }
  [[nodiscard]] PatchMotion motion_on(double mirror) {
    wheel_.details.mirror = mirror;
    return motion_of(patch_, whole_, wheel_, request_);
  }

  WheelResult wheel_;
  PatchResult whole_;
  PatchResult patch_;
  CreepRequest request_;
};

TEST_F(GivenCreepages, AreCarriedToThePatch) {
  const PatchMotion motion = motion_on(1.0);
  EXPECT_DOUBLE_EQ(motion.creepages.longitudinal, 1e-3 - 3e-4 * 6.0);
  EXPECT_DOUBLE_EQ(motion.creepages.lateral, 2e-3 - 3e-4 * 4.0);
  EXPECT_EQ(motion.slip_speed, 2e4);
  EXPECT_EQ(motion.frame.turned(motion.creepages).longitudinal, motion.creepages.longitudinal);
  EXPECT_FALSE(motion.twist);
}

TEST_F(GivenCreepages, OfTheRightSideAreMirrored) {
  const PatchMotion motion = motion_on(-1.0);
  EXPECT_DOUBLE_EQ(motion.creepages.longitudinal, 1e-3 + 3e-4 * 6.0);
  EXPECT_DOUBLE_EQ(motion.creepages.lateral, -2e-3 + 3e-4 * 4.0);
  EXPECT_EQ(motion.creepages.spin, -3e-4);
}

} // namespace
} // namespace wrc::test::patch_motion_test
