#include "wheel/wheel_solution.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/peak_section.hpp"
#include "accuracy/resolution.hpp"
#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "mechanics/cascade.hpp"
#include "patches/depth_estimate.hpp"
#include "wheel/depth_checks.hpp"
#include "wheel/grid_plan.hpp"

namespace wrc {
namespace {

/// Accuracy whose elements the coarse solution before a grid given by hand has.
constexpr double coarse_accuracy = 1e-2;
/// Of coarse solutions: the depth that the final one starts from is to be a smooth function of the
/// scene.
constexpr double coarse_tolerance = 1e-4;
/// Solutions at other depths or on finer grids before it gives up.
constexpr int max_attempts = 20;
/// The least that a step leaves of the depth.
constexpr double min_depth_ratio = 0.1;
/// Where the step changes by less than this with the depth, the secant would lead astray.
constexpr double min_rate = -0.1;
/// What may be left to be done of a relative change of distances, in accuracies: by coarse
/// solutions, and by the final one. Slopes of forces follow from the depth found: with 0.2 in the
/// final one they differ from sensitivities by 5 per cent under steep angles, with 0.02 by 1, and
/// with 0.01 kinks in the depth that elements of the coarse grid leave show by 1e-6 of the load.
constexpr double max_left = 0.2;
constexpr double max_change = 0.01;
/// Where the rows of a crest make solutions dear, and for pmax alone.
constexpr double max_change_for_crests = 0.5;
/// Contact angle above which distances along the wheelset's axis mislead, rad.
constexpr double vertical_convention_limit = 0.15;
/// Share of the accuracy that the iteration may take. Forces are to be smooth, too, to a thousandth
/// of the accuracy: at a prescribed position the iteration's error is seen in them at once, with
/// the load prescribed only in how patches share it.
constexpr double iteration_share = 0.2;
constexpr double smooth_load_share = 2e-2;
constexpr double smooth_position_share = 3e-3;
/// Share of the accuracy that rounding may take in a pressure; forces are sums, in which it
/// averages out.
constexpr double max_rounding = 0.1;
/// Coarse grids are refined to so many rows at most, until one finds contact.
constexpr std::size_t max_coarse_rows = 1200;
/// Angle by which the rail's surface may turn away from a patch's plane before a warning, rad: the
/// share of the normal that is then taken for vertical is wrong by 2 per cent there.
constexpr double planar_limit = 0.2;

/// The depth by the secant method: along a steep tangent the steps that solutions ask for shrink to
/// a half only. A step counts by how far what it changes exceeds a limit, from nothing at the limit
/// to all at twice it: depths are continuous functions of the scene, whatever the number of steps.
class DepthIteration {
public:
  /// `change`: in limits. None: there is nothing left to be done.
  [[nodiscard]] std::optional<double> next(double depth, double asked, double change) {
    if (!(change > 1.0)) {
      return std::nullopt;
    }
    const double step = asked - depth;
    const double rate = last_step_ != 0.0 ? (step - last_step_) / (depth - last_depth_) : -1.0;
    last_depth_ = depth;
    last_step_ = step;
    const double whole = rate < min_rate ? -step / rate : step;
    return std::max(depth + std::min(2.0 - 2.0 / change, 1.0) * whole, min_depth_ratio * depth);
  }

private:
  double last_depth_ = 0.0;
  double last_step_ = 0.0;
};

/// The pressures of `before` on the grid of a patch, whose plane is nearly the same.
std::vector<double> pressure_at(const PatchOnGrid& patch, const PatchOnGrid& before) {
  const Vector3 moved = before.frame.origin - patch.frame.origin;
  Grid grid = before.grid;
  grid.lateral_first += dot(moved, patch.frame.lateral);
  grid.longitudinal_first += moved.x;
  std::vector<double> pressure;
  refine_pressure(grid, before.pressure, patch.grid, pressure);
  return pressure;
}

class WheelSolver {
public:
  WheelSolver(const WheelSurface& wheel, const RailSurface& rail,
              const SideEquilibrium& equilibrium, const WheelRequest& request, NormalSolver& solver)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request),
        solver_(solver), goal_{request.accuracy, request.position_is_prescribed(),
                               request.elements},
        planner_(rail, equilibrium, request) {}

