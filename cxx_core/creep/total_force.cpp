#include "creep/total_force.hpp"

#include "creep/rolling_frame.hpp"

namespace wrc {
namespace {

/// Force and moment of a patch without parts, about the origin of its frame.
ContactForce creep_wrench_on(const PatchResult& patch, const RollingFrame& side) {
  const CreepResult& creep = *patch.creep;
  const CreepForces forces =
      side.mirrored(CreepForces{creep.longitudinal_force, creep.lateral_force, creep.spin_moment});
  const Wrench fitted =
      wrench_of(patch.slip ? patch.slip->creepages_by_twist : creepages_of_planar_slip(),
                {forces.longitudinal, forces.lateral, forces.spin_moment});
  const auto in_frame = [&](std::size_t first) {
    const auto along = [&](std::size_t i) { return fitted[i] + creep.beyond_creepages[i]; };
    return along(first) * patch.frame.longitudinal + along(first + 1) * patch.frame.lateral +
           along(first + 2) * patch.frame.normal;
  };
  return {side.mirrored(in_frame(0)), side.mirrored_moment(in_frame(3))};
}

void add_up_force(PatchResult& patch, const RollingFrame& side) {
  patch.total_force = patch.force;
  for (PatchResult& part : patch.parts) {
    add_up_force(part, side);
    patch.total_force = patch.total_force + (part.total_force - part.force);
  }
  if (patch.creep && patch.parts.empty()) {
    patch.total_force = patch.force + creep_wrench_on(patch, side).force;
  }
}

} // namespace

WheelForce total_force(const WheelResult& wheel) {
  const RollingFrame side(wheel.details.mirror);
  const Vector3 centre =
      side.mirrored(Vector3{0.0, wheel.details.pose.lateral, wheel.details.vertical});
  const auto arm = [&](const ContactPoint& point) {
    return Vector3{point.x, point.y, point.z} - centre;
  };
  WheelForce total;
  for (const PatchResult& patch : wheel.patches) {
    total.force = total.force + patch.force;
    total.moment = total.moment + patch.moment + cross(arm(patch.reference), patch.force);
  }
  for (const PatchResult* patch : solved_patches(wheel)) {
    if (patch->creep) {
      const ContactForce creep = creep_wrench_on(*patch, side);
      // Where the velocity is that creepages stand for (creep/kinematics.hpp).
      const Vector3 place =
          side.mirrored(patch->frame.origin - patch->approach * patch->frame.normal) - centre;
      total.force = total.force + creep.force;
      total.moment = total.moment + cross(place, creep.force) + creep.moment;
    }
  }
  return total;
}

void add_up_forces(WheelResult& wheel) {
  for (PatchResult& patch : wheel.patches) {
    add_up_force(patch, RollingFrame(wheel.details.mirror));
  }
}

} // namespace wrc
