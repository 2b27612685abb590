#include "wheel/solve_wheel.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/constants.hpp"
#include "accuracy/element_limit.hpp"
#include "accuracy/model_error.hpp"
#include "accuracy/peak_section.hpp"
#include "accuracy/resolution.hpp"
#include "base/error.hpp"
#include "base/reductions.hpp"
#include "base/stopwatch.hpp"
#include "mechanics/cascade.hpp"
#include "patches/depth_estimate.hpp"
#include "remesh/row_scales.hpp"
#include "wheel/constants.hpp"
#include "wheel/depth_checks.hpp"
#include "wheel/grid_plan.hpp"
#include "wheel/repeated_passes.hpp"
#include "wheel/wheel_warnings.hpp"
#include "wheel/yielded_wheel.hpp"

namespace wrc {
namespace {

/// The pressures of `before` on the grid of a patch, whose plane is nearly the same.
std::vector<double> pressure_at(const Patch& patch, const Patch& before) {
  const Vector3 moved = before.frame.origin - patch.frame.origin;
  Grid grid = before.grid;
  grid.lateral_first += patch.frame.lateral_of(moved);
  grid.longitudinal_first += moved.x;
  std::vector<double> pressure;
  refine_pressure(grid, before.pressure, patch.grid, pressure);
  return pressure;
}

double element_count(const GridSolution& solution) {
  double count = 0.0;
  for (const Patch& patch : solution.patches) {
    count += static_cast<double>(patch.grid.element_count());
  }
  return count;
}

/// What a solver sees of a patch (remesh/row_scales.hpp).
struct ScaledPatch {
  std::vector<double> distance;
  std::vector<double> approach_shares;
  std::vector<double> pressure;
  std::vector<double> angles;
};

class WheelSolver {
public:
  WheelSolver(const WheelSurface& wheel, const RailSurface& rail,
              const SideEquilibrium& equilibrium, const WheelRequest& request, NormalSolver& solver)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request),
        solver_(solver), goal_{request.accuracy,
                               request.position_is_prescribed(),
                               request.elements,
                               request.creep_forces,
                               request.stresses,
                               request.accuracy_of == AccuracyOf::forces && !request.stresses} {
    result_.request = request;
  }