  WheelSolution solve();

private:
  [[nodiscard]] double first_depth() const;
  /// Planes, grids and undeformed distances at a depth; no pressures yet.
  GridSolution sample(const GridPlan& plan, const ElementCounts& counts);
  /// Which patches interact, and where they lie in their mean plane; none if none do.
  [[nodiscard]] std::optional<PatchInteraction> interaction_of(const GridPlan& plan,
                                                               GridSolution& solution) const;
  /// Starting from the pressures of `before`, if that has as many patches.
  GridSolution solve_at(double depth, const ElementCounts& counts, double tolerance,
                        const GridSolution* before);
  JointSolution solve_joint(const JointProblem& problem);
  /// Relative change of distances within patches, as a share of that of the depth.
  [[nodiscard]] double sliding(const GridSolution& solution) const;
  [[nodiscard]] double depth_found(const GridSolution& solution) const {
    // Not above the first touch, where there is nothing to sample.
    return request_.position_is_prescribed()
               ? solution.depth
               : std::max(solution.depth_found, min_depth_ratio * solution.depth);
  }
  [[nodiscard]] double tolerance() const;
  [[nodiscard]] ElementCounts final_counts() const {
    return request_.grid ? ElementCounts{(*request_.grid)[0], (*request_.grid)[1]}
                         : counts_for(goal_);
  }
  GridSolution solve_coarsely(double depth);
  GridSolution solve_finally(double depth, std::optional<GridSolution> before);
  void find_peaks(GridSolution& solution);
  GridSolution sample_only(double depth);
  void warn_about(const GridSolution& solution);
  void take(GridSolution solution);

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  const WheelRequest& request_;
  NormalSolver& solver_;
  AccuracyGoal goal_;
  GridPlanner planner_;
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
    return iteration_share * request_.accuracy;
  }
  return request_.accuracy *
         (request_.position_is_prescribed() ? smooth_position_share : smooth_load_share);
}

JointSolution WheelSolver::solve_joint(const JointProblem& problem) {
  ++result_.solutions;
  if (request_.solver == SolverChoice::standard || problem.patches.size() > 1) {
    return solver_.solve(problem);
  }
  const PatchGap& patch = problem.patches.front();
  NormalProblem single;
  single.grid = patch.grid;
  single.undeformed_distance = patch.undeformed_distance;
  single.combined_modulus = problem.combined_modulus;
  if (problem.load) {
    single.normal_load = *problem.load / patch.approach_share;
  } else {
    single.approach = *problem.approach * patch.approach_share;
  }
  single.tolerance = problem.tolerance;
  single.maximum_iterations = problem.maximum_iterations;
  single.elements = problem.elements;
  NormalSolution solved = solve_with_polonsky_keer(single);
  JointSolution solution;
  solution.patches.push_back({std::move(solved.pressure), solved.normal_force});
  solution.approach = solved.approach / patch.approach_share;
  solution.iterations = solved.iterations;
  solution.convolutions = solved.iterations;
  solution.stop_reason = solved.stop_reason;
  solution.pressure_error = solved.pressure_error;
  return solution;
}

GridSolution WheelSolver::sample(const GridPlan& plan, const ElementCounts& counts) {
  GridSolution solution;
  solution.elements = request_.elements;
  solution.depth = plan.depth;
  solution.links = plan.found.links;
  solution.left_out_s = plan.left_out_s;
  const Stopwatch remesh_time;
  const PosedPair pair{wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - plan.depth};
  const ContactFrame& main_frame = plan.patches[plan.found.main].frame;
  for (std::size_t k = 0; k < plan.patches.size(); ++k) {
    const PlannedPatch& planned = plan.patches[k];
    PatchOnGrid& patch = solution.patches.emplace_back();
    patch.place = planned.place;
    patch.frame = planned.frame;
    patch.grid = grid_over(planned.area, counts.lateral, counts.longitudinal);
    // Rounding may lift the product of two unit vectors above 1.
    patch.share = request_.normal_load ? std::min(dot(patch.frame.normal, main_frame.normal), 1.0)
                                       : patch.frame.normal.z;
    patch.distance = sample_undeformed_distance(pair, patch.frame, patch.grid);
  }
  result_.times.remesh += remesh_time.seconds();
  return solution;
}

