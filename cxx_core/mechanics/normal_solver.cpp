#include "mechanics/normal_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/reductions.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/coupled_influence.hpp"
#include "mechanics/exterior_check.hpp"
#include "mechanics/projected_cg.hpp"
#include "mechanics/scaled_problem.hpp"
#include "mechanics/yielding.hpp"

namespace wrc {

namespace {

/// Moves the sides that contact has reached outwards.
ElementBox grown(const ElementBox& box, const ReachedSides& reached, const LevelSize& size) {
  const std::size_t by_rows = box.rows() / box_growth_divisor + 1;
  const std::size_t by_columns = box.columns() / box_growth_divisor + 1;
  ElementBox larger = box;
  if (reached.first_row) {
    larger.first_row -= std::min(larger.first_row, by_rows);
  }
  if (reached.last_row) {
    larger.last_row = std::min(larger.last_row + by_rows, size.rows - 1);
  }
  if (reached.first_column) {
    larger.first_column -= std::min(larger.first_column, by_columns);
  }
  if (reached.last_column) {
    larger.last_column = std::min(larger.last_column + by_columns, size.columns - 1);
  }
  return larger;
}

/// A patch's part of the iteration on its box.
IterationBox iteration_box(PatchCascade& cascade, const Level& level) {
  const ElementBox& box = cascade.box;
  copy_box(level.size, box, level.pressure, cascade.box_pressure);
  copy_box(level.size, box, level.distance, cascade.box_distance);
  copy_box(level.size, box, level.shares, cascade.box_shares);
  IterationBox request;
  request.rows = box.rows();
  request.columns = box.columns();
  request.kernel = cascade.kernel;
  request.share = level.share;
  request.weight = level.weight;
  request.open_first_row = box.first_row > 0;
  request.open_last_row = box.last_row + 1 < level.size.rows;
  request.open_first_column = box.first_column > 0;
  request.open_last_column = box.last_column + 1 < level.size.columns;
  request.pressure = cascade.box_pressure;
  request.distance = cascade.box_distance;
  request.shares = cascade.box_shares;
  request.angles = angles_of(level, box.first_row, box.rows());
  return request;
}

/// The box around a patch's pressures; without any, around its penetration at the last approach, or
/// its nearest element.
void choose_box(PatchCascade& cascade, const Level& level, double approach) {
  if (find_pressure_box(level.size, level.pressure, box_margin, cascade.box)) {
    return;
  }
  if (!find_penetration_box(level, approach, box_margin, cascade.box)) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < level.distance.size(); ++i) {
      nearest = std::min(nearest, std::max(0.0, level.distance[i]) / level.shares[i]);
    }
    find_penetration_box(level, nearest * (1.0 + 1e-12) + 1e-300 / level.share, box_margin,
                         cascade.box);
  }
}

} // namespace

struct NormalSolver::State {
  State(std::shared_ptr<LinePlans> plans, Precision precision_asked)
      : precision(precision_asked), cache(std::move(plans)), single_iteration(cache),
        double_iteration(cache) {}

  void refine(std::size_t index);
  void choose_boxes(std::size_t index);
  IterationOutcome solve_level(std::size_t index, const IterationRequest& limits,
                               NormalSolution& solution);
  /// `permitted_error`: of pressures left out, relative to the largest one.
  bool enlarge_boxes(const IterationOutcome& outcome, double permitted_error);
  NormalSolution solve(const NormalProblem& problem);

  Precision precision;
  InfluenceCache cache;
  ProjectedCg<float> single_iteration;
  ProjectedCg<double> double_iteration;
  ScaledProblem scaled;
  std::vector<IterationBox> boxes;
};

/// Pressures from the next coarser grid.
void NormalSolver::State::refine(std::size_t index) {
  for (std::size_t k = 0; k < scaled.count; ++k) {
    PatchCascade& cascade = scaled.cascades[k];
    if (index + 1 < cascade.level_count) {
      const Level& coarser = cascade.levels[index + 1];
      Level& level = cascade.levels[index];
      refine_pressure(coarser.grid, coarser.pressure, level.grid, level.pressure);
    }
  }
}

/// Around the pressures that grid `index` starts with.
void NormalSolver::State::choose_boxes(std::size_t index) {
  bool any_pressure = false;
  for (std::size_t k = 0; k < scaled.count; ++k) {
    const std::vector<double>& pressure = scaled.cascades[k].at(index).pressure;
    any_pressure = any_pressure ||
                   std::any_of(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; });
  }
  if (!any_pressure) {
    scaled.draw_pressure(index); // the coarser grid has lost the contact
    return;
  }
  for (std::size_t k = 0; k < scaled.count; ++k) {
    choose_box(scaled.cascades[k], scaled.cascades[k].at(index), scaled.approach);
  }
}

