#include "wheel/wheel_solution.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/constants.hpp"
#include "accuracy/peak_section.hpp"
#include "accuracy/resolution.hpp"
#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "mechanics/cascade.hpp"
#include "patches/depth_estimate.hpp"
#include "wheel/constants.hpp"
#include "wheel/depth_checks.hpp"
#include "wheel/depth_iteration.hpp"
#include "wheel/grid_plan.hpp"
#include "wheel/wheel_warnings.hpp"

namespace wrc {
namespace {

/// The pressures of `before` on the grid of a patch, whose plane is nearly the same.
std::vector<double> pressure_at(const Patch& patch, const Patch& before) {
  const Vector3 moved = before.frame.origin - patch.frame.origin;
  Grid grid = before.grid;
  grid.lateral_first += dot(moved, patch.frame.lateral);
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

class WheelSolver {
public:
  WheelSolver(const WheelSurface& wheel, const RailSurface& rail,
              const SideEquilibrium& equilibrium, const WheelRequest& request, NormalSolver& solver)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request),
        solver_(solver), goal_{request.accuracy, request.position_is_prescribed(), request.elements,
                               request.creep_forces, request.stresses} {}

  WheelSolution solve();

private:
  [[nodiscard]] double first_depth() const;
  const GridSolution& patches_at(double depth);
  GridSolution sample(double depth, const GridChoice& grids);
  /// Starting from the pressures of `before`, if that has as many patches.
  GridSolution solve_at(double depth, const GridChoice& grids, double tolerance,
                        const GridSolution* before);
  /// Relative change of distances within patches, as a share of that of the depth.
  [[nodiscard]] double sliding(const GridSolution& solution) const;
  [[nodiscard]] double depth_found(const GridSolution& solution) const {
    // Not above the first touch, where there is nothing to sample.
    return request_.position_is_prescribed()
               ? solution.depth
               : std::max(solution.depth_found, min_depth_ratio * solution.depth);
  }
  [[nodiscard]] double tolerance() const;
  GridChoice final_grids(double depth, const AccuracyGoal& goal);
  GridSolution solve_coarsely(double depth);
  void settle_planes(GridSolution& solution);
  [[nodiscard]] double share_to_follow(const GridSolution& patches) const;
  GridSolution solve_finally(double depth, double follows, std::optional<GridSolution> before);
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
  std::optional<GridSolution> patches_; ///< at the depth asked for last
  double ridge_error_ = 0.0;
  double elements_wanted_ = 0.0; ///< most that grids would have without their limit
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
  }
  return *patches_;
}

GridChoice WheelSolver::final_grids(double depth, const AccuracyGoal& goal) {
  if (request_.grid) {
    return GridChoice(ElementCounts{(*request_.grid)[0], (*request_.grid)[1]});
  }
  return GridChoice(
      final_elements(expected_contacts(patches_at(depth), rail_, equilibrium_.scan), goal));
}

/// The grids at a depth, with undeformed distances.
GridSolution WheelSolver::sample(double depth, const GridChoice& grids) {
  const Stopwatch watch;
  GridSolution solution = patches_at(depth);
  const double wanted = set_grids(solution, rail_, grids, request_.element_limit);
  elements_wanted_ = std::max(elements_wanted_, wanted);
  const PosedPair pair = posed(depth);
  for (Patch& patch : solution.patches) {
    patch.undeformed_distance = sample_undeformed_distance(pair, patch.frame, patch.grid);
  }
  result_.times.remesh += watch.seconds();
  return solution;
}

GridSolution WheelSolver::solve_at(double depth, const GridChoice& grids, double tolerance,
                                   const GridSolution* before) {
  GridSolution solution = sample(depth, grids);
  const Stopwatch watch;
  std::vector<PatchGap> gaps;
  const bool starts = before != nullptr && before->patches.size() == solution.patches.size();
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    if (starts) {
      patch.pressure = pressure_at(patch, before->patches[k]);
    }
    gaps.push_back({patch.grid, patch.undeformed_distance, patch.approach_cosine, patch.pressure});
  }
  NormalProblem problem;
  problem.patches = gaps;
  problem.combined_modulus = request_.combined_modulus;
  if (request_.position_is_prescribed()) {
    problem.approach = 0.0; // the wheel has been lowered already
  } else {
    problem.load = request_.load();
  }
  problem.tolerance = tolerance;
  if (!request_.grid) {
    problem.rounding_share = max_rounding * request_.accuracy / tolerance;
  }
  problem.maximum_iterations = request_.maximum_iterations;
  if (!request_.grid) {
    problem.maximum_iterations =
        std::min(problem.maximum_iterations,
                 affordable_iterations(element_count(solution), request_.element_limit));
  }
  problem.elements = request_.elements;
  problem.interaction = solution.interaction ? &*solution.interaction : nullptr;
  ++result_.solutions;
  NormalSolution solved = request_.solver == SolverChoice::paper && problem.patches.size() == 1
                              ? solve_with_polonsky_keer(problem)
                              : solver_.solve(problem);
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    patch.pressure = std::move(solved.patches[k].pressure);
    patch.normal_force = solved.patches[k].normal_force;
    patch.contact = summarise_pressure(patch.grid, patch.pressure);
  }
  result_.iterations += solved.iterations;
  result_.convolutions += solved.convolutions;
  solution.approach = solved.approach;
  solution.stop_reason = solved.stop_reason;
  solution.pressure_error = solved.pressure_error;
  const double main_cosine = solution.patches[solution.main].frame.normal.z;
  solution.depth_found = depth + solved.approach / (request_.normal_load ? main_cosine : 1.0);
  result_.times.mechanics += watch.seconds();
  check_found_depth(request_, solution.depth_found); // before planes are turned there
  return solution;
}