std::optional<PatchInteraction> WheelSolver::interaction_of(const GridPlan& plan,
                                                            GridSolution& solution) const {
  const std::size_t count = solution.patches.size();
  PatchInteraction interaction;
  bool any = false;
  double across = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3 origin = solution.patches[k].frame.origin;
    if (k > 0) {
      const Vector3 step = origin - solution.patches[k - 1].frame.origin;
      across += std::hypot(step.y, step.z);
    }
    interaction.places.push_back({across, origin.x});
    for (std::size_t l = 0; l < count; ++l) {
      const double coupling_weight =
          k == l || request_.interaction ? 1.0 : plan.found.coupling_weight(k, l);
      interaction.coupling_weight.push_back(coupling_weight);
      if (k != l) {
        any = any || coupling_weight > 0.0;
        solution.patches[k].coupling_weight =
            std::max(solution.patches[k].coupling_weight, coupling_weight);
      }
    }
  }
  return any ? std::optional(std::move(interaction)) : std::nullopt;
}

GridSolution WheelSolver::solve_at(double depth, const ElementCounts& counts, double tolerance,
                                   const GridSolution* before) {
  const Stopwatch plan_time;
  const GridPlan plan = planner_.plan(depth);
  result_.times.remesh += plan_time.seconds();
  GridSolution solution = sample(plan, counts);
  const Stopwatch mechanics_time;
  std::vector<PatchGap> gaps;
  const bool starts = before != nullptr && before->patches.size() == solution.patches.size();
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    PatchOnGrid& patch = solution.patches[k];
    if (starts) {
      patch.pressure = pressure_at(patch, before->patches[k]);
    }
    gaps.push_back({patch.grid, patch.distance, patch.share, patch.pressure});
  }
  JointProblem problem;
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
  problem.elements = request_.elements;
  solution.interaction = interaction_of(plan, solution);
  problem.interaction = solution.interaction ? &*solution.interaction : nullptr;
  JointSolution joint = solve_joint(problem);
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    PatchOnGrid& patch = solution.patches[k];
    patch.pressure = std::move(joint.patches[k].pressure);
    patch.normal_force = joint.patches[k].normal_force;
    patch.contact = summarise_pressure(patch.grid, patch.pressure);
  }
  result_.iterations += joint.iterations;
  result_.convolutions += joint.convolutions;
  solution.approach = joint.approach;
  solution.stop_reason = joint.stop_reason;
  solution.pressure_error = joint.pressure_error;
  const ContactFrame& main_frame = plan.patches[plan.found.main].frame;
  solution.depth_found =
      depth + joint.approach / (request_.normal_load ? main_frame.normal.z : 1.0);
  result_.times.mechanics += mechanics_time.seconds();
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
  for (const PatchOnGrid& patch : solution.patches) {
    const auto angle_at = [this](double y) {
      return std::atan(rail_.graph().at_lateral(y).slope());
    };
    const double turn = angle_at(patch.place.y_last) - angle_at(patch.place.y_first);
    most = std::max(most, patch.place.share * std::abs(std::tan(patch.frame.angle()) * turn));
  }
  return most;
}

