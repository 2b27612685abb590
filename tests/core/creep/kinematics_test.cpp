/// Creepages from the motion of a wheelset.
#include "creep/kinematics.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"

namespace wrc::test::kinematics_test {
namespace {

constexpr double radius = 460.0;

/// A contact under a wheel, this far to the left and this steep.
RigidSlip slip_at(const Motion& motion, double angle = 0.0, const Pose& pose = {}) {
  return rigid_slip({motion, pose, radius, radius, {}}, tangent_frame({0.0, 750.0, 0.1}, angle),
                    0.1, 0.0);
}

TEST(Kinematics, PureRollingHasSpinOfTheConeOnly) {
  const double angle = 0.05;
  const RigidSlip slip = slip_at({.speed = 2e4}, angle);
  EXPECT_NEAR(slip.creepages.longitudinal, 0.1 * (1.0 - std::cos(angle)) / radius, 1e-9);
  EXPECT_NEAR(slip.creepages.lateral, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(slip.creepages.spin), std::sin(angle) / radius, 1e-9);
  EXPECT_NEAR(slip.reference_speed, 2e4, 10.0);
}

TEST(Kinematics, EachVelocityHasItsCreepage) {
  const double speed = 2e4;
  EXPECT_NEAR(slip_at({.speed = speed, .pitch = 1.002 * speed / radius}).creepages.longitudinal,
              -0.002, 1e-5);
  EXPECT_NEAR(slip_at({.speed = speed, .lateral = 20.0}).creepages.lateral, 1e-3, 1e-8);
  // The left wheel goes backwards when the front turns to the left.
  const RigidSlip yawing = slip_at({.speed = speed, .yaw = 0.02});
  EXPECT_NEAR(yawing.creepages.longitudinal, -0.02 * 750.0 / speed, 1e-8);
  EXPECT_NEAR(yawing.creepages.spin, 0.02 / speed, 1e-12);
  // A yawed wheel that rolls along the track creeps towards the other side.
  EXPECT_NEAR(slip_at({.speed = speed}, 0.0, {.yaw = 0.002}).creepages.lateral, -0.002, 1e-6);
  EXPECT_NEAR(slip_at({.speed = speed, .vertical = 10.0}, 0.1).creepages.lateral,
              10.0 * std::sin(0.1) / speed, 1e-8);
  EXPECT_NEAR(slip_at({.speed = speed, .roll = 0.01}).creepages.lateral, 0.01 * radius / speed,
              1e-8);
}

// In a curve of 1000 m radius the left rail is shorter by 750 mm in it, and so is the way there.
TEST(Kinematics, CurvesTurnTheWheelset) {
  const RigidSlip slip = slip_at({.speed = 2e4, .curvature = 1e-6});
  const double share = 1.0 - 0.5 * 750e-6;
  EXPECT_NEAR(slip.reference_speed, share * 2e4, 1e-6);
  EXPECT_NEAR(slip.creepages.longitudinal, -750e-6 / share, 1e-9);
  EXPECT_NEAR(slip.creepages.spin, 1e-6 / share, 1e-12);
}

// With the velocities, whatever their ratio.
TEST(Kinematics, CreepagesGoToZeroAtStandstill) {
  for (const double factor : {1.0, 1e-3, 1e-6, 0.0}) {
    const RigidSlip slip = slip_at({.speed = factor, .pitch = 0.0, .lateral = factor});
    EXPECT_LE(std::hypot(slip.creepages.longitudinal, slip.creepages.lateral), 2.0 * factor);
    EXPECT_TRUE(std::isfinite(slip.creepages.spin));
    EXPECT_GT(slip.slip_speed, 0.0);
  }
}

TEST(Kinematics, BackwardsTheReferenceSpeedIsNegative) {
  EXPECT_NEAR(slip_at({.speed = -2e4}).reference_speed, -2e4, 10.0);
}

TEST(Kinematics, ARisingRailIsALevelOneTurnedAboutTheTracksY) {
  constexpr double rounding = 1e-12;
  const double speed = 2e4;
  for (const double angle : {0.05, 0.6, 1.2})
    for (const double slope : {0.05, -0.19}) {
      const ContactFrame level = tangent_frame({0.0, 730.0, 3.0}, angle);
      const Vector3 normal = tilted(level.normal, slope);
      const Vector3 centre = tilted({0.0, 0.0, radius}, slope);
      Vector3 origin = tilted(level.origin, slope);
      origin.x -= centre.x;
      const ContactFrame rising = tangent_frame(origin, std::atan2(-normal.y, normal.z),
                                                -normal.x / std::hypot(normal.y, normal.z));
      EXPECT_LT(norm(rising.longitudinal - tilted(level.longitudinal, slope)), rounding);
      EXPECT_LT(norm(rising.lateral - tilted(level.lateral, slope)), rounding);
      EXPECT_LT(norm(rising.normal - normal), rounding);

      WheelsetMotion motion{
          {.speed = speed / std::cos(slope), .pitch = speed / radius}, {}, radius, radius, {}};
      motion.follows_surface = true;
      const RigidSlip on_level = rigid_slip(motion, level, 0.1, 0.0);
      motion.motion.speed = speed;
      motion.height = centre.z;
      const RigidSlip on_rising = rigid_slip(motion, rising, 0.1, origin.x);
      for (std::size_t i = 0; i < on_level.twist.size(); ++i)
        EXPECT_NEAR(on_rising.twist[i], on_level.twist[i], rounding) << angle << ' ' << slope;
      EXPECT_NEAR(on_rising.reference_speed, on_level.reference_speed, rounding * speed);
    }
}

} // namespace
} // namespace wrc::test::kinematics_test
