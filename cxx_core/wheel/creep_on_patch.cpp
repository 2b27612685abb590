#include "wheel/creep_on_patch.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "accuracy/constants.hpp"
#include "mechanics/cascade.hpp"
#include "pressure/smooth_pressure.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/unlike_bodies.hpp"
#include "wheel/constants.hpp"
#include "wheel/creep_elements.hpp"
#include "wheel/creep_rates.hpp"
#include "wheel/wheel_sensitivities.hpp"

namespace wrc {
namespace {

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
  distance = motion.frame.turned_numbers(std::move(distance));
  UnlikeSolution both =
      solve_unlike(problem, distance, request.combined_modulus, problem.tolerance, solver);
  creep.pressure_change = both.pressure_change;
  creep.pressure = motion.frame.turned_numbers(std::move(both.pressure));
  return std::move(both.rolling);
}

/// What is solved for, in the plane of the patch.
struct PatchFields {
  Grid grid;
  ProblemFields fields;
};

PatchFields turned(PatchFields patch, const RollingFrame& frame) {
  ProblemFields& fields = patch.fields;
  return {frame.turned(patch.grid),
          {frame.turned_numbers(std::move(fields.pressure)),
           frame.turned_numbers(std::move(fields.covered)), frame.turned(std::move(fields.slip)),
           frame.turned(std::move(fields.weights))}};
}

/// By position; `now`: in the rolling frame, on `grid` of the patch's plane.
std::vector<ProblemRate> problem_rates(const PatchTask& task, const Grid& grid,
                                       const RollingProblem& now) {
  std::vector<ProblemRate> result;
  const PatchResult& patch = task.patch;
  const auto moves = moves_of(patch, *task.rates, creep_pressure_step);
  for (std::size_t position = 0; position < position_count; ++position) {
    const MovedPatch& moved = moves[position].ahead;
    const double step = 0.5 * moves[position].apart;
    const Grid around = moved_grid(patch.grid, moved.elements);
    const SmoothPressure smooth(around, moved.pressure);
    PatchFields ahead{moved_around_contact(grid, smooth), {}};
    ahead.fields.pressure = pressures_on(ahead.grid, smooth, moved.normal_force,
                                         now.covered.empty() ? nullptr : &ahead.fields.covered);
    if (task.motion.twist) {
      const MovedContact contact(task.wheel, patch, *task.rates, position, step);
      const SlipGeometry geometry = contact.geometry(around, moved.pressure, task.request.slip);
      const std::vector<SlipRow> rows = contact.rows(ahead.grid, task.request.slip);
      ahead.fields.slip = slip_beyond(geometry, rows, ahead.grid, contact.twist());
      ahead.fields.weights = slip_beyond(geometry, rows, ahead.grid, along_the_normal);
    }
    ahead = turned(std::move(ahead), task.motion.frame);
    result.push_back(rate_between(now, ahead.grid, ahead.fields, step));
  }
  return result;
}

/// By slips of elements alone.
ProblemRate rate_by(const RollingProblem& problem, std::span<const double> slip_x,
                    std::span<const double> slip_y) {
  ProblemRate rate;
  rate.pressure.resize(problem.pressure.size());
  rate.slip_x.assign(slip_x.begin(), slip_x.end());
  rate.slip_y.assign(slip_y.begin(), slip_y.end());
  return rate;
}

void take_derivatives(const RollingSolution& solution, CreepDerivatives& derivatives) {
  derivatives.by_creepage = solution.by_creepage;
  derivatives.normal_by_creepage = solution.weighted_by_creepage;
  std::size_t next = 0;
  if (solution.by_rate.size() >= position_count) {
    auto& by = derivatives.by_position.emplace();
    for (; next < position_count; ++next) {
      const std::array<double, 4>& rate = solution.by_rate[next];
      by[next] = rate[0];
      by[position_count + next] = rate[1];
      by[2 * position_count + next] = rate[2];
      derivatives.normal_by_position[next] = rate[3];
    }
  }
  if (solution.by_rate.size() > next) {
    derivatives.by_slip = solution.by_rate[next];
    derivatives.by_normal_velocity = solution.by_rate[next + 1];
  }
}

void take_facts(const RollingSolution& solution, CreepResult& creep) {
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
}

/// Power and forces of the slip beyond creepages, in the plane of the patch.
void take_in_slip(const PatchTask& task, const std::vector<SlipRow>& rows, const SlipField& slip,
                  const RollingSolution& solution, CreepResult& creep) {
  for (std::size_t i = 0; i < slip.x.size(); ++i) {
    creep.power_per_speed -= creep.grid.element_area() * (solution.traction_x[i] * slip.x[i] +
                                                          solution.traction_y[i] * slip.y[i]);
  }
  creep.beyond_creepages =
      wrench_beyond(*task.patch.slip, rows, creep.grid, solution.traction_x, solution.traction_y);
}

/// The rates that derivatives need: by positions where they are known, by the slip beyond creepages
/// and by a velocity along the normal.
std::vector<ProblemRate> all_rates(const PatchTask& task, const Grid& grid,
                                   const RollingProblem& problem) {
  std::vector<ProblemRate> rates;
  if (task.rates != nullptr) {
    rates = problem_rates(task, grid, problem);
  }
  if (task.motion.twist) {
    rates.push_back(rate_by(problem, problem.slip_x, problem.slip_y));
    rates.push_back(rate_by(problem, problem.weight_x, problem.weight_y));
  }
  return rates;
}

} // namespace

