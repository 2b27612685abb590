#include "wheel/creep_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "mechanics/cascade.hpp"
#include "pressure/smooth_pressure.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/unlike_bodies.hpp"
#include "wheel/constants.hpp"
#include "wheel/wheel_result.hpp"

namespace wrc {
namespace {

/// The grid over the rectangle around the contact.
Grid grid_around_contact(const Grid& grid, const SmoothPressure& pressure, double accuracy,
                         int lobes) {
  const auto along = pressure.longitudinal_extent();
  const auto across = pressure.lateral_extent();
  if (!along || !across) {
    return grid;
  }
  const double columns =
      std::clamp(std::pow(share_of_creep_columns * accuracy / creep_error_of_one_column,
                          -1.0 / creep_error_order),
                 min_creep_columns, max_creep_columns);
  const double rows = creep_rows_by_columns * columns * static_cast<double>(lobes);
  const auto even = [](double count) {
    return 2 * static_cast<std::size_t>(std::ceil(0.5 * count));
  };
  Grid result;
  result.longitudinal_count = even(columns);
  result.lateral_count = even(std::min(rows, 2.0 * max_creep_columns));
  const auto divide = [](const auto& extent, std::size_t count, double& first, double& step) {
    step = (extent.last - extent.first) / static_cast<double>(count);
    first = extent.first + 0.5 * step;
  };
  divide(*along, result.longitudinal_count, result.longitudinal_first, result.longitudinal_step);
  divide(*across, result.lateral_count, result.lateral_first, result.lateral_step);
  return result;
}

/// A grid with as many elements more on each side as reach the outer grid's edges, half its own at
/// most: where contact of unlike bodies may move to.
Grid extended_to(const Grid& inner, const Grid& outer) {
  Grid result = inner;
  const auto extend = [](double& first, std::size_t& count, double step, double outer_first,
                         double outer_last) {
    const double last = first + static_cast<double>(count - 1) * step;
    const auto elements = [&](double room) {
      return std::min(static_cast<std::size_t>(std::ceil(std::max(room, 0.0) / step)), count / 2);
    };
    const std::size_t before = elements(first - outer_first);
    count += before + elements(outer_last - last);
    first -= static_cast<double>(before) * step;
  };
  extend(result.longitudinal_first, result.longitudinal_count, inner.longitudinal_step,
         outer.longitudinal_first, outer.longitudinal(outer.longitudinal_count - 1));
  extend(result.lateral_first, result.lateral_count, inner.lateral_step, outer.lateral_first,
         outer.lateral(outer.lateral_count - 1));
  return result;
}

/// Creepages at a place of a patch's plane from those at its reference.
Creepages creepages_at(const Creepages& reference, double longitudinal, double lateral) {
  return {reference.longitudinal - reference.spin * lateral,
          reference.lateral + reference.spin * longitudinal, reference.spin};
}

Creepages mirrored(const Creepages& creepages, double mirror) {
  return {creepages.longitudinal, mirror * creepages.lateral, mirror * creepages.spin};
}

/// How a patch moves, left-hand frame of the side.
struct PatchMotion {
  Creepages creepages;
  bool backwards = false;
  double slip_speed = 0.0; ///< of a creepage of 1, mm/s
};

/// Rolling backwards is rolling forwards seen from the other side: turned by half a turn about the
/// normal.
Grid turned(Grid grid) {
  grid.longitudinal_first = -grid.longitudinal(grid.longitudinal_count - 1);
  grid.lateral_first = -grid.lateral(grid.lateral_count - 1);
  return grid;
}

std::vector<double> turned(std::vector<double> values, double factor) {
  std::reverse(values.begin(), values.end());
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

Creepages turned(const Creepages& creepages) {
  return {-creepages.longitudinal, -creepages.lateral, creepages.spin};
}

/// Forces on the Hertzian ellipse with the patch's second moments, about the patch's origin.
CreepForces forces_on_ellipse(const PatchResult& patch, const PatchMotion& motion,
                              const CreepRequest& request, CreepResult& creep) {
  // Contact on a single line of elements has no second moment across it.
  const RollingEllipse ellipse{
      std::max(patch.semi_axis_longitudinal, 0.5 * patch.grid.longitudinal_step),
      std::max(patch.semi_axis_lateral, 0.5 * patch.grid.lateral_step),
      patch.normal_force,
      request.friction,
      request.material.modulus,
      request.material.poisson};
  const double x = patch.contact.centroid_longitudinal;
  const double y = patch.contact.centroid_lateral;
  const Creepages forwards = creepages_at(motion.creepages, x, y);
  const Creepages centre = motion.backwards ? turned(forwards) : forwards;
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
  if (motion.backwards) {
    forces.longitudinal = -forces.longitudinal;
    forces.lateral = -forces.lateral;
  }
  forces.spin_moment += x * forces.lateral - y * forces.longitudinal;
  return forces;
}

/// On the patch's own pressures.
CreepForces forces_on_patch(const PatchResult& patch, const PatchMotion& motion,
                            const CreepRequest& request, RollingSolver& solver,
                            CreepResult& creep) {
  const SmoothPressure pressure(patch.grid, patch.pressure);
  creep.grid = grid_around_contact(patch.grid, pressure, request.accuracy, patch.lobes);
  const bool unlike =
      request.model == CreepModel::full && request.material.difference_parameter != 0.0;
  if (unlike) {
    creep.grid = extended_to(creep.grid, patch.grid);
  }
  pressure.fill(creep.grid, creep.pressure);
  const double force = std::accumulate(creep.pressure.begin(), creep.pressure.end(), 0.0) *
                       creep.grid.element_area();
  for (double& p : creep.pressure) {
    p *= force > 0.0 ? patch.normal_force / force : 0.0;
  }
  const double sign = motion.backwards ? -1.0 : 1.0;
  RollingProblem problem;
  problem.grid = motion.backwards ? turned(creep.grid) : creep.grid;
  if (motion.backwards) {
    creep.pressure = turned(std::move(creep.pressure), 1.0);
  }
  problem.pressure = creep.pressure;
  problem.friction = request.friction;
  problem.shear_modulus = request.material.modulus;
  problem.poisson = request.material.poisson;
  problem.creepages = motion.backwards ? turned(motion.creepages) : motion.creepages;
  problem.tolerance = creep_iteration_share * request.accuracy;
  RollingSolution solution;
  if (unlike) {
    problem.difference_parameter = request.material.difference_parameter;
    std::vector<double> distance;
    interpolate(patch.grid, patch.undeformed_distance, creep.grid, distance);
    if (motion.backwards) {
      distance = turned(std::move(distance), 1.0);
    }
    UnlikeSolution both = solve_unlike(problem, distance, request.combined_modulus,
                                       creep_iteration_share * request.accuracy, solver);
    creep.pressure_change = both.pressure_change;
    creep.pressure = std::move(both.pressure);
    solution = std::move(both.rolling);
  } else if (request.model == CreepModel::full) {
    solution = solver.solve(problem);
  } else {
    solution = solve_with_fastsim(problem, flexibilities_of(problem, solver));
  }
  creep.slip_area = solution.slip_area;
  creep.adhesion_area = solution.adhesion_area;
  for (std::size_t i = 0; i < solution.traction_x.size(); ++i) {
    creep.largest_traction = std::max(creep.largest_traction,
                                      std::hypot(solution.traction_x[i], solution.traction_y[i]));
  }
  creep.numerical_loss = solution.numerical_loss;
  creep.residual = solution.residual;
  creep.convolutions = solution.convolutions;
  if (request.model == CreepModel::full) {
    creep.error_estimate =
        creep_error_of_one_column *
            std::pow(static_cast<double>(creep.grid.longitudinal_count), -creep_error_order) +
        share_of_creep_pressures * request.accuracy + creep_error_by_residual * solution.residual;
  }
  if (motion.backwards) {
    creep.pressure = turned(std::move(creep.pressure), 1.0);
    for (auto* field :
         {&solution.traction_x, &solution.traction_y, &solution.slip_x, &solution.slip_y}) {
      *field = turned(std::move(*field), -1.0);
    }
  }
  creep.traction_x = std::move(solution.traction_x);
  creep.traction_y = std::move(solution.traction_y);
  creep.slip_x = std::move(solution.slip_x);
  creep.slip_y = std::move(solution.slip_y);
  return {sign * solution.longitudinal_force, sign * solution.lateral_force, solution.spin_moment};
}

/// `motion`: at the patch's origin.
CreepResult solve_patch(const PatchResult& patch, const PatchMotion& motion,
                        const CreepRequest& request, double mirror, RollingSolver& solver) {
  CreepResult creep;
  creep.creepages = mirrored(motion.creepages, mirror);
  if (!(patch.normal_force > 0.0)) {
    return creep;
  }
  const bool on_patch =
      request.model == CreepModel::full || request.model == CreepModel::fastsim_strips;
  const CreepForces forces = on_patch ? forces_on_patch(patch, motion, request, solver, creep)
                                      : forces_on_ellipse(patch, motion, request, creep);
  creep.longitudinal_force = forces.longitudinal;
  creep.lateral_force = mirror * forces.lateral;
  creep.spin_moment = mirror * forces.spin_moment;
  creep.power_per_speed =
      -(creep.longitudinal_force * creep.creepages.longitudinal +
        creep.lateral_force * creep.creepages.lateral + creep.spin_moment * creep.creepages.spin);
  creep.friction_power = motion.slip_speed * creep.power_per_speed;
  return creep;
}

/// From the wheelset's motion, or as given at the reference of `whole`.
PatchMotion motion_of(const PatchResult& patch, const PatchResult& whole, const WheelResult& wheel,
                      const CreepRequest& request) {
  const double mirror = wheel.details.mirror;
  if (request.motion) {
    const Motion motion = mirror > 0.0 ? *request.motion : mirrored(*request.motion);
    const RigidSlip slip = rigid_slip(motion, wheel.details.pose, wheel.vertical - wheel.depth,
                                      request.nominal_radius, patch.frame, patch.approach);
    return {slip.creepages, slip.reference_speed < 0.0, slip.slip_speed};
  }
  const Vector3 apart = patch.frame.origin - whole.frame.origin;
  return {creepages_at(mirrored(request.creepages, mirror), dot(apart, whole.frame.longitudinal),
                       dot(apart, whole.frame.lateral)),
          false, request.speed};
}

/// Parts of one plane together, about its origin.
void add_part(CreepResult& whole, const CreepResult& part, double weight, double longitudinal,
              double lateral) {
  whole.longitudinal_force += part.longitudinal_force;
  whole.lateral_force += part.lateral_force;
  whole.spin_moment +=
      part.spin_moment + longitudinal * part.lateral_force - lateral * part.longitudinal_force;
  whole.slip_area += part.slip_area;
  whole.adhesion_area += part.adhesion_area;
  whole.largest_traction = std::max(whole.largest_traction, part.largest_traction);
  // The loss is a share of the power: first what is lost, at the end over the whole.
  whole.numerical_loss += part.numerical_loss * part.power_per_speed;
  whole.power_per_speed += part.power_per_speed;
  whole.friction_power += part.friction_power;
  if (part.error_estimate) {
    whole.error_estimate = whole.error_estimate.value_or(0.0) + weight * *part.error_estimate;
  }
  whole.residual = std::max(whole.residual, part.residual);
  whole.convolutions += part.convolutions;
}

void warn_of_unlike_bodies(WheelResult& wheel, const CreepRequest& request) {
  if (request.material.difference_parameter == 0.0 || wheel.patches.empty()) {
    return;
  }
  if (request.model != CreepModel::full) {
    wheel.warnings.emplace_back("creep forces of unlike materials: this model leaves out what "
                                "pressures and tractions change in each other, the full one knows "
                                "it");
    return;
  }
  double change = 0.0;
  for (const PatchResult* patch : solved_patches(wheel)) {
    change = std::max(change, patch->creep->pressure_change);
  }
  if (change > request.accuracy) {
    wheel.warnings.push_back("creep forces of unlike materials: tractions change pressures by " +
                             short_text_of(change) +
                             " in the mean, which results of normal contact leave out");
  }
}

} // namespace

void solve_creep_forces(WheelResult& wheel, const CreepRequest& request, RollingSolver& solver) {
  const double mirror = wheel.details.mirror;
  for (PatchResult& patch : wheel.patches) {
    const PatchMotion motion = motion_of(patch, patch, wheel, request);
    if (patch.parts.empty()) {
      patch.creep = solve_patch(patch, motion, request, mirror, solver);
    } else {
      CreepResult& whole = patch.creep.emplace();
      whole.creepages = mirrored(motion.creepages, mirror);
      for (PatchResult& part : patch.parts) {
        const Vector3 apart = part.frame.origin - patch.frame.origin;
        part.creep =
            solve_patch(part, motion_of(part, patch, wheel, request), request, mirror, solver);
        add_part(whole, *part.creep, part.normal_force / patch.normal_force,
                 dot(apart, patch.frame.longitudinal), mirror * dot(apart, patch.frame.lateral));
      }
      if (whole.power_per_speed > 0.0) {
        whole.numerical_loss /= whole.power_per_speed;
      }
    }
    if (patch.creep->error_estimate.value_or(0.0) > request.accuracy) {
      wheel.warnings.push_back("creep forces: accuracy " + text_of(request.accuracy) +
                               " not reached: estimated error " +
                               short_text_of(*patch.creep->error_estimate));
    }
  }
  warn_of_unlike_bodies(wheel, request);
}

} // namespace wrc
