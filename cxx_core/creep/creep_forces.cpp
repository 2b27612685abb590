#include "creep/creep_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "creep/constants.hpp"
#include "creep/creep_elements.hpp"
#include "creep/creep_of_unlike_bodies.hpp"
#include "creep/creep_on_patch.hpp"
#include "creep/creep_rates.hpp"
#include "creep/least_friction.hpp"
#include "creep/patch_motion.hpp"
#include "records/wheel_result.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"

namespace wrc {
namespace {

/// The Hertzian ellipse with the second moments of pressures, and its centre from the reference.
struct EllipseInPlane {
  double longitudinal_semi_axis, lateral_semi_axis;
  double load;
  double x, y;
};

EllipseInPlane ellipse_of(const Grid& grid, const PressureRegion& contact, double load) {
  // Contact on a single line of elements has no second moment across it.
  return {std::max(contact.semi_axis_longitudinal, 0.5 * grid.longitudinal_step),
          std::max(contact.semi_axis_lateral, 0.5 * grid.lateral_step), load,
          contact.centroid_longitudinal, contact.centroid_lateral};
}

/// About the reference.
CreepForces forces_on_ellipse(const EllipseInPlane& contact, const PatchMotion& motion,
                              const CreepRequest& request, CreepResult& creep) {
  const RollingEllipse ellipse{
      contact.longitudinal_semi_axis, contact.lateral_semi_axis, contact.load, motion.friction,
      request.material.modulus,       request.material.poisson};
  const double x = contact.x;
  const double y = contact.y;
  const Creepages centre = motion.frame.turned(creepages_at(motion.creepages, x, y));
  const KalkerCoefficients coefficients = kalker_coefficients(ellipse);
  CreepForces forces;
  if (request.model == CreepModel::linear) {
    forces = linear_forces(ellipse, coefficients, centre);
  } else if (request.model == CreepModel::shen_hedrick_elkins) {
    forces = shen_hedrick_elkins_forces(ellipse, coefficients, centre);
  } else if (request.model == CreepModel::polach) {
    forces = polach_forces(ellipse, coefficients, centre);
  } else {
    const FastsimForces fastsim =
        fastsim_forces(ellipse, flexibilities_of(ellipse, coefficients), centre);
    forces = fastsim.forces;
    creep.slip_area = fastsim.slip_area;
    creep.adhesion_area = fastsim.adhesion_area;
  }
  forces = motion.frame.turned(forces);
  forces.spin_moment += x * forces.lateral - y * forces.longitudinal;
  return forces;
}

/// On the Hertzian ellipse, with derivatives.
CreepForces solve_on_ellipse(const PatchResult& patch, const PatchMotion& motion,
                             const CreepRequest& request, const PatchRates* rates,
                             CreepResult& creep) {
  const EllipseInPlane ellipse = ellipse_of(patch.grid, patch.contact, patch.normal_force);
  CreepResult unused;
  if (request.derivatives) {
    creep.derivatives.emplace().by_creepage = difference_by_creepage(
        patch, request, motion, motion.creepages, [&](const Creepages& creepages) {
          PatchMotion moved = motion;
          moved.creepages = creepages;
          const CreepForces forces = forces_on_ellipse(ellipse, moved, request, unused);
          return std::array{forces.longitudinal, forces.lateral, forces.spin_moment};
        });
    if (rates != nullptr) {
      creep.derivatives->by_position = differences_of(
          moves_of(patch, *rates, creep_difference_step), [&](const MovedPatch& moved) {
            const Grid grid = moved_grid(patch.grid, moved.elements);
            const EllipseInPlane other =
                ellipse_of(grid, summarise_pressure(grid, moved.pressure), moved.normal_force);
            return forces_on_ellipse(other, motion, request, unused);
          });
    }
  }
  return forces_on_ellipse(ellipse, motion, request, creep);
}

/// `motion`: at the patch's origin.
CreepResult solve_patch(const PatchTask& task, RollingSolver& solver) {
  const auto& [wheel, patch, motion, request, rates] = task;
  CreepResult creep;
  creep.creepages = motion.frame.mirrored(motion.creepages);
  creep.friction = motion.friction;
  creep.slip_speed = motion.slip_speed;
  if (motion.twist) {
    creep.slip_variation = slip_variation(*patch.slip, *motion.twist, motion.creepages);
  }
  if (!(patch.normal_force > 0.0)) {
    return creep;
  }
  const LeastFriction least(motion, request.model);
  const PatchMotion& solved = least.motion();
  const PatchTask solved_task{wheel, patch, solved, request, rates};
  CreepForces forces = unlike_bodies(request) ? forces_of_unlike_bodies(solved_task, solver, creep)
                       : on_own_pressures(request)
                           ? forces_on_patch(solved_task, solver, creep)
                           : solve_on_ellipse(patch, solved, request, rates, creep);
  if (request.derivatives) {
    const bool by_friction = request.model != CreepModel::linear;
    complete(*creep.derivatives, forces, solved.creepages, by_friction ? solved.friction : 0.0,
             patch.normal_force);
  }
  least.take_back(forces, creep);
  if (request.derivatives) {
    creep.derivatives = motion.frame.mirrored(*creep.derivatives);
    if (rates != nullptr && patch.slip) {
      creep.derivatives->slip_by_position = slip_rates(wheel, patch, *rates, request.slip);
    }
  }
  const CreepForces in_track = motion.frame.mirrored(forces);
  creep.longitudinal_force = in_track.longitudinal;
  creep.lateral_force = in_track.lateral;
  creep.spin_moment = in_track.spin_moment;
  creep.power_per_speed +=
      creep.power_of_pressures -
      (creep.longitudinal_force * creep.creepages.longitudinal +
       creep.lateral_force * creep.creepages.lateral + creep.spin_moment * creep.creepages.spin);
  // In steady rolling friction takes power. What the iteration leaves may be more than little of
  // it, and Polach's law, which leaves out the moment of spin, gives some where spin opposes
  // creepage.
  if (!(motion.step_length > 0.0)) {
    creep.power_per_speed = std::max(creep.power_per_speed, 0.0);
  }
  creep.friction_power = motion.slip_speed * creep.power_per_speed;
  if (patch.is_unbounded) {
    creep.largest_traction = std::numeric_limits<double>::quiet_NaN();
  }
  return creep;
}

/// Parts of one plane together, about its origin.
void add_part(CreepResult& whole, const CreepResult& part, double weight, double longitudinal,
              double lateral) {
  if (part.derivatives) {
    add_derivatives(whole.derivatives ? *whole.derivatives : whole.derivatives.emplace(),
                    *part.derivatives, weight, longitudinal, lateral);
  }
  whole.longitudinal_force += part.longitudinal_force;
  whole.lateral_force += part.lateral_force;
  whole.spin_moment +=
      part.spin_moment + longitudinal * part.lateral_force - lateral * part.longitudinal_force;
  whole.friction += weight * part.friction;
  whole.slip_area += part.slip_area;
  whole.adhesion_area += part.adhesion_area;
  whole.largest_traction = std::max(whole.largest_traction, part.largest_traction);
  // The loss is a fraction of the power: here the lost power, at the end over the whole.
  whole.numerical_loss += part.numerical_loss * part.power_per_speed;
  whole.power_of_pressures += part.power_of_pressures;
  whole.power_per_speed += part.power_per_speed;
  whole.friction_power += part.friction_power;
  if (part.error_estimate) {
    whole.error_estimate = whole.error_estimate.value_or(0.0) + weight * *part.error_estimate;
  }
  whole.residual = std::max(whole.residual, part.residual);
  whole.convolutions += part.convolutions;
  whole.elements_wanted += part.elements_wanted;
}

} // namespace

void solve_creep_forces(WheelResult& wheel, const CreepRequest& of_scene, RollingSolver& solver,
                        const WheelRates* rates) {
  CreepRequest request = with_elements(of_scene, wheel);
  wheel.details.friction = request.friction;
  if (request.motion) {
    wheel.details.motion = wheelset_motion(wheel, request);
  }
  find_slip_geometry(wheel, request);
  const PatchRates* of_patch = rates != nullptr ? rates->patches.data() : nullptr;
  for (PatchResult& patch : wheel.patches) {
    std::vector<CreepResult> parts;
    patch.creep = creep_of_patch(wheel, patch, request, solver, parts, of_patch);
    if (of_patch != nullptr) {
      of_patch += std::max<std::size_t>(parts.size(), 1);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      patch.parts[i].creep = std::move(parts[i]);
    }
  }
}

CreepResult creep_of_patch(const WheelResult& wheel, const PatchResult& patch,
                           const CreepRequest& asked, RollingSolver& solver,
                           std::vector<CreepResult>& parts, const PatchRates* rates) {
  const CreepRequest request = asked.element_share ? asked : with_elements(asked, wheel);
  const PatchMotion motion = motion_of(patch, patch, wheel, request);
  if (patch.parts.empty()) {
    return solve_patch({wheel, patch, motion, request, rates}, solver);
  }
  CreepResult whole;
  whole.creepages = motion.frame.mirrored(motion.creepages);
  whole.slip_speed = motion.slip_speed;
  if (motion.twist) {
    whole.slip_variation = slip_variation(*patch.slip, *motion.twist, motion.creepages);
  }
  Creepages mean{};
  for (const PatchResult& part : patch.parts) {
    const Vector3 apart = part.frame.origin - patch.frame.origin;
    const CreepResult& creep =
        parts.emplace_back(solve_patch({wheel, part, motion_of(part, patch, wheel, request),
                                        request, rates != nullptr ? rates++ : nullptr},
                                       solver));
    const double weight = part.normal_force / patch.normal_force;
    const double along = dot(apart, patch.frame.longitudinal);
    const double across = motion.frame.mirrored_lateral(patch.frame.lateral_of(apart));
    add_part(whole, creep, weight, along, across);
    const Creepages at_whole = creepages_at(creep.creepages, -along, -across);
    mean.longitudinal += weight * at_whole.longitudinal;
    mean.lateral += weight * at_whole.lateral;
    mean.spin += weight * at_whole.spin;
  }
  // Parts roll on radii of their own, the reference between them on none. (Slip by element has been
  // fitted over all of them.)
  if (request.motion && !motion.twist) {
    whole.creepages = mean;
  }
  if (whole.power_per_speed > 0.0) {
    whole.numerical_loss /= whole.power_per_speed;
  }
  if (patch.is_unbounded) {
    whole.largest_traction = std::numeric_limits<double>::quiet_NaN();
  }
  return whole;
}

} // namespace wrc
