// Friction too small to compute with: what is solved instead is the same problem, scaled.
#include "creep/least_friction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "records/creep_result.hpp"

namespace wrc::test::least_friction_test {
namespace {

PatchMotion motion_of(double friction, const Creepages& creepages) {
  PatchMotion motion;
  motion.friction = friction;
  motion.creepages = creepages;
  return motion;
}

TEST(LeastFriction, UsualFrictionIsLeftAlone) {
  for (const double friction : {0.0, least_friction, 0.3}) {
    const LeastFriction least(motion_of(friction, {1e-3, 2e-3, 1e-4}), CreepModel::full);
    EXPECT_EQ(least.motion().friction, friction);
    EXPECT_EQ(least.motion().creepages.lateral, 2e-3);
    CreepForces forces{1.0, 2.0, 3.0};
    CreepResult creep;
    creep.slip_x = {4.0};
    least.take_back(forces, creep);
    EXPECT_EQ(forces.lateral, 2.0);
    EXPECT_EQ(creep.slip_x.front(), 4.0);
  }
}

TEST(LeastFriction, TheLinearLawIgnoresFriction) {
  const LeastFriction least(motion_of(1e-40, {1e-3, 0.0, 0.0}), CreepModel::linear);
  EXPECT_EQ(least.motion().friction, 1e-40);
}

/// T(c mu, c w) = c T(mu, w): small creepages are scaled up with friction, and back.
TEST(LeastFriction, SmallCreepagesScaleWithFriction) {
  constexpr double c = 1e-10;
  const Creepages small{3e-40, -4e-40, 1e-41};
  PatchMotion given = motion_of(c * least_friction, small);
  given.twist = Twist{3e-40, -4e-40, 0.0, 0.0, 0.0, 1e-41};
  const LeastFriction least(given, CreepModel::full);
  EXPECT_EQ(least.motion().friction, least_friction);
  EXPECT_NEAR(least.motion().creepages.longitudinal * c / small.longitudinal, 1.0, 1e-14);
  EXPECT_NEAR((*least.motion().twist)[1] * c / small.lateral, 1.0, 1e-14);
  CreepForces forces{10.0, -20.0, 30.0};
  CreepResult creep;
  creep.largest_traction = 7.0;
  creep.power_per_speed = 5.0;
  creep.slip_x = {2.0};
  creep.derivatives.emplace();
  creep.derivatives->by_creepage[4] = 11.0;
  creep.derivatives->by_friction[1] = 13.0;
  least.take_back(forces, creep);
  EXPECT_NEAR(forces.lateral / (-20.0 * c), 1.0, 1e-14);
  EXPECT_NEAR(creep.largest_traction / (7.0 * c), 1.0, 1e-14);
  EXPECT_NEAR(creep.power_per_speed / (5.0 * c * c), 1.0, 1e-14) << "force times creepage";
  EXPECT_NEAR(creep.slip_x.front() / (2.0 * c), 1.0, 1e-14);
  EXPECT_NEAR(creep.derivatives->by_creepage[4], 11.0, 1e-12) << "the ratio of both";
  EXPECT_EQ(creep.derivatives->by_friction[1], 13.0);
}

/// From a creepage of 1 on all slides: forces scale, creepages do not.
TEST(LeastFriction, LargeCreepagesStay) {
  const Creepages large{1.0, 0.0, 0.0};
  const LeastFriction least(motion_of(1e-5 * least_friction, large), CreepModel::full);
  EXPECT_EQ(least.motion().creepages.longitudinal, 1.0);
  CreepForces forces{10.0, 0.0, 0.0};
  CreepResult creep;
  creep.slip_x = {1.0};
  least.take_back(forces, creep);
  EXPECT_NEAR(forces.longitudinal, 10.0 * 1e-5, 1e-18);
  EXPECT_EQ(creep.slip_x.front(), 1.0);
}

} // namespace
} // namespace wrc::test::least_friction_test