/// Iterates on the boxes until contact keeps off their open sides; writes the pressures back.
IterationOutcome NormalSolver::State::solve_level(std::size_t index, const IterationRequest& limits,
                                                  NormalSolution& solution) {
  while (true) {
    boxes.resize(scaled.count);
    std::vector<Grid> coupled;
    for (std::size_t k = 0; k < scaled.count; ++k) {
      PatchCascade& cascade = scaled.cascades[k];
      const Level& level = cascade.at(index);
      boxes[k] = iteration_box(cascade, level);
      if (scaled.interaction != nullptr) {
        coupled.push_back(grid_in_mean_plane(level.grid, cascade.place, cascade.box));
      }
    }
    std::optional<PatchCoupling> coupling;
    if (scaled.interaction != nullptr) {
      coupling.emplace(std::move(coupled), scaled.interaction->coupling_weight,
                       std::clamp(coupling_share * limits.tolerance, min_coupling_error, 1.0));
    }
    IterationRequest request = limits;
    request.boxes = boxes;
    request.load = scaled.load;
    request.approach = scaled.approach;
    request.maximum_iterations = std::max(0, limits.maximum_iterations - solution.iterations);
    request.coupling = coupling ? &*coupling : nullptr;
    IterationOutcome outcome = precision == Precision::mixed ? single_iteration.solve(request)
                                                             : double_iteration.solve(request);
    solution.iterations += outcome.iterations;
    solution.convolutions += outcome.convolutions;
    for (std::size_t k = 0; k < scaled.count; ++k) {
      PatchCascade& cascade = scaled.cascades[k];
      Level& level = cascade.at(index);
      put_box(level.size, cascade.box, cascade.box_pressure, level.pressure);
      cascade.box = grown(cascade.box, outcome.reached[k], level.size);
    }
    scaled.approach = outcome.approach;
    if (!outcome.reached_any) {
      return outcome;
    }
  }
}

/// Where contact was missed outside; false if nowhere.
bool NormalSolver::State::enlarge_boxes(const IterationOutcome& outcome, double permitted_error) {
  const ExteriorCheck check{cache, single_iteration.workspace(), double_iteration.workspace()};
  // All are looked through before any box changes, which goes with the pressures on it.
  std::vector<std::optional<ElementBox>> larger(scaled.count);
  for (std::size_t k = 0; k < scaled.count; ++k) {
    larger[k] =
        check.larger_box(scaled, k, outcome.approach, permitted_error * outcome.largest_pressure);
  }
  bool missed = false;
  for (std::size_t k = 0; k < scaled.count; ++k) {
    missed = missed || larger[k].has_value();
    scaled.cascades[k].box = larger[k].value_or(scaled.cascades[k].box);
  }
  return missed;
}

NormalSolution NormalSolver::State::solve(const NormalProblem& problem) {
  const std::size_t count = problem.patches.size();
  NormalSolution solution;
  solution.patches.resize(count);
  const double first_touch = ScaledProblem::first_touch(problem);
  if (problem.load ? *problem.load == 0.0 : *problem.approach <= first_touch) {
    for (std::size_t k = 0; k < count; ++k) {
      solution.patches[k].pressure.assign(problem.patches[k].grid.element_count(), 0.0);
    }
    solution.approach = problem.approach.value_or(first_touch);
    return solution;
  }

  scaled.set(problem, cache);
  const std::optional<std::size_t> started = scaled.take_start(problem);
  const std::size_t first = started.value_or(scaled.level_count - 1);
  if (!started) {
    scaled.draw_pressure(first);
  }
  IterationRequest limits;
  limits.rounding_share = problem.rounding_share;
  const double permitted_error = std::max(0.5, problem.rounding_share) * problem.tolerance;
  limits.maximum_iterations = problem.maximum_iterations;
  IterationOutcome outcome;
  for (std::size_t i = first + 1; i-- > 0;) {
    if (i < first) {
      refine(i);
    }
    if (i < first || started) {
      choose_boxes(i);
    }
    limits.tolerance = stop_share * problem.tolerance;
    if (i > 0) {
      limits.tolerance = std::max(coarse_level_tolerance, limits.tolerance);
    }
    do {
      outcome = solve_level(i, limits, solution);
    } while (i == 0 && enlarge_boxes(outcome, permitted_error));
  }

  solution.stop_reason = outcome.stop_reason;
  solution.pressure_error = outcome.error / stop_share;
  for (std::size_t k = 0; k < count; ++k) {
    const Grid& grid = problem.patches[k].grid;
    NormalSolution::Patch& patch = solution.patches[k];
    patch.pressure.resize(grid.element_count());
    const std::vector<double>& pressure = scaled.cascades[k].finest().pressure;
    std::transform(pressure.begin(), pressure.end(), patch.pressure.begin(),
                   [this](double p) { return p * scaled.pressure_scale; });
    patch.normal_force = sum_of(patch.pressure.data(), patch.pressure.size()) * grid.element_area();
  }
  solution.approach =
      problem.approach.value_or(scaled.least_approach + scaled.approach * scaled.approach_scale);
  cache.drop_unused();
  return solution;
}

NormalSolver::NormalSolver(PlannerRigor rigor, Precision precision)
    : NormalSolver(std::make_shared<LinePlans>(rigor), precision) {}
NormalSolver::NormalSolver(std::shared_ptr<LinePlans> plans, Precision precision)
    : state_(new State(std::move(plans), precision)) {}
NormalSolver::~NormalSolver() = default;
NormalSolver::NormalSolver(NormalSolver&&) noexcept = default;
NormalSolver& NormalSolver::operator=(NormalSolver&&) noexcept = default;

NormalSolution NormalSolver::solve(const NormalProblem& problem) {
  check_problem(problem);
  return state_->solve(problem);
}

NormalSolution NormalSolver::solve_yielding(const NormalProblem& problem) {
  NormalSolution elastic;
  std::vector<PatchGap> started(problem.patches.begin(), problem.patches.end());
  const auto is_empty = [](const PatchGap& gap) {
    return std::ranges::none_of(gap.start, [](double p) { return p > 0.0; });
  };
  if (std::ranges::all_of(started, is_empty)) {
    elastic = solve(problem);
    for (std::size_t k = 0; k < started.size(); ++k) {
      started[k].start = elastic.patches[k].pressure;
    }
  }
  NormalProblem from_there = problem;
  from_there.patches = started;
  NormalSolution solution = wrc::solve_yielding(from_there, state_->cache);
  solution.iterations += elastic.iterations;
  solution.convolutions += elastic.convolutions;
  state_->cache.drop_unused();
  return solution;
}

} // namespace wrc
