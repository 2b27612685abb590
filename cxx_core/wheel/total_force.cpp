#include "wheel/total_force.hpp"

namespace wrc {
namespace {

/// From the left-hand frame of a side.
Vector3 in_track(const Vector3& vector, double mirror) {
  return {vector.x, mirror * vector.y, vector.z};
}

Vector3 creep_force_on(const PatchResult& patch, double mirror) {
  const Vector3 to_the_left = mirror * in_track(patch.frame.lateral, mirror);
  return patch.creep->longitudinal_force * in_track(patch.frame.longitudinal, mirror) +
         patch.creep->lateral_force * to_the_left;
}

void add_up_force(PatchResult& patch, double mirror) {
  patch.total_force = patch.creep ? patch.force + creep_force_on(patch, mirror) : patch.force;
  for (PatchResult& part : patch.parts) {
    add_up_force(part, mirror);
  }
}

} // namespace

TotalForce total_force(const WheelResult& wheel) {
  const double mirror = wheel.details.mirror;
  const Vector3 centre{0.0, mirror * wheel.details.pose.lateral, wheel.vertical - wheel.depth};
  const auto arm = [&](const ContactPoint& point) {
    return Vector3{point.x, point.y, point.z} - centre;
  };
  TotalForce total;
  for (const PatchResult& patch : wheel.patches) {
    total.force = total.force + patch.force;
    total.moment = total.moment + cross(arm(patch.centroid), patch.force);
    if (patch.creep) {
      const Vector3 force = creep_force_on(patch, mirror);
      total.force = total.force + force;
      const Vector3 normal = in_track(patch.frame.normal, mirror);
      // Where the velocity is that creepages stand for (wheel/kinematics.hpp).
      const Vector3 place = arm(patch.reference) - patch.approach * normal;
      total.moment = total.moment + cross(place, force) + patch.creep->spin_moment * normal;
    }
  }
  return total;
}

void add_up_forces(WheelResult& wheel) {
  for (PatchResult& patch : wheel.patches) {
    add_up_force(patch, wheel.details.mirror);
  }
}

} // namespace wrc
