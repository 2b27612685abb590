#include "wheel/total_force.hpp"

namespace wrc {
namespace {

/// From the left-hand frame of a side.
Vector3 in_track(const Vector3& vector, double mirror) {
  return {vector.x, mirror * vector.y, vector.z};
}

struct ForceAndMoment {
  Vector3 force;
  Vector3 moment; ///< about the origin of the patch's frame
};

/// Of a patch without parts.
ForceAndMoment creep_wrench_on(const PatchResult& patch, double mirror) {
  const CreepResult& creep = *patch.creep;
  const Wrench fitted = wrench_of(
      patch.slip ? patch.slip->creepages_by_twist : creepages_of_planar_slip(),
      {creep.longitudinal_force, mirror * creep.lateral_force, mirror * creep.spin_moment});
  const auto in_frame = [&](std::size_t first) {
    const auto along = [&](std::size_t i) { return fitted[i] + creep.beyond_creepages[i]; };
    return in_track(along(first) * patch.frame.longitudinal +
                        along(first + 1) * patch.frame.lateral +
                        along(first + 2) * patch.frame.normal,
                    mirror);
  };
  // A moment is a pseudovector: the mirror turns it the other way.
  return {in_frame(0), mirror * in_frame(3)};
}

void add_up_force(PatchResult& patch, double mirror) {
  patch.total_force = patch.force;
  for (PatchResult& part : patch.parts) {
    add_up_force(part, mirror);
    patch.total_force = patch.total_force + (part.total_force - part.force);
  }
  if (patch.creep && patch.parts.empty()) {
    patch.total_force = patch.force + creep_wrench_on(patch, mirror).force;
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
    total.moment = total.moment + patch.moment + cross(arm(patch.reference), patch.force);
  }
  for (const PatchResult* patch : solved_patches(wheel)) {
    if (patch->creep) {
      const ForceAndMoment creep = creep_wrench_on(*patch, mirror);
      // Where the velocity is that creepages stand for (wheel/kinematics.hpp).
      const Vector3 place =
          in_track(patch->frame.origin - patch->approach * patch->frame.normal, mirror) - centre;
      total.force = total.force + creep.force;
      total.moment = total.moment + cross(place, creep.force) + creep.moment;
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
