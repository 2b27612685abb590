#include "creep/creep_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "accuracy/constants.hpp"
#include "creep/constants.hpp"
#include "creep/creep_elements.hpp"
#include "creep/elastic_history.hpp"
#include "pressure/moved_load.hpp"
#include "pressure/smooth_pressure.hpp"

namespace wrc {
namespace {

/// What is solved for, in the plane of the patch.
struct PatchFields {
  Grid grid;
  ProblemFields fields;
};

/// Mean pressures of elements, scaled to this force together, and the fractions of them that
/// contact covers. `misplaced`, if any: by how much of this force they missed it before.
std::vector<double> pressures_on(const Grid& grid, const SmoothPressure& pressure,
                                 double normal_force, std::vector<double>& covered,
                                 double* misplaced = nullptr) {
  std::vector<double> result;
  pressure.fill_means(grid, result, covered);
  const double force = std::accumulate(result.begin(), result.end(), 0.0) * grid.element_area();
  for (double& p : result) {
    p *= force > 0.0 ? normal_force / force : 0.0;
  }
  if (misplaced != nullptr) {
    *misplaced = normal_force > 0.0 ? std::abs(force / normal_force - 1.0) : 0.0;
  }
  return result;
}

PatchFields turned(PatchFields patch, const RollingFrame& frame) {
  ProblemFields& fields = patch.fields;
  return {frame.turned(patch.grid),
          {frame.turned_numbers(std::move(fields.pressure)),
           frame.turned_numbers(std::move(fields.covered)), frame.turned(std::move(fields.slip)),
           frame.turned(std::move(fields.weights))}};
}

/// What a step of time starts from, in a plane that may have moved.
void add_displacements(const PatchTask& task, const ContactFrame& frame, const Grid& grid,
                       SlipField& slip) {
  if (task.motion.step_length > 0.0 && task.request.history != nullptr) {
    add_history(*task.request.history, *task.wheel.details.rail, frame, grid,
                task.motion.step_length, slip);
  }
}

/// Of rows to the patch's plane, by which pressures make them slip, in the rolling frame; none of
/// slip that is not that of each element.
std::vector<double> inclinations_of(const std::vector<SlipRow>& rows, const SlipChoice& choice,
                                    const RollingFrame& frame) {
  std::vector<double> angles;
  if (choice.variation != SlipVariation::by_element) {
    return angles;
  }
  angles.reserve(rows.size());
  for (const SlipRow& row : rows) {
    angles.push_back(std::atan2(row.sine, row.cosine));
  }
  return frame.turned_components(std::move(angles));
}

/// Slip of elements, and what pressures add: the part of rolling, so that none is left at
/// standstill.
SlipField sum(SlipField slip, const SlipByPressures& added, const PatchMotion& motion) {
  const double part = motion.rolling_share * motion.slip_scale;
  slip.x.resize(std::max(slip.x.size(), added.x.size()));
  slip.y.resize(slip.x.size());
  for (std::size_t i = 0; i < added.x.size(); ++i) {
    slip.x[i] += part * added.x[i];
    slip.y[i] += part * added.y[i];
  }
  return slip;
}

/// Error of creep forces by the elements of pressures, where the gap bends.
double error_of_bend(const PatchResult& patch, const SmoothPressure& pressure) {
  if (!(patch.bend > 0.0)) {
    return 0.0;
  }
  const PressureRegion& contact = patch.contact;
  return error_by_moved_load * patch.bend *
         moved_load(patch.grid, patch.pressure, pressure, contact.centroid_longitudinal,
                    std::sqrt(contact.semi_axis_longitudinal * contact.semi_axis_lateral));
}

/// By position; `now`: in the rolling frame, on `grid` of the patch's plane.
std::vector<ProblemRate> problem_rates(const PatchTask& task, const Grid& grid,
                                       const RollingProblem& now, LinePlans& plans) {
  std::vector<ProblemRate> result;
  const PatchResult& patch = task.patch;
  const auto moves = moves_of(patch, *task.rates, creep_pressure_step);
  for (std::size_t position = 0; position < position_count; ++position) {
    const MovedPatch& moved = moves[position].ahead;
    const double step = 0.5 * moves[position].apart;
    const Grid around = moved_grid(patch.grid, moved.elements);
    const SmoothPressure smooth(around, moved.pressure, patch.bend);
    PatchFields ahead{moved_around_contact(grid, smooth), {}};
    ahead.fields.pressure =
        pressures_on(ahead.grid, smooth, moved.normal_force, ahead.fields.covered);
    const MovedContact contact(task.wheel, patch, *task.rates, position, step);
    const std::vector<SlipRow> rows = task.request.slip.variation == SlipVariation::planar
                                          ? std::vector<SlipRow>{}
                                          : contact.rows(ahead.grid, task.request.slip);
    if (task.motion.twist) {
      const SlipGeometry geometry = contact.geometry(around, moved.pressure, task.request.slip);
      ahead.fields.slip = slip_beyond(geometry, rows, ahead.grid, contact.twist());
      ahead.fields.weights = slip_beyond(geometry, rows, ahead.grid, along_the_normal);
    }
    add_displacements(task, contact.frame(), ahead.grid, ahead.fields.slip);
    ahead = turned(std::move(ahead), task.motion.frame);
    RollingProblem then = now;
    then.grid = ahead.grid;
    then.pressure = ahead.fields.pressure;
    const std::vector<double> inclinations =
        inclinations_of(rows, task.request.slip, task.motion.frame);
    ahead.fields.slip =
        sum(std::move(ahead.fields.slip),
            smooth_slip_by_pressures(then, now.angles.empty() ? inclinations : now.angles, plans),
            task.motion);
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
  if (solution.by_rate.size() > next + 2) {
    derivatives.by_rolling_share = solution.by_rate.back();
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

/// The rates that derivatives need: by positions where they are known and bodies are alike, by the
/// slip beyond creepages and by a velocity along the normal, in a step of time and where pressures
/// make rows slip by the share of rolling.
std::vector<ProblemRate> all_rates(const PatchTask& task, const Grid& grid,
                                   const RollingProblem& problem,
                                   const SlipByPressures& by_pressures, LinePlans& plans) {
  std::vector<ProblemRate> rates;
  if (task.rates != nullptr && !unlike_bodies(task.request)) {
    rates = problem_rates(task, grid, problem, plans);
  }
  if (!problem.slip_x.empty() || problem.step_length > 0.0) {
    rates.push_back(rate_by(problem, problem.slip_x, problem.slip_y));
    rates.push_back(rate_by(problem, problem.weight_x, problem.weight_y));
  }
  if (problem.step_length > 0.0 || !by_pressures.x.empty()) {
    rates.push_back(rate_by(problem, by_pressures.x, by_pressures.y));
    rates.back().rolling_share = 1.0;
  }
  return rates;
}

} // namespace

CreepProblem::CreepProblem(const PatchTask& task, LinePlans& plans, CreepResult& creep)
    : task_(task), plans_(plans) {
  const auto& [wheel, patch, motion, request, known] = task;
  const SmoothPressure pressure(patch.grid, patch.pressure, patch.bend);
  const CreepGrid chosen = grid_of_patch(patch, pressure, request);
  grid_ = creep.grid = chosen.grid;
  creep.elements_wanted = chosen.wanted;
  PatchFields now{grid_, {}};
  double misplaced = 0.0;
  now.fields.pressure =
      pressures_on(grid_, pressure, patch.normal_force, now.fields.covered, &misplaced);
  if (request.slip.variation != SlipVariation::planar) {
    rows_ = rows_on(wheel, patch, grid_, request.slip);
  }
  if (motion.twist) {
    now.fields.slip = slip_ = slip_beyond(*patch.slip, rows_, grid_, *motion.twist);
    if (request.derivatives) {
      now.fields.weights = slip_beyond(*patch.slip, rows_, grid_, along_the_normal);
    }
  }
  add_displacements(task, patch.frame, grid_, now.fields.slip);
  creep.pressure = now.fields.pressure;
  now = turned(std::move(now), motion.frame);
  fields_ = std::move(now.fields);
  problem_.grid = now.grid;
  problem_.weight_x = fields_.weights.x;
  problem_.weight_y = fields_.weights.y;
  problem_.pressure = fields_.pressure;
  problem_.covered = fields_.covered;
  problem_.friction = motion.friction;
  problem_.shear_modulus = request.material.modulus;
  problem_.poisson = request.material.poisson;
  problem_.creepages = motion.frame.turned(motion.creepages);
  problem_.step_length = motion.step_length;
  problem_.rolling_share = motion.rolling_share;
  angles_ = motion.frame.turned_components(row_angles(patch.frame, grid_));
  problem_.angles = angles_;
  by_pressures_ = smooth_slip_by_pressures(
      problem_, angles_.empty() ? inclinations_of(rows_, request.slip, motion.frame) : angles_,
      plans_);
  fields_.slip = sum(std::move(fields_.slip), by_pressures_, motion);
  problem_.slip_x = fields_.slip.x;
  problem_.slip_y = fields_.slip.y;
  error_of_elements_ = creep_error_of_one_column / (chosen.columns * chosen.columns);
  // An iteration beyond what fewer elements than the accuracy needs can show would be in vain.
  problem_.tolerance =
      (motion.step_length > 0.0 ? step_iteration_share : creep_iteration_share) *
      (chosen.limited ? std::max(request.accuracy, std::min(error_of_elements_, coarsest_accuracy))
                      : request.accuracy);
  error_of_elements_ =
      std::max(std::hypot(error_of_elements_, error_of_bend(patch, pressure)), misplaced);
  problem_.derivatives = request.derivatives;
}

void CreepProblem::request_rates() {
  rates_ = all_rates(task_, grid_, problem_, by_pressures_, plans_);
  problem_.rates = rates_;
}

CreepForces CreepProblem::take(RollingSolution solution, CreepResult& creep) const {
  const CreepRequest& request = task_.request;
  for (std::size_t i = 0; i < by_pressures_.x.size(); ++i) {
    solution.power_of_pressures -=
        task_.motion.rolling_share * grid_.element_area() *
        (solution.traction_x[i] * by_pressures_.x[i] + solution.traction_y[i] * by_pressures_.y[i]);
  }
  solution = task_.motion.frame.turned(std::move(solution));
  if (request.derivatives) {
    take_derivatives(solution, creep.derivatives.emplace());
  }
  take_facts(solution, creep);
  creep.error_estimate =
      std::hypot(error_of_elements_ + creep_error_by_residual * solution.residual,
                 creep_error_of_plane * task_.patch.plane_force_error);
  if (task_.motion.twist) {
    take_in_slip(task_, rows_, slip_, solution, creep);
  }
  creep.traction_x = std::move(solution.traction_x);
  creep.traction_y = std::move(solution.traction_y);
  creep.displacement_x = std::move(solution.displacement_x);
  creep.displacement_y = std::move(solution.displacement_y);
  creep.slip_x = std::move(solution.slip_x);
  creep.slip_y = std::move(solution.slip_y);
  return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment};
}

} // namespace wrc