  WheelSolution solve();

private:
  [[nodiscard]] double first_depth() const;
  const GridSolution& patches_at(double depth);
  GridSolution sample(double depth, const GridChoice& grids);
  /// Starting from the pressures of `before`, if that has the same number of patches.
  GridSolution solve_at(double depth, const GridChoice& grids, double tolerance,
                        const GridSolution* before);
  /// That of a solution from another depth; not above the first touch, where there is nothing to
  /// sample.
  [[nodiscard]] static double next_depth(const GridSolution& solution, double depth) {
    return std::max(solution.depth, min_depth_ratio * depth);
  }
  [[nodiscard]] Vector3 load_direction(const GridSolution& patches) const;
  [[nodiscard]] double vertical_load(const GridSolution& patches) const;
  void settle(GridSolution& solution, double approach);
  [[nodiscard]] double tolerance() const;
  GridChoice final_grids(double depth, const AccuracyGoal& goal);
  GridSolution solve_coarsely(double depth);
  GridSolution solve_finally(double depth, std::optional<GridSolution> before);
  GridSolution let_steel_yield(double depth, const std::optional<GridSolution>& coarse,
                               GridSolution elastic);
  void find_peaks(GridSolution& solution);
  [[nodiscard]] PosedPair posed(double depth) const {
    return {wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - depth};
  }
  GridSolution sample_only(double depth);
  void warn_of_limit();
  void publish(GridSolution solution);

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  const WheelRequest& request_;
  NormalSolver& solver_;
  AccuracyGoal goal_;
  std::optional<GridSolution> patches_;   ///< at the depth asked for last
  std::vector<RailNormals> rail_normals_; ///< of the grids sampled last
  ErrorEstimate error_;
  double interaction_error_ = 0.0;
  double load_imbalance_ = 0.0;         ///< of the last solution, before its pressures were scaled
  double elements_wanted_ = 0.0;        ///< most that grids would have without their limit
  std::optional<GridSolution> elastic_; ///< once steel yields: what it would be without
  std::optional<GridSolution> pass_;    ///< the pass before, if steel was pressed already
  WheelSolution result_;
};

double WheelSolver::first_depth() const {
  if (request_.position_is_prescribed()) {
    return equilibrium_.vertical - *request_.vertical;
  }
  return estimate_depth(equilibrium_.scan, request_.combined_modulus, request_.load(),
                        request_.normal_load ? LoadDirection::main_normal
                                             : LoadDirection::vertical);
}

double WheelSolver::tolerance() const {
  if (request_.grid) {
    return request_.tolerance;
  }
  if (request_.accuracy_of == AccuracyOf::pressures) {
    return iteration_share * goal_.of_contact();
  }
  return goal_.of_contact() *
         (request_.position_is_prescribed() ? smooth_position_share : smooth_load_share);
}

/// Without grids. Several are sampled at a depth one after another.
const GridSolution& WheelSolver::patches_at(double depth) {
  if (!patches_ || patches_->depth != depth) {
    patches_ = plan_patches(rail_, equilibrium_, request_, depth);
    set_bends(*patches_, posed(depth));
  }
  return *patches_;
}

GridChoice WheelSolver::final_grids(double depth, const AccuracyGoal& goal) {
  if (request_.grid) {
    return GridChoice(ElementCounts{(*request_.grid)[0], (*request_.grid)[1]});
  }
  std::vector<PatchElements> elements =
      final_elements(expected_contacts(patches_at(depth), rail_, equilibrium_), goal);
  if (elastic_) {
    refine_for_yield(*elastic_, goal, elements);
  }
  return GridChoice(std::move(elements));
}

/// The grids at a depth, with undeformed distances.
GridSolution WheelSolver::sample(double depth, const GridChoice& grids) {
  const Stopwatch watch;
  GridSolution solution = patches_at(depth);
  const PosedPair pair = posed(depth);
  if (request_.curved != CurvedChoice::no && request_.gap == GapConvention::tangent) {
    set_curves(solution, pair, request_);
  }
  const double wanted = set_grids(solution, rail_, grids, request_.most_elements());
  elements_wanted_ = std::max(elements_wanted_, wanted);
  rail_normals_.clear();
  for (Patch& patch : solution.patches) {
    const RailNormals& rail = rail_normals_.emplace_back(rail_, patch.frame, patch.grid);
    patch.undeformed_distance = sample_undeformed_distance(pair, patch.frame, patch.grid, &rail);
    patch.row_scales = row_scales(pair, patch.frame, patch.grid, rail);
  }
  result_.times.remesh += watch.seconds();
  return solution;
}

/// That in which the load presses. With distances along the wheelset's axis that is the gap's.
Vector3 WheelSolver::load_direction(const GridSolution& patches) const {
  if (!request_.normal_load) {
    return {0.0, 0.0, 1.0};
  }
  const Vector3 of_main = patches.force_of_main();
  const double amount = norm(of_main);
  return request_.gap == GapConvention::vertical || !(amount > 0.0)
             ? patches.patches[patches.main].frame.normal
             : (1.0 / amount) * of_main;
}

/// As patches before have shared it, or as their planes do.
double WheelSolver::vertical_load(const GridSolution& patches) const {
  const Vector3 direction = load_direction(patches);
  const Vector3 force = patches.force();
  const double along = dot(force, direction);
  return request_.load() * (along > 0.0 ? force.z / along : direction.z);
}

/// From the sampled height to the one that carries the load, by the approach found. Planes move
/// with the wheel, and distances change by each element's part of the rail's rise. There the rail's
/// surface has turned a little under the pressures; they are scaled to the load.
void WheelSolver::settle(GridSolution& solution, double approach) {
  solution.depth += approach;
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    RailNormals& rail = rail_normals_[k];
    for (std::size_t i = 0; i < patch.approach_shares.size(); ++i) {
      patch.undeformed_distance[i] -= approach * patch.approach_shares[i];
    }
    patch.frame.origin.z -= approach;
    rail.shift({0.0, 0.0, -approach});
    patch.contact_force = rail.force(patch.pressure);
  }
  const double borne = dot(solution.force(), load_direction(solution));
  load_imbalance_ = 0.0;
  if (!request_.position_is_prescribed() && !(borne > 0.0)) {
    load_imbalance_ = 1.0; // the rail pulls: its surface has turned upright
  } else if (!request_.position_is_prescribed()) {
    const double factor = request_.load() / borne;
    load_imbalance_ = std::abs(factor - 1.0);
    for (Patch& patch : solution.patches) {
      for (double& pressure : patch.pressure) {
        pressure *= factor;
      }
      patch.normal_force *= factor;
      patch.contact_force = {factor * patch.contact_force.force,
                             factor * patch.contact_force.moment};
    }
  }
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    patch.contact = summarise_pressure(patch.grid, patch.pressure);
    patch.turn = rail_normals_[k].turn(patch.pressure);
  }
}