CreepForces forces_on_patch(const PatchTask& task, RollingSolver& solver, CreepResult& creep) {
  const auto& [wheel, patch, motion, request, known] = task;
  const SmoothPressure pressure(patch.grid, patch.pressure);
  const bool unlike = unlike_bodies(request);
  const bool by_means = request.model == CreepModel::full;
  const CreepGrid chosen = grid_of_patch(patch, pressure, request);
  creep.grid = chosen.grid;
  creep.elements_wanted = chosen.wanted;
  PatchFields now{creep.grid, {}};
  now.fields.pressure = pressures_on(creep.grid, pressure, patch.normal_force,
                                     by_means ? &now.fields.covered : nullptr);
  std::vector<SlipRow> rows;
  SlipField slip;
  if (motion.twist) {
    rows = rows_on(wheel, patch, creep.grid, request.slip);
    now.fields.slip = slip = slip_beyond(*patch.slip, rows, creep.grid, *motion.twist);
    if (request.derivatives) {
      now.fields.weights = slip_beyond(*patch.slip, rows, creep.grid, along_the_normal);
    }
  }
  creep.pressure = now.fields.pressure;
  now = turned(std::move(now), motion.frame);
  RollingProblem problem;
  problem.grid = now.grid;
  problem.slip_x = now.fields.slip.x;
  problem.slip_y = now.fields.slip.y;
  problem.weight_x = now.fields.weights.x;
  problem.weight_y = now.fields.weights.y;
  problem.pressure = now.fields.pressure;
  problem.covered = now.fields.covered;
  problem.friction = motion.friction;
  problem.shear_modulus = request.material.modulus;
  problem.poisson = request.material.poisson;
  problem.creepages = motion.frame.turned(motion.creepages);
  const double of_elements = creep_error_of_one_column / (chosen.columns * chosen.columns);
  // An iteration beyond what fewer elements than the accuracy needs can show would be in vain.
  problem.tolerance =
      creep_iteration_share *
      (chosen.limited ? std::max(request.accuracy, std::min(of_elements, coarsest_accuracy))
                      : request.accuracy);
  problem.derivatives = request.derivatives;
  std::vector<ProblemRate> problem_rate;
  if (request.derivatives && !unlike) {
    problem_rate = all_rates(task, creep.grid, problem);
    problem.rates = problem_rate;
  }
  RollingSolution solution;
  if (unlike) {
    solution = solve_both_ways(patch, motion, request, problem, solver, creep);
  } else if (request.model == CreepModel::full) {
    solution = solver.solve(problem);
  } else {
    solution = solve_by_strips(patch, motion, request, problem, solver);
  }
  solution = motion.frame.turned(std::move(solution));
  if (request.derivatives) {
    take_derivatives(solution, creep.derivatives.emplace());
  }
  take_facts(solution, creep);
  if (request.model == CreepModel::full) {
    creep.error_estimate = of_elements + creep_error_by_residual * solution.residual;
  }
  if (motion.twist) {
    take_in_slip(task, rows, slip, solution, creep);
  }
  creep.traction_x = std::move(solution.traction_x);
  creep.traction_y = std::move(solution.traction_y);
  creep.slip_x = std::move(solution.slip_x);
  creep.slip_y = std::move(solution.slip_y);
  return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment};
}

} // namespace wrc
