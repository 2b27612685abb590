#include "wheel/creep_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "mechanics/cascade.hpp"
#include "pressure/smooth_pressure.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/unlike_bodies.hpp"
#include "wheel/constants.hpp"
#include "wheel/creep_elements.hpp"
#include "wheel/creep_grid.hpp"
#include "wheel/creep_rates.hpp"
#include "wheel/patch_motion.hpp"
#include "wheel/wheel_result.hpp"
#include "wheel/wheel_sensitivities.hpp"

namespace wrc {
namespace {

/// Creepages at a place of a patch's plane from those at its reference.
Creepages creepages_at(const Creepages& reference, double longitudinal, double lateral) {
  return {reference.longitudinal - reference.spin * lateral,
          reference.lateral + reference.spin * longitudinal, reference.spin};
}

Creepages mirrored(const Creepages& creepages, double mirror) {
  return {creepages.longitudinal, mirror * creepages.lateral, mirror * creepages.spin};
}

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

/// Derivatives by creepages of the cheaper models: central differences over a small share of the
/// creepage at which a sphere's contact of this size slides.
template <class Forces>
std::array<double, 9> difference_by_creepage(const PatchResult& patch, const CreepRequest& request,
                                             const PatchMotion& motion, Creepages at,
                                             const Forces& forces) {
  const double size =
      std::max(patch.semi_axis_longitudinal * patch.semi_axis_lateral, patch.grid.element_area());
  // The linear law knows no friction, and has the same derivatives by any steps.
  const double friction = request.model == CreepModel::linear
                              ? std::max(motion.friction, least_linear_friction)
                              : motion.friction;
  const double translation =
      creep_difference_step * friction * patch.normal_force / (request.material.modulus * size);
  const std::array<Creepages, 3> steps{Creepages{translation, 0.0, 0.0},
                                       {0.0, translation, 0.0},
                                       {0.0, 0.0, translation / std::sqrt(size)}};
  const std::array<double, 3> lengths{translation, translation, translation / std::sqrt(size)};
  std::array<double, 9> derivatives{};
  for (std::size_t i = 0; i < steps.size() && translation > 0.0; ++i) {
    const Creepages& step = steps[i];
    const CreepForces ahead = forces(
        {at.longitudinal + step.longitudinal, at.lateral + step.lateral, at.spin + step.spin});
    const CreepForces behind = forces(
        {at.longitudinal - step.longitudinal, at.lateral - step.lateral, at.spin - step.spin});
    const double scale = 0.5 / lengths[i];
    derivatives[i] = scale * (ahead.longitudinal - behind.longitudinal);
    derivatives[3 + i] = scale * (ahead.lateral - behind.lateral);
    derivatives[6 + i] = scale * (ahead.spin_moment - behind.spin_moment);
  }
  return derivatives;
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
          return forces_on_ellipse(ellipse, moved, request, unused);
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

/// Pressures on a grid, of this force together: at the centres of elements, or, where the shares in
/// contact are asked for, their means.
std::vector<double> pressures_on(const Grid& grid, const SmoothPressure& pressure,
                                 double normal_force, std::vector<double>* covered) {
  std::vector<double> result;
  if (covered != nullptr) {
    pressure.fill_means(grid, result, *covered);
  } else {
    pressure.fill(grid, result);
  }
  const double force = std::accumulate(result.begin(), result.end(), 0.0) * grid.element_area();
  for (double& p : result) {
    p *= force > 0.0 ? normal_force / force : 0.0;
  }
  return result;
}

/// FASTSIM strip by strip; its derivatives are differences.
RollingSolution solve_by_strips(const PatchResult& patch, const PatchMotion& motion,
                                const CreepRequest& request, RollingProblem problem,
                                RollingSolver& solver) {
  const Flexibilities flexibilities = flexibilities_of(problem, solver);
  RollingSolution solution = solve_with_fastsim(problem, flexibilities);
  if (request.derivatives) {
    solution.by_creepage = difference_by_creepage(
        patch, request, motion, problem.creepages, [&](const Creepages& creepages) -> CreepForces {
          RollingProblem other = problem;
          other.creepages = creepages;
          const RollingSolution found = solve_with_fastsim(other, flexibilities);
          return {found.longitudinal_force, found.lateral_force, found.spin_moment};
        });
    for (const ProblemRate& rate : problem.rates) {
      solution.by_rate.push_back(difference_by_strips(problem, flexibilities, rate));
    }
  }
  return solution;
}

/// Of unlike bodies, whose tractions change the pressures.
RollingSolution solve_both_ways(const PatchResult& patch, const PatchMotion& motion,
                                const CreepRequest& request, RollingProblem problem,
                                RollingSolver& solver, CreepResult& creep) {
  problem.difference_parameter = request.material.difference_parameter;
  std::vector<double> distance;
  interpolate(patch.grid, patch.undeformed_distance, creep.grid, distance);
  if (motion.backwards) {
    distance = turned(std::move(distance), 1.0);
  }
  UnlikeSolution both =
      solve_unlike(problem, distance, request.combined_modulus, problem.tolerance, solver);
  creep.pressure_change = both.pressure_change;
  creep.pressure = std::move(both.pressure);
  return std::move(both.rolling);
}

/// Of what is solved for by position; `now`: as it rolls forwards, on `grid` of the patch's plane.
std::vector<ProblemRate> problem_rates(const PatchResult& patch, const PatchRates& rates,
                                       const Grid& grid, const RollingProblem& now,
                                       bool backwards) {
  std::vector<ProblemRate> result;
  for (const PatchMove& move : moves_of(patch, rates, creep_pressure_step)) {
    const MovedPatch& moved = move.ahead;
    const SmoothPressure smooth(moved_grid(patch.grid, moved.elements), moved.pressure);
    Grid ahead = moved_around_contact(grid, smooth);
    std::vector<double> covered;
    std::vector<double> pressure =
        pressures_on(ahead, smooth, moved.normal_force, now.covered.empty() ? nullptr : &covered);
    if (backwards) {
      ahead = turned(ahead);
      pressure = turned(std::move(pressure), 1.0);
      std::reverse(covered.begin(), covered.end());
    }
    result.push_back(rate_between(now, ahead, pressure, covered, 0.5 * move.apart));
  }
  return result;
}

/// Of a solution that was turned by half a turn if `sign` is -1.
void take_derivatives(const RollingSolution& solution, double sign, CreepDerivatives& derivatives) {
  derivatives.by_creepage = solution.by_creepage;
  for (const std::size_t turning : {2U, 5U, 6U, 7U}) { // forces by spin, moments by creepages
    derivatives.by_creepage[turning] *= sign;
  }
  if (!solution.by_rate.empty()) {
    auto& by = derivatives.by_position.emplace();
    for (std::size_t i = 0; i < position_count; ++i) {
      by[i] = sign * solution.by_rate[i][0];
      by[position_count + i] = sign * solution.by_rate[i][1];
      by[2 * position_count + i] = solution.by_rate[i][2];
    }
  }
}

/// On the patch's own pressures.
CreepForces forces_on_patch(const PatchResult& patch, const PatchMotion& motion,
                            const CreepRequest& request, const PatchRates* rates,
                            RollingSolver& solver, CreepResult& creep) {
  const SmoothPressure pressure(patch.grid, patch.pressure);
  const bool unlike = unlike_bodies(request);
  const bool by_means = request.model == CreepModel::full;
  const CreepGrid chosen = grid_of_patch(patch, pressure, request);
  const double columns = chosen.columns;
  creep.grid = chosen.grid;
  creep.elements_wanted = chosen.wanted;
  std::vector<double> covered;
  creep.pressure =
      pressures_on(creep.grid, pressure, patch.normal_force, by_means ? &covered : nullptr);
  const double sign = motion.backwards ? -1.0 : 1.0;
  RollingProblem problem;
  problem.grid = motion.backwards ? turned(creep.grid) : creep.grid;
  if (motion.backwards) {
    creep.pressure = turned(std::move(creep.pressure), 1.0);
    std::reverse(covered.begin(), covered.end());
  }
  problem.pressure = creep.pressure;
  problem.covered = covered;
  problem.friction = motion.friction;
  problem.shear_modulus = request.material.modulus;
  problem.poisson = request.material.poisson;
  problem.creepages = motion.backwards ? turned(motion.creepages) : motion.creepages;
  const double of_elements = creep_error_of_one_column / (columns * columns);
  // An iteration beyond what fewer elements than the accuracy needs can show would be in vain.
  problem.tolerance =
      creep_iteration_share *
      (chosen.limited ? std::max(request.accuracy, std::min(of_elements, coarsest_accuracy))
                      : request.accuracy);
  problem.derivatives = request.derivatives;
  std::vector<ProblemRate> by_position;
  if (rates != nullptr && !unlike) {
    by_position = problem_rates(patch, *rates, creep.grid, problem, motion.backwards);
    problem.rates = by_position;
  }
  RollingSolution solution;
  if (unlike) {
    solution = solve_both_ways(patch, motion, request, problem, solver, creep);
  } else if (request.model == CreepModel::full) {
    solution = solver.solve(problem);
  } else {
    solution = solve_by_strips(patch, motion, request, problem, solver);
  }
  if (request.derivatives) {
    take_derivatives(solution, sign, creep.derivatives.emplace());
  }
  creep.slip_area = solution.slip_area;
  creep.adhesion_area = solution.adhesion_area;
  for (std::size_t i = 0; i < solution.traction_x.size(); ++i) {
    creep.largest_traction = std::max(creep.largest_traction,
                                      std::hypot(solution.traction_x[i], solution.traction_y[i]));
  }
  creep.numerical_loss = solution.numerical_loss;
  creep.power_of_pressures = solution.power_of_pressures;
  creep.residual = solution.residual;
  creep.convolutions = solution.convolutions;
  if (request.model == CreepModel::full) {
    creep.error_estimate = of_elements + creep_error_by_residual * solution.residual;
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
                        const CreepRequest& request, double mirror, const PatchRates* rates,
                        RollingSolver& solver) {
  CreepResult creep;
  creep.creepages = mirrored(motion.creepages, mirror);
  creep.friction = motion.friction;
  creep.slip_speed = motion.slip_speed;
  if (!(patch.normal_force > 0.0)) {
    return creep;
  }
  const LeastFriction least(motion, request.model);
  const PatchMotion& solved = least.motion();
  CreepForces forces = on_own_pressures(request)
                           ? forces_on_patch(patch, solved, request, rates, solver, creep)
                           : solve_on_ellipse(patch, solved, request, rates, creep);
  if (request.derivatives) {
    const bool by_friction = request.model != CreepModel::linear;
    complete(*creep.derivatives, forces, solved.creepages, by_friction ? solved.friction : 0.0,
             patch.normal_force);
  }
  least.take_back(forces, creep);
  if (request.derivatives) {
    mirror_derivatives(*creep.derivatives, mirror);
  }
  creep.longitudinal_force = forces.longitudinal;
  creep.lateral_force = mirror * forces.lateral;
  creep.spin_moment = mirror * forces.spin_moment;
  creep.power_per_speed =
      creep.power_of_pressures -
      (creep.longitudinal_force * creep.creepages.longitudinal +
       creep.lateral_force * creep.creepages.lateral + creep.spin_moment * creep.creepages.spin);
  if (creep.power_of_pressures != 0.0) { // what the iteration leaves may be more than little power
    creep.power_per_speed = std::max(creep.power_per_speed, 0.0);
  }
  creep.friction_power = motion.slip_speed * creep.power_per_speed;
  return creep;
}

/// That of the request in the left-hand frame of the side.
WheelsetMotion wheelset_motion(const WheelResult& wheel, const CreepRequest& request) {
  const bool left = wheel.details.mirror > 0.0;
  const RailSurface& rail = *wheel.details.rail;
  return {left ? *request.motion : mirrored(*request.motion),
          wheel.details.pose,
          wheel.vertical - wheel.depth,
          request.nominal_radius,
          left ? request.rail_velocity : mirrored(request.rail_velocity),
          rail.origin_y(),
          rail.origin_z()};
}

/// From the wheelset's motion, or as given at the reference of `whole`.
PatchMotion motion_of(const PatchResult& patch, const PatchResult& whole, const WheelResult& wheel,
                      const CreepRequest& request) {
  PatchMotion motion;
  if (request.motion) {
    const RigidSlip slip = rigid_slip(*wheel.details.motion, patch.frame, patch.approach);
    motion = {slip.creepages, slip.reference_speed < 0.0, slip.slip_speed};
  } else {
    const Vector3 apart = patch.frame.origin - whole.frame.origin;
    motion = {creepages_at(mirrored(request.creepages, wheel.details.mirror),
                           dot(apart, whole.frame.longitudinal), dot(apart, whole.frame.lateral)),
              false, request.speed};
  }
  motion.friction = friction_of(
      request.friction, patch.reference.s_wheel,
      motion.slip_speed * std::hypot(motion.creepages.longitudinal, motion.creepages.lateral));
  return motion;
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
  // The loss is a share of the power: first what is lost, at the end over the whole.
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

void solve_creep_forces(WheelResult& wheel, const CreepRequest& of_scene, RollingSolver& solver) {
  CreepRequest request = of_scene;
  request.element_share = share_of_elements(wheel, request);
  wheel.details.friction = request.friction;
  if (request.motion) {
    wheel.details.motion = wheelset_motion(wheel, request);
  }
  const WheelRates* rates = request.derivatives ? sensitivities_of(wheel) : nullptr;
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
  CreepRequest request = asked;
  if (!request.element_share) {
    request.element_share = share_of_elements(wheel, request);
  }
  const double mirror = wheel.details.mirror;
  const PatchMotion motion = motion_of(patch, patch, wheel, request);
  if (patch.parts.empty()) {
    return solve_patch(patch, motion, request, mirror, rates, solver);
  }
  CreepResult whole;
  whole.creepages = mirrored(motion.creepages, mirror);
  whole.slip_speed = motion.slip_speed;
  Creepages mean{};
  for (const PatchResult& part : patch.parts) {
    const Vector3 apart = part.frame.origin - patch.frame.origin;
    const CreepResult& creep =
        parts.emplace_back(solve_patch(part, motion_of(part, patch, wheel, request), request,
                                       mirror, rates != nullptr ? rates++ : nullptr, solver));
    const double weight = part.normal_force / patch.normal_force;
    const double along = dot(apart, patch.frame.longitudinal);
    const double across = mirror * dot(apart, patch.frame.lateral);
    add_part(whole, creep, weight, along, across);
    const Creepages at_whole = creepages_at(creep.creepages, -along, -across);
    mean.longitudinal += weight * at_whole.longitudinal;
    mean.lateral += weight * at_whole.lateral;
    mean.spin += weight * at_whole.spin;
  }
  // Parts roll on radii of their own, the reference between them on none.
  if (request.motion) {
    whole.creepages = mean;
  }
  if (whole.power_per_speed > 0.0) {
    whole.numerical_loss /= whole.power_per_speed;
  }
  return whole;
}

} // namespace wrc