GridSolution WheelSolver::solve_at(double depth, const GridChoice& grids, double tolerance,
                                   const GridSolution* before) {
  GridSolution solution = sample(depth, grids);
  const Stopwatch watch;
  std::vector<PatchGap> gaps;
  std::vector<ScaledPatch> scaled(solution.patches.size()); // that the gaps refer to
  const bool starts = before != nullptr && before->patches.size() == solution.patches.size();
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    if (starts) {
      patch.pressure = pressure_at(patch, before->patches[k]);
    }
    if (pass_) {
      take_groove(*pass_, patch);
    }
    if (!request_.position_is_prescribed()) {
      patch.approach_shares = rail_normals_[k].shares({0.0, 0.0, 1.0});
    }
    scaled[k] = {times_scales(patch.grid, patch.row_scales, patch.undeformed_distance),
                 times_scales(patch.grid, patch.row_scales, patch.approach_shares),
                 over_scales(patch.grid, patch.row_scales, patch.pressure),
                 row_angles(patch.frame, patch.grid)};
    gaps.push_back({patch.grid, scaled[k].distance, patch.frame.normal.z, scaled[k].pressure,
                    scaled[k].approach_shares, scaled[k].angles, patch.row_scales,
                    patch.groove.carried});
  }
  NormalProblem problem;
  problem.patches = gaps;
  problem.combined_modulus = request_.combined_modulus;
  if (request_.position_is_prescribed()) {
    problem.approach = 0.0; // the wheel has been lowered already
  } else {
    problem.load = vertical_load(starts ? *before : solution);
  }
  problem.tolerance = tolerance;
  if (!request_.grid) {
    problem.rounding_share = max_rounding * request_.accuracy / tolerance;
  }
  problem.maximum_iterations = request_.maximum_iterations;
  if (!request_.grid) {
    problem.maximum_iterations =
        std::min(problem.maximum_iterations,
                 affordable_iterations(element_count(solution), request_.most_elements()));
  }
  problem.elements = request_.elements;
  problem.interaction = solution.interaction ? &*solution.interaction : nullptr;
  problem.yielding = request_.yielding;
  ++result_.solutions;
  NormalSolution solved = request_.solver == SolverChoice::paper && problem.patches.size() == 1
                              ? solve_with_polonsky_keer(problem)
                          : elastic_ ? solver_.solve_yielding(problem)
                                     : solver_.solve(problem);
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    patch.pressure = times_scales(patch.grid, patch.row_scales, solved.patches[k].pressure);
    patch.normal_force =
        patch.grid.element_area() * sum_of(patch.pressure.data(), patch.pressure.size());
    if (elastic_) {
      leave_groove(request_.yielding, solved.patches[k].indentation, patch);
    }
  }
  result_.iterations += solved.iterations;
  result_.convolutions += solved.convolutions;
  solution.stop_reason = solved.stop_reason;
  solution.pressure_error = solved.pressure_error;
  check_found_depth(request_, depth + solved.approach);
  settle(solution, solved.approach);
  if (problem.load) {
    result_.load = vertical_load(solution);
  }
  result_.times.mechanics += watch.seconds();
  return solution;
}