/// A wheel that sinks along a plane under the angle a slides along it by sin(a) of the step, and
/// distances then change by that times the angle to the plane: at most tan(a) times the turn of the
/// rail within the patch, as shares of the step along the normal. Where interactions and planes
/// follow from how close patches are, all may change with the depth.
double WheelSolver::sliding(const GridSolution& solution) const {
  double most = 0.0;
  for (const double link : solution.links) {
    most = std::max(most, 4.0 * link * (1.0 - link));
  }
  for (const Patch& patch : solution.patches) {
    const auto angle_at = [this](double y) {
      return std::atan(rail_.graph().at_lateral(y).slope());
    };
    const double turn = angle_at(patch.penetration.y_last) - angle_at(patch.penetration.y_first);
    most =
        std::max(most, patch.penetration.weight * std::abs(std::tan(patch.frame.angle()) * turn));
  }
  return most;
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
          peak_in_section(patch, solution.elements, pair, patch.approach_cosine * solution.approach,
                          request_.combined_modulus, tolerance());
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

/// How far the planes are to follow from the depth of the coarse solution to the one found: not at
/// all where wheels hardly slide along them, in full where they slide twice as much. In full, too,
/// on a grid given by hand, whose errors the accuracy says nothing of.
double WheelSolver::share_to_follow(const GridSolution& patches) const {
  if (request_.grid) {
    return 1.0;
  }
  return std::clamp(sliding(patches) / (min_sliding * request_.accuracy) - 1.0, 0.0, 1.0);
}

/// To creep forces the shape of the contact counts: a depth for their planes from the elements of
/// normal forces, from two solutions where planes follow.
void WheelSolver::settle_planes(GridSolution& solution) {
  AccuracyGoal goal = goal_;
  goal.creep_forces = false;
  const auto solve_again = [&](double share) {
    const double depth = depth_found(solution);
    solution = solve_at(depth, final_grids(depth, goal), coarse_tolerance, &solution);
    solution.depth_found = depth + share * (depth_found(solution) - depth);
  };
  solve_again(1.0);
  if (const double follows = share_to_follow(solution); follows > 0.0) {
    solve_again(follows);
  }
}

/// A patch just born: its penetration at a depth less than the one found is too small for it.
bool outgrows_grid(const GridSolution& solution) {
  return std::ranges::any_of(solution.patches, [](const Patch& patch) {
    return patch.contact.touches_edge.any() && !reaches_neighbour(patch);
  });
}

/// Near the depth found, on more elements where the estimate asks for them.
GridSolution WheelSolver::solve_finally(double depth, double follows,
                                        std::optional<GridSolution> before) {
  const bool of_forces = request_.accuracy_of == AccuracyOf::forces && !request_.stresses;
  GridChoice grids = final_grids(depth, goal_);
  bool finer = false;
  const bool may_grow = !of_forces && !request_.position_is_prescribed();
  const double planes_begin = depth;
  // Always one more, on larger elements, where planes follow: forces are to be smooth.
  bool shows_depth_only =
      follows > 0.0 && !request_.grid && request_.accuracy_of == AccuracyOf::forces;
  AccuracyGoal of_depth = goal_;
  of_depth.accuracy *= coarser_for_depth;
  DepthIteration iteration;
  for (int attempt = 1;; ++attempt) {
    const double coarser = shows_depth_only ? coarse_tolerance : 0.0;
    GridSolution solution = solve_at(depth, shows_depth_only ? final_grids(depth, of_depth) : grids,
                                     std::max(coarser, tolerance()), before ? &*before : nullptr);
    if (solution.no_contact() || attempt == max_attempts) {
      mark_unsettled(solution, attempt, result_.warnings);
      return solution;
    }
    if (may_grow && attempt == 1 && outgrows_grid(solution)) {
      depth = depth_found(solution);
      grids = final_grids(depth, goal_);
      follows = 1.0;
      before = std::move(solution);
      continue;
    }
    const double found = planes_begin + follows * (depth_found(solution) - planes_begin);
    const double change = std::abs(found / depth - 1.0) * sliding(solution);
    const double limit = finer                         ? max_change_for_crests
                         : of_forces && !request_.grid ? max_change_of_forces
                                                       : max_change;
    const std::optional<double> next =
        shows_depth_only ? found
                         : iteration.next(depth, found, change / (limit * request_.accuracy));
    if (next) {
      depth = *next;
      shows_depth_only = false;
      before = std::move(solution);
      continue;
    }
    find_ridges(solution, posed(solution.depth));
    if (!of_forces) {
      find_peaks(solution);
    }
    const ErrorEstimate error = estimate_error(solution, goal_);
    result_.error_estimate = error.total();
    ridge_error_ = error.ridge;
    // Forces stay as they are: a second grid would be no continuous function of the scene.
    // More elements than the limit permits are not to be had.
    if (error.reducible() <= request_.accuracy || request_.grid || finer || of_forces ||
        elements_wanted_ > request_.element_limit) {
      return solution;
    }
    grids = GridChoice(finer_elements(solution, error, goal_));
    finer = true;
    iteration = {};
    depth = found;
    before = std::move(solution);
  }
}

void WheelSolver::warn_of_limit() {
  if (!request_.grid && elements_wanted_ > request_.element_limit) {
    result_.warnings.push_back(
        {WarningClass::element_limit, text_of_limit(elements_wanted_, request_.element_limit)});
  }
}

void WheelSolver::publish(GridSolution solution) {
  result_.in_contact = !result_.solved || !solution.no_contact();
  result_.depth = solution.depth;
  result_.approach = solution.approach;
  result_.depth_found = solution.depth_found;
  result_.vertical = equilibrium_.vertical - solution.depth;
  result_.peak_pressure = solution.peak_pressure();
  result_.combined_modulus = request_.combined_modulus;
  result_.elements = request_.elements;
  result_.gap = request_.gap;
  result_.joining_distance = request_.joining_distance;
  result_.stop_reason = solution.stop_reason;
  if (!request_.position_is_prescribed()) {
    result_.load = request_.load();
  }
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
      patch.plane = plane;
      patch.approach = patch.overlap(solution.approach);
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
  solution.depth_found = depth;
  return solution;
}

WheelSolution WheelSolver::solve() {
  result_.solved = request_.until == Module::mechanics;
  if (equilibrium_.scan.candidates.front().at_profile_end) {
    result_.warnings.push_back(
        {WarningClass::profile_end,
         "contact at the end of a profile, or where the rail turns upright"});
  }
  result_.vertical = equilibrium_.vertical;
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
  double follows = 0.0;
  std::optional<GridSolution> coarse;
  if (!request_.position_is_prescribed()) {
    coarse = solve_coarsely(depth);
    if (request_.creep_forces && !request_.grid && request_.accuracy < coarsest_accuracy) {
      settle_planes(*coarse);
    } else {
      follows = share_to_follow(patches_at(depth_found(*coarse)));
    }
    depth = depth_found(*coarse);
  }
  GridSolution solution = solve_finally(depth, follows, std::move(coarse));
  warn_of_solution(solution, request_, wheel_.radius(), ridge_error_, result_);
  warn_of_limit();
  publish(std::move(solution));
  warn_of_patches(request_, result_);
  return std::move(result_);
}

} // namespace

WheelSolution solve_wheel(const WheelSurface& wheel, const RailSurface& rail,
                          const SideEquilibrium& equilibrium, const WheelRequest& request,
                          NormalSolver& solver) {
  return WheelSolver(wheel, rail, equilibrium, request, solver).solve();
}

} // namespace wrc
