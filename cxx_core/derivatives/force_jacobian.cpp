#include "derivatives/force_jacobian.hpp"

#include <algorithm>
#include <cmath>

#include "creep/friction.hpp"
#include "creep/kinematics.hpp"
#include "creep/rigid_slip.hpp"
#include "creep/rolling_frame.hpp"
#include "derivatives/gap_rates.hpp"
#include "records/wheel_result.hpp"

namespace wrc {
namespace {

using Vector = VectorOf<RatedByState>;

Vector constant(const Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}

void add_rate(Vector& vector, std::size_t position, const Vector3& rate) {
  vector.x.rates[position] += rate.x;
  vector.y.rates[position] += rate.y;
  vector.z.rates[position] += rate.z;
}

/// The point is one approach below the reference, which moves along the rail.
MovingFrame moving_frame(const PatchResult& patch, const PatchRates& rates, const Vector3& centre,
                         const Pose& pose) {
  const ContactFrame& frame = patch.frame;
  const Vector3 place = frame.origin - patch.approach * frame.normal;
  MovingFrame moving{constant(frame.longitudinal),
                     constant(frame.lateral),
                     constant(frame.normal),
                     constant(place),
                     constant(centre),
                     frame.origin.y,
                     patch.reference.s_wheel,
                     patch.penetration.ahead - patch.approach * frame.normal.x};
  const auto motions = all_motions(pose.yaw);
  const Vector3 axle = Rotation(pose).to_track({0.0, 1.0, 0.0});
  for (std::size_t i = 0; i < position_count; ++i) {
    const RigidMotion& motion = motions[i];
    const Vector3 of_wheel = motion.translation + cross(motion.rotation, place - centre);
    add_rate(moving.lateral, i, rates.angle[i] * frame.normal);
    add_rate(moving.normal, i, -rates.angle[i] * frame.lateral);
    const Vector3 of_place = rates.reference[i] + rates.gap[i] * frame.normal;
    add_rate(moving.place, i, of_place);
    moving.s_wheel.rates[i] = dot(of_place - of_wheel, axle);
    add_rate(moving.centre, i, motion.translation);
    moving.reference_y.rates[i] = rates.reference[i].y;
  }
  return moving;
}

/// What a patch's creep forces depend on, left-hand frame.
struct CreepState {
  std::array<RatedByState, 3> creepages;
  RatedByState friction;
  RatedByState normal_velocity; ///< over that of slip
  RatedByState rolling_share;   ///< of a step of time and along a curve
};

/// The geometry of slip with its derivatives by positions; of planar slip that of the reference.
std::array<std::array<RatedByState, twist_count>, 3> rated_geometry(const PatchResult& patch) {
  std::array<std::array<RatedByState, twist_count>, 3> rated{};
  const CreepagesByTwist by =
      patch.slip ? patch.slip->creepages_by_twist : creepages_of_planar_slip();
  const auto& by_position = patch.creep->derivatives->slip_by_position;
  for (std::size_t creepage = 0; creepage < rated.size(); ++creepage) {
    for (std::size_t i = 0; i < twist_count; ++i) {
      RatedByState& element = rated[creepage][i];
      element.value = by[creepage][i];
      for (std::size_t position = 0; by_position && position < position_count; ++position) {
        element.rates[position] = (*by_position)[position][creepage][i];
      }
    }
  }
  return rated;
}

CreepState creep_state_of(const CreepResult& creep, const WheelDetails& details,
                          const MovingFrame& frame,
                          const std::array<std::array<RatedByState, twist_count>, 3>& geometry) {
  const Creepages constant = RollingFrame(details.mirror).mirrored(creep.creepages);
  std::array<RatedByState, 3> creepages{constant.longitudinal, constant.lateral, constant.spin};
  RatedByState slip_speed = creep.slip_speed;
  RatedByState normal_velocity;
  RatedByState rolling_share;
  if (details.motion) {
    RatedSlip slip = rated_slip(*details.motion, frame);
    if (!creep.displacement_x.empty()) { // a step, where the speed is only a unit of slip: hold it
      const double unit = slip.slip_speed.value;
      for (RatedByState& velocity : slip.twist) {
        velocity = velocity * slip.slip_speed / unit;
      }
      slip.slip_speed = unit;
    }
    rolling_share =
        slip.reference_speed * (slip.reference_speed.value < 0.0 ? -1.0 : 1.0) / slip.slip_speed;
    slip_speed = slip.slip_speed;
    normal_velocity = slip.twist[2];
    for (std::size_t creepage = 0; creepage < creepages.size(); ++creepage) {
      creepages[creepage] = 0.0;
      for (std::size_t i = 0; i < twist_count; ++i) {
        creepages[creepage] = creepages[creepage] + geometry[creepage][i] * slip.twist[i];
      }
    }
  }
  const auto& [longitudinal, lateral, spin] = creepages;
  const RatedByState speed = slip_speed * sqrt(longitudinal * longitudinal + lateral * lateral);
  return {creepages, friction_of(details.friction, frame.s_wheel, speed), normal_velocity,
          rolling_share};
}

/// Derivatives of a patch's longitudinal and lateral creep force, its spin moment and the force
/// along the normal beyond them, left-hand frame.
std::array<RatedByState, 4> rated_creep_forces(const CreepResult& creep, const RollingFrame& side,
                                               const PatchRates& rates, const CreepState& state) {
  const CreepForces fitted =
      side.mirrored(CreepForces{creep.longitudinal_force, creep.lateral_force, creep.spin_moment});
  const std::array<double, 4> forces{fitted.longitudinal, fitted.lateral, fitted.spin_moment,
                                     creep.beyond_creepages[2]};
  const CreepDerivatives derivatives = side.mirrored(*creep.derivatives);
  std::array<RatedByState, 4> rated;
  for (std::size_t row = 0; row < forces.size(); ++row) {
    const bool beyond = row == 3;
    const double* by_creepage =
        beyond ? derivatives.normal_by_creepage.data() : derivatives.by_creepage.data() + 3 * row;
    rated[row].value = forces[row];
    for (std::size_t i = 0; i < state_count; ++i) {
      double& rate = rated[row].rates[i];
      rate = beyond ? 0.0 : derivatives.by_friction[row] * state.friction.rates[i];
      for (std::size_t c = 0; c < state.creepages.size(); ++c) {
        rate += by_creepage[c] * state.creepages[c].rates[i];
      }
      if (derivatives.by_rolling_share) {
        rate += (*derivatives.by_rolling_share)[row] * state.rolling_share.rates[i];
      }
      if (i >= position_count) {
        rate += derivatives.by_normal_velocity[row] * state.normal_velocity.rates[i];
      } else if (beyond) {
        rate += derivatives.normal_by_position[i];
      } else {
        rate += derivatives.by_position ? (*derivatives.by_position)[row * position_count + i]
                                        : derivatives.by_load[row] * rates.normal_force[i];
      }
    }
  }
  return rated;
}

/// Adds the rates of a force and a moment.
void add(ForceJacobian& jacobian, const Vector& force, const Vector& moment) {
  const std::array<const RatedByState*, 6> rows{&force.x,  &force.y,  &force.z,
                                                &moment.x, &moment.y, &moment.z};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < state_count; ++i) {
      jacobian[row][i] += rows[row]->rates[i];
    }
  }
}