/// Shows the depth for the load on few elements.
GridSolution WheelSolver::solve_coarsely(double depth) {
  GridSolution solution = solve_at(depth, GridChoice(coarse_counts()), coarse_tolerance, nullptr);
  if (solution.no_contact()) {
    throw Error(ErrorCode::internal, "no contact found at a depth of " + text_of(depth) + " mm");
  }
  return solution;
}

/// Largest pressures between the elements of a solution.
void WheelSolver::find_peaks(GridSolution& solution) {
  const Stopwatch watch;
  const PosedPair pair = posed(solution.depth);
  for (Patch& patch : solution.patches) {
    if (!patch.no_contact()) {
      const PeakInSection peak =
          peak_in_section(patch, solution.elements, pair, request_.combined_modulus, tolerance());
      // What no element has of a crest is missing in the stresses below them.
      const double missing = peak.pressure - patch.contact.largest_element_pressure;
      patch.peak_error =
          std::max(peak.error, request_.stresses ? stress_error_by_crest * missing : 0.0);
      patch.contact.peak_pressure = peak.pressure;
      patch.growth = growth_at_ridge(patch.ridge, request_.combined_modulus);
    }
  }
  result_.times.mechanics += watch.seconds();
}

/// Near the depth found, on more elements where the estimate asks for them.
GridSolution WheelSolver::solve_finally(double depth, std::optional<GridSolution> before) {
  const bool of_forces = goal_.forces_only;
  GridChoice grids = final_grids(depth, goal_);
  bool finer = false;
  const bool may_grow = !of_forces && !request_.position_is_prescribed();
  for (int attempt = 1;; ++attempt) {
    GridSolution solution = solve_at(depth, grids, tolerance(), before ? &*before : nullptr);
    if (solution.no_contact() || attempt == max_attempts) {
      mark_unsettled(solution, attempt, result_.warnings);
      return solution;
    }
    const bool outgrown = may_grow && attempt == 1 && outgrows_grid(solution);
    if (outgrown || load_imbalance_ > tolerance()) {
      depth = next_depth(solution, depth);
      if (outgrown) {
        grids = final_grids(depth, goal_);
      }
      before = std::move(solution);
      continue;
    }
    find_ridges(solution, posed(solution.depth));
    if (elastic_) {
      set_elastic_peaks(solution, *elastic_, goal_, request_.yielding);
    } else if (!of_forces) {
      find_peaks(solution);
    }
    error_ = estimate_error(solution, goal_);
    result_.discretisation_error = error_.total();
    result_.force_error = error_.of_forces();
    interaction_error_ = interaction_error(solution, request_.combined_modulus);
    result_.model_error = std::hypot(
        estimate_model_error(solution, request_.accuracy_of, goal_.position_is_prescribed),
        interaction_error_);
    // Forces are kept: with a second grid they would not be continuous functions of the scene. The
    // limit of elements must not be exceeded.
    if (error_.reducible() <= request_.accuracy || request_.grid || finer || of_forces ||
        elements_wanted_ > request_.most_elements()) {
      return solution;
    }
    grids = GridChoice(finer_elements(solution, error_, goal_));
    finer = true;
    depth = next_depth(solution, depth);
    before = std::move(solution);
  }
}

/// From the depth of the coarse solution on, as if it had yielded from the beginning.
GridSolution WheelSolver::let_steel_yield(double depth, const std::optional<GridSolution>& coarse,
                                          GridSolution elastic) {
  elastic_ = std::move(elastic);
  take_back_sections(*elastic_);
  elements_wanted_ = 0.0;
  std::erase_if(result_.warnings,
                [](const Warning& warning) { return warning.kind == WarningClass::not_settled; });
  GridSolution before = softened(coarse ? *coarse : *elastic_, request_.yielding);
  if (coarse) {
    before = solve_at(depth, GridChoice(coarse_counts()), coarse_tolerance, &before);
    depth = next_depth(before, depth);
  }
  GridSolution solution = solve_finally(depth, std::move(before));
  for (int pass = 1; another_pass(solution, pass, request_.passes, result_.warnings); ++pass) {
    pass_ = solution;
    solution = solve_finally(next_depth(*pass_, depth), solution);
  }
  return solution;
}

