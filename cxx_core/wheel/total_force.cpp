#include "wheel/total_force.hpp"

namespace wrc {

TotalForce total_force(const WheelResult& wheel) {
  const double mirror = wheel.details.mirror;
  const Vector3 centre{0.0, mirror * wheel.details.pose.lateral, wheel.vertical - wheel.depth};
  const auto arm = [&](const ContactPoint& point) {
    return Vector3{point.x, point.y, point.z} - centre;
  };
  const auto in_track = [mirror](const Vector3& vector) {
    return Vector3{vector.x, mirror * vector.y, vector.z};
  };
  TotalForce total;
  for (const PatchResult& patch : wheel.patches) {
    total.force = total.force + patch.force;
    total.moment = total.moment + patch.moment + cross(arm(patch.reference), patch.force);
    if (patch.creep) {
      const CreepResult& creep = *patch.creep;
      const Vector3 to_the_left = mirror * in_track(patch.frame.lateral);
      const Vector3 force = creep.longitudinal_force * in_track(patch.frame.longitudinal) +
                            creep.lateral_force * to_the_left;
      total.force = total.force + force;
      const Vector3 normal = in_track(patch.frame.normal);
      // Where the velocity is that creepages stand for (wheel/kinematics.hpp).
      const Vector3 place = arm(patch.reference) - patch.approach * normal;
      total.moment = total.moment + cross(place, force) + creep.spin_moment * normal;
    }
  }
  return total;
}

} // namespace wrc