/// Finds the depth for the load by solutions on few elements, on more only where contact falls
/// between them.
GridSolution WheelSolver::solve_coarsely(double depth) {
  ElementCounts counts = coarse_counts(request_.grid ? coarse_accuracy : request_.accuracy);
  DepthIteration iteration;
  std::optional<GridSolution> before;
  for (int attempt = 1;; ++attempt) {
    GridSolution solution = solve_at(depth, counts, coarse_tolerance, before ? &*before : nullptr);
    if (solution.no_contact()) {
      if (counts.lateral >= max_coarse_rows) {
        throw Error(ErrorCode::internal,
                    "no contact found at a depth of " + text_of(depth) + " mm");
      }
      counts = {2 * counts.lateral, 2 * counts.longitudinal};
      continue;
    }
    const double asked = depth_found(solution);
    const double left = std::abs(asked / depth - 1.0) * std::pow(sliding(solution), 2);
    const auto next = iteration.next(depth, asked, left / (max_left * request_.accuracy));
    if (!next || attempt >= max_attempts) {
      return solution;
    }
    depth = *next;
    before = std::move(solution);
  }
}

/// Largest pressures between the elements of a solution.
void WheelSolver::find_peaks(GridSolution& solution) {
  const Stopwatch stopwatch;
  const PosedPair pair{wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - solution.depth};
  for (PatchOnGrid& patch : solution.patches) {
    if (!patch.no_contact()) {
      const PeakInSection peak =
          peak_in_section(patch, solution.elements, pair, patch.share * solution.approach,
                          request_.combined_modulus, tolerance());
      patch.contact.peak_pressure = peak.pressure;
      patch.peak_error = peak.error;
    }
  }
  result_.times.mechanics += stopwatch.seconds();
}

/// At the depth found, on more elements where the estimate asks for them.
GridSolution WheelSolver::solve_finally(double depth, std::optional<GridSolution> before) {
  ElementCounts counts = final_counts();
  bool finer = false;
  DepthIteration iteration;
  for (int attempt = 1;; ++attempt) {
    GridSolution solution = solve_at(depth, counts, tolerance(), before ? &*before : nullptr);
    if (solution.no_contact() || attempt == max_attempts) {
      mark_unsettled(solution, attempt, result_.warnings);
      return solution;
    }
    const double asked = depth_found(solution);
    const double change = std::abs(asked / depth - 1.0) * sliding(solution);
    const double limit =
        finer && request_.accuracy_of == AccuracyOf::pressures ? max_change_for_crests : max_change;
    if (const auto next = iteration.next(depth, asked, change / (limit * request_.accuracy))) {
      depth = *next;
      before = std::move(solution);
      continue;
    }
    if (request_.accuracy_of == AccuracyOf::pressures) {
      find_peaks(solution);
    }
    const ErrorEstimate error = estimate_error(solution, goal_);
    result_.error_estimate = error.total();
    if (error.total() <= request_.accuracy || request_.grid || finer) {
      return solution;
    }
    counts = refined_counts(counts, error, request_.accuracy);
    finer = true;
    iteration = {};
    depth = asked;
    before = std::move(solution);
  }
}

std::string edge_warning(const PatchOnGrid& patch) {
  const EdgeContact& edge = patch.contact.touches_edge;
  const bool at_neighbour = (edge.lateral_first && std::isfinite(patch.place.limit_first)) ||
                            (edge.lateral_last && std::isfinite(patch.place.limit_last));
  return at_neighbour
             ? "contact reaches the boundary to the neighbouring patch"
             : "contact touches the edge of the grid: elements too large, or a patch just born";
}