void WheelSolver::warn_of_limit() {
  if (!request_.grid && elements_wanted_ > request_.most_elements()) {
    result_.warnings.push_back(
        {WarningClass::element_limit, text_of_limit(elements_wanted_, request_.most_elements())});
  }
}

void WheelSolver::publish(GridSolution solution) {
  result_.in_contact = !result_.solved || !solution.no_contact();
  result_.depth = solution.depth;
  result_.vertical = equilibrium_.vertical - solution.depth;
  result_.peak_pressure = solution.peak_pressure();
  result_.stop_reason = solution.stop_reason;
  const std::vector<PlanePatches> planes = solution.patches_by_plane(result_.solved);
  std::vector<std::size_t> order;
  for (const PlanePatches& plane : planes) {
    order.insert(order.end(), plane.patches.begin(), plane.patches.end());
  }
  if (solution.interaction) {
    PatchInteraction& reordered = result_.interaction.emplace();
    for (const std::size_t k : order) {
      reordered.places.push_back(solution.interaction->places[k]);
      for (const std::size_t l : order) {
        reordered.coupling_weight.push_back(
            solution.interaction->coupling_weight[k * solution.patches.size() + l]);
      }
    }
  }
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    for (const std::size_t k : planes[plane].patches) {
      Patch& patch = result_.patches.emplace_back(std::move(solution.patches[k]));
      patch.approach_shares = {}; // for solving only
      patch.plane = plane;
      patch.approach = patch.overlap();
    }
  }
}

/// The potential contact areas of penetration, with the elements that solutions start with.
GridSolution WheelSolver::sample_only(double depth) {
  GridSolution solution = sample(depth, final_grids(depth, goal_));
  warn_of_limit();
  for (Patch& patch : solution.patches) {
    patch.pressure.assign(patch.grid.element_count(), 0.0);
  }
  return solution;
}

WheelSolution WheelSolver::solve() {
  result_.solved = request_.until == Module::mechanics;
  result_.vertical = equilibrium_.vertical;
  if (request_.curved == CurvedChoice::yes && request_.gap == GapConvention::vertical) {
    throw_invalid_argument("solve.curved", "\"yes\"",
                           "must be \"no\" or \"auto\" with solve.method = \"paper\"");
  }
  if (request_.until == Module::geometry) {
    return std::move(result_);
  }
  double depth = request_.position_is_prescribed() || request_.load() > 0.0 ? first_depth() : 0.0;
  if (!is_in_contact(request_, depth, result_.warnings)) {
    return std::move(result_);
  }
  if (request_.until == Module::remesh) {
    publish(sample_only(depth));
    return std::move(result_);
  }
  const double depth_at_first = depth;
  std::optional<GridSolution> coarse;
  if (!request_.position_is_prescribed()) {
    coarse = solve_coarsely(depth);
    depth = next_depth(*coarse, depth);
  }
  const bool may_yield = !request_.yielding.empty() && request_.solver == SolverChoice::standard;
  const std::optional<GridSolution> kept = may_yield ? coarse : std::nullopt;
  GridSolution solution = solve_finally(depth, std::move(coarse));
  if (may_yield && yields(solution, request_.yielding)) {
    solution = let_steel_yield(depth_at_first, kept, std::move(solution));
  }
  warn_of_solution(solution, request_, wheel_.radius(), {error_.ridge, interaction_error_},
                   result_);
  warn_of_limit();
  publish(std::move(solution));
  warn_of_patches(request_, result_);
  state_error_of_yield(result_);
  return std::move(result_);
}

} // namespace

WheelSolution solve_wheel(const WheelSurface& wheel, const RailSurface& rail,
                          const SideEquilibrium& equilibrium, const WheelRequest& request,
                          NormalSolver& solver) {
  return WheelSolver(wheel, rail, equilibrium, request, solver).solve();
}

} // namespace wrc