void add_normal_forces(ForceJacobian& jacobian, const ForceRates& rates) {
  Vector force{};
  Vector moment{};
  for (std::size_t i = 0; i < position_count; ++i) {
    add_rate(force, i, rates[i].force);
    add_rate(moment, i, rates[i].moment);
  }
  add(jacobian, force, moment);
}

} // namespace

std::array<RatedByState, 4> rated_creep_forces(const WheelResult& wheel, const PatchResult& patch,
                                               const PatchRates& rates) {
  const WheelDetails& details = wheel.details;
  const Vector3 centre{0.0, details.pose.lateral, details.vertical};
  return rated_creep_forces(*patch.creep, RollingFrame(details.mirror), rates,
                            creep_state_of(*patch.creep, details,
                                           moving_frame(patch, rates, centre, details.pose),
                                           rated_geometry(patch)));
}

bool jacobian_is_known(const WheelResult& wheel) {
  return std::ranges::all_of(solved_patches(wheel), [](const PatchResult* patch) {
    return !patch->creep || patch->creep->derivatives || !(patch->normal_force > 0.0);
  });
}

ForceJacobian jacobian_of(const WheelResult& wheel, const WheelRates& rates) {
  const WheelDetails& details = wheel.details;
  const RollingFrame side(details.mirror);
  const Vector3 centre{0.0, details.pose.lateral, details.vertical};
  ForceJacobian jacobian{};
  const std::vector<const PatchResult*> patches = solved_patches(wheel);
  const bool slides = std::ranges::any_of(
      patches, [](const PatchResult* patch) { return patch->creep && patch->creep->derivatives; });
  const ForceRates& normal = slides ? rates.by_pressures : rates.force;
  add_normal_forces(jacobian, side.mirrored(normal));
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchResult& patch = *patches[k];
    if (!patch.creep || !patch.creep->derivatives) {
      continue;
    }
    const MovingFrame frame = moving_frame(patch, rates.patches[k], centre, details.pose);
    const auto geometry = rated_geometry(patch);
    const std::array<RatedByState, 4> forces =
        rated_creep_forces(*patch.creep, side, rates.patches[k],
                           creep_state_of(*patch.creep, details, frame, geometry));
    const auto along = [&](std::size_t i) {
      return forces[0] * geometry[0][i] + forces[1] * geometry[1][i] + forces[2] * geometry[2][i] +
             (i == 2 ? forces[3] : RatedByState(patch.creep->beyond_creepages[i]));
    };
    const auto in_frame = [&](std::size_t first) {
      return along(first) * frame.longitudinal + along(first + 1) * frame.lateral +
             along(first + 2) * frame.normal;
    };
    const Vector force = in_frame(0);
    add(jacobian, force, cross(frame.place - frame.centre, force) + in_frame(3));
  }
  return side.mirrored(jacobian);
}

} // namespace wrc
