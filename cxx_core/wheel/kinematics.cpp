#include "wheel/kinematics.hpp"

#include <cmath>

#include "wheel/constants.hpp"

namespace wrc {

Motion mirrored(const Motion& motion) {
  Motion other = motion;
  other.lateral = -motion.lateral;
  other.roll = -motion.roll;
  other.yaw = -motion.yaw;
  other.curvature = -motion.curvature;
  return other;
}

RigidSlip rigid_slip(const Motion& motion, const Pose& pose, double height, double nominal_radius,
                     const ContactFrame& frame, double approach) {
  const Rotation rotation(pose);
  const Vector3 centre{0.0, pose.lateral, height};
  const Vector3 arm = frame.origin - approach * frame.normal - centre;
  const double pitch = motion.pitch.value_or(motion.speed / nominal_radius);
  const Vector3 rolling = pitch * rotation.to_track({0.0, 1.0, 0.0});
  const Vector3 turning = rolling + motion.roll * Vector3{rotation.cos_yaw, rotation.sin_yaw, 0.0} +
                          Vector3{0.0, 0.0, motion.yaw + motion.curvature * motion.speed};
  const Vector3 velocity = Vector3{motion.speed * (1.0 - motion.curvature * pose.lateral),
                                   motion.lateral, motion.vertical} +
                           cross(turning, arm);
  RigidSlip slip;
  slip.reference_speed =
      0.5 * (motion.speed * (1.0 - motion.curvature * frame.origin.y) - cross(rolling, arm).x);
  slip.slip_speed = std::hypot(slip.reference_speed, standstill_speed);
  slip.creepages = {dot(velocity, frame.longitudinal) / slip.slip_speed,
                    dot(velocity, frame.lateral) / slip.slip_speed,
                    dot(turning, frame.normal) / slip.slip_speed};
  return slip;
}

} // namespace wrc