void WheelSolver::warn_about(const GridSolution& solution) {
  auto& warnings = result_.warnings;
  warn_of_rounding(solution, request_, wheel_.radius(), warnings);
  if (solution.stop_reason != StopReason::tolerance_met) {
    warnings.push_back("not converged: " + std::string(name_of(solution.stop_reason)) +
                       ", error of the pressures " + short_text_of(solution.pressure_error));
  }
  if (request_.solver == SolverChoice::paper && solution.patches.size() > 1) {
    warnings.emplace_back("several patches: solved together by the default solver");
  }
  for (const PatchOnGrid& patch : solution.patches) {
    if (patch.no_contact()) {
      continue;
    }
    if (patch.contact.touches_edge.any()) {
      warnings.emplace_back(edge_warning(patch));
    }
    const double turn = std::max(std::abs(patch.place.angle_first - patch.frame.angle()),
                                 std::abs(patch.place.angle_last - patch.frame.angle()));
    if (request_.gap == GapConvention::vertical) {
      if (std::abs(patch.place.angle_unturned) > vertical_convention_limit) {
        warnings.push_back("vertical distances at a contact angle of " +
                           short_text_of(patch.place.angle_unturned) + " rad (good up to " +
                           text_of(vertical_convention_limit) + "): use solve.gap = \"tangent\"");
      }
    } else if (turn > planar_limit) {
      warnings.push_back("the rail turns by " + short_text_of(turn) +
                         " rad within a patch (a plane is good up to " + text_of(planar_limit) +
                         ")");
    }
  }
  if (!request_.grid && (!result_.error_estimate || *result_.error_estimate > request_.accuracy)) {
    warnings.push_back("accuracy " + text_of(request_.accuracy) + " not reached" +
                       (result_.error_estimate
                            ? ": estimated error " + short_text_of(*result_.error_estimate)
                            : std::string()));
  }
  if (solution.left_out_s) {
    warnings.push_back(
        "wheel and rail also meet at s_wheel = " + short_text_of(*solution.left_out_s) +
        " mm under another angle; with vertical distances that patch is left out");
  }
}

void WheelSolver::take(GridSolution solution) {
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
    PatchInteraction& taken = result_.interaction.emplace();
    for (const std::size_t k : order) {
      taken.places.push_back(solution.interaction->places[k]);
      for (const std::size_t l : order) {
        taken.coupling_weight.push_back(
            solution.interaction->coupling_weight[k * solution.patches.size() + l]);
      }
    }
  }
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    for (const std::size_t k : planes[plane].patches) {
      PatchOnGrid& patch = solution.patches[k];
      PatchSolution& taken = result_.patches.emplace_back();
      taken.plane = plane;
      taken.approach = patch.overlap(solution.approach);
      taken.place = patch.place;
      taken.frame = patch.frame;
      taken.grid = patch.grid;
      taken.share = patch.share;
      taken.coupling_weight = patch.coupling_weight;
      taken.normal_force = patch.normal_force;
      taken.contact = patch.contact;
      taken.undeformed_distance = std::move(patch.distance);
      taken.pressure = std::move(patch.pressure);
    }
  }
}

/// The potential contact areas of penetration, with the elements that solutions start with.
GridSolution WheelSolver::sample_only(double depth) {
  GridSolution solution = sample(planner_.plan(depth), final_counts());
  for (PatchOnGrid& patch : solution.patches) {
    patch.pressure.assign(patch.grid.element_count(), 0.0);
  }
  solution.depth_found = depth;
  return solution;
}

WheelSolution WheelSolver::solve() {
  result_.solved = request_.until == Module::mechanics;
  if (equilibrium_.scan.candidates.front().at_profile_end) {
    result_.warnings.emplace_back(
        "contact at the end of a profile, or where the rail turns upright");
  }
  result_.vertical = equilibrium_.vertical;
  if (request_.until == Module::geometry) {
    return std::move(result_);
  }
  const double depth =
      request_.position_is_prescribed() || request_.load() > 0.0 ? first_depth() : 0.0;
  if (!is_in_contact(request_, depth, result_.warnings)) {
    return std::move(result_);
  }
  if (request_.until == Module::remesh) {
    take(sample_only(depth));
    return std::move(result_);
  }
  std::optional<GridSolution> coarse;
  if (!request_.position_is_prescribed()) {
    coarse = solve_coarsely(depth);
  }
  const double found = coarse ? depth_found(*coarse) : depth;
  GridSolution solution = solve_finally(found, std::move(coarse));
  warn_about(solution);
  take(std::move(solution));
  return std::move(result_);
}

} // namespace

WheelSolution solve_wheel(const WheelSurface& wheel, const RailSurface& rail,
                          const SideEquilibrium& equilibrium, const WheelRequest& request,
                          NormalSolver& solver) {
  return WheelSolver(wheel, rail, equilibrium, request, solver).solve();
}

} // namespace wrc
