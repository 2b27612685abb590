#include "scene/side_solution.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "error.hpp"
#include "remesh/depth_estimate.hpp"
#include "scene/depth_checks.hpp"
#include "scene/missed_contact.hpp"
#include "scene/side_plan.hpp"

namespace wrc {
namespace {

/// Elements across the contact of the coarse solutions before a grid given by hand.
constexpr double coarse_resolution = 24.0;
constexpr int coarse_limit = 60;
constexpr int final_limit = 20;
/// Share of the elements across that coarse solutions must reach of those aimed at.
constexpr double least_fill = 0.6;
/// By how much an edge that contact touches moves out, in widths of the area.
constexpr double coarse_growth = 0.5;
constexpr double final_growth = 0.15;
/// What a step leaves of the depth at least.
constexpr double least_depth_left = 0.1;
/// A slide by this share of the depth changes pmax by about 1e-4: changes of 0.8 to 1.9 % were
/// measured for slides of 0.17 to 0.42.
constexpr double greatest_slide_share = 2e-3;
/// Where patches are about to join, a change of their closeness by 1 changes depth and pmax by up
/// to about 0.1, and the change of depth the closeness again, up to twice that in all: in shares of
/// the accuracy this is the greatest change left.
constexpr double greatest_closeness_change = 2.0;
/// What is left of a change of the share of the normal that is vertical, in planes that have turned
/// towards each other, in shares of the accuracy.
constexpr double greatest_share_change = 0.5;
/// The share of a change of depth that comes back as another one, the greatest believed ...
constexpr double greatest_feedback = 0.8;
/// ... and the least relative change of depth that tells it.
constexpr double telling_change = 1e-4;
/// The coarse depth is settled when it changes by less than this share.
constexpr double coarse_depth_share = 0.02;
/// Contact angle above which distances along the wheelset's axis mislead, rad.
constexpr double vertical_convention_limit = 0.15;
/// Elements across the contact with which an accuracy of 1e-2 starts, across the rail. Profiles are
/// not smooth there, their curvature jumps.
constexpr double first_lateral_resolution = 24.0;
/// Grids are no coarser than this accuracy asks for: with fewer elements pmax changes by chance
/// from step to step, which costs a moving wheel more new starts than it saves, and one run in ten
/// is worse than asked (docs/accuracy.md).
constexpr double coarsest_accuracy = 1e-2;
/// Share of the accuracy that goes to the discretisation along the rail, where contact is smooth.
constexpr double longitudinal_share = 0.4;
/// Elements across the contact at which it gives up.
constexpr double last_resolution = 800.0;
/// Refining by less tells too little about the error.
constexpr double refinement = 2.0;
/// Along the rail, where a law tells the error, refinement may be less, but not less than this.
constexpr double least_along = 1.1;
/// Share of the accuracy that the iteration may take.
constexpr double iteration_share = 0.2;
/// Share of the iteration's tolerance that rounding may take: a twentieth of the accuracy.
constexpr double accuracy_rounding_share = 0.25;
/// Refining by two should divide the error by four. A gain below the least one twice in a row, or
/// once on a grid that should resolve any smooth contact, is no convergence (a kink of a profile in
/// the contact has no bounded pressure): further grids would be wasted.
constexpr double least_gain = 1.4;
constexpr double resolving_resolution = 90.0;
constexpr int most_failures = 2;
/// Attempts with what is remembered before the side is solved anew. Where the wheel slid in the
/// last step it will again: the first attempt then only finds the depth, to so many tolerances.
constexpr int warm_limit = 3;
constexpr double depth_tolerance = 10.0;
/// A patch with less pressure than the largest needs fewer elements: errors fall with their square.
constexpr double least_resolution_share = 0.35;
/// Angle by which the rail's surface may turn away from a patch's plane before a warning, rad: the
/// share of the normal that is then taken for vertical is wrong by 2 per cent there.
constexpr double planar_limit = 0.2;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class SideSolver {
public:
  SideSolver(const WheelSurface& wheel, const RailSurface& rail, const SideEquilibrium& equilibrium,
             const SideRequest& request, NormalSolver& solver, SideMemory& memory)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request), solver_(solver),
        memory_(memory), planner_(rail, equilibrium, request) {}

  SideSolution solve();

private:
  [[nodiscard]] double first_depth() const;
  /// `starts`: pressures near the answer for each patch, in its plane; empty if there are none.
  Trial try_plan(const SidePlan& plan, double tolerance,
                 const std::vector<std::optional<StartPressure>>& starts);
  /// The grids of a plan and the undeformed distances on them; no pressures yet.
  Trial sample(const SidePlan& plan);
  JointSolution solve_joint(const JointProblem& problem);
  /// Contact touches an edge that can still move.
  [[nodiscard]] bool must_grow(const Trial& trial) const;
  /// On a grid given by hand contact of one or two elements may touch the edge because they are
  /// large: a larger area would make them larger still. Coarse solutions have settled it before.
  [[nodiscard]] double least_grown_elements() const { return request_.grid ? 3.0 : 0.0; }
  [[nodiscard]] bool slides(const Trial& trial) const;
  [[nodiscard]] bool changes_closeness(const Trial& trial) const;
  /// The depth to try after a trial.
  double improved_depth(const Trial& trial);
  [[nodiscard]] Resolution usual_resolution() const;
  [[nodiscard]] Resolution start_resolution() const;
  /// For each patch of a trial, from those of the patch with the largest pressure.
  [[nodiscard]] std::vector<Resolution> by_patch(const Trial& trial,
                                                 const Resolution& resolution) const;
  /// The accuracy that grids are made for; met is the one asked.
  [[nodiscard]] double grid_accuracy() const {
    return std::min(request_.accuracy, coarsest_accuracy);
  }
  [[nodiscard]] double tolerance() const {
    return request_.grid ? request_.tolerance : iteration_share * grid_accuracy();
  }
  Trial sample_penetration(double depth);
  Trial settle_on_coarse_grids(double depth, const Resolution& resolution);
  Trial solve_on_final_grid(Trial coarse_trial, const Resolution& resolution);
  /// The solution on the grids that were enough the last time; none if more has changed.
  std::optional<Trial> solve_as_before(double depth);
  bool add_missed(const Trial& trial, SidePlan& plan) const {
    return add_missed_contact(wheel_, rail_, equilibrium_, planner_, request_.combined_modulus,
                              request_.elements, trial, plan);
  }
  void warn_about(const Trial& trial);
  void take(Trial trial);

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  const SideRequest& request_;
  NormalSolver& solver_;
  SideMemory& memory_;
  SidePlanner planner_;
  SideSolution result_;
  /// What improved_depth knows of the last trial: depths and number of patches.
  double told_depth_ = 0.0;
  double told_next_ = 0.0;
  std::size_t told_patches_ = 0;
  double feedback_ = 0.0;           ///< of a change of depth on the next one
  std::optional<TrialError> error_; ///< of the last trial; none if its grid was a remembered one
};

double SideSolver::first_depth() const {
  if (request_.position_is_prescribed()) {
    return equilibrium_.vertical - *request_.vertical;
  }
  if (memory_.valid) {
    return memory_.expected_depth(request_.load(), equilibrium_.pose.lateral);
  }
  return estimate_depth(equilibrium_.scan, request_.combined_modulus, request_.load(),
                        request_.normal_load ? LoadDirection::main_normal
                                             : LoadDirection::vertical);
}

JointSolution SideSolver::solve_joint(const JointProblem& problem) {
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

/// The pressures of an earlier trial, where they were on the rail.
std::vector<std::optional<StartPressure>> starts_from(const Trial& trial, const SidePlan& plan) {
  std::vector<std::optional<StartPressure>> starts;
  for (const PatchPlan& patch : plan.patches) {
    const PatchTrial* near = trial.matching(patch.place);
    auto& start = starts.emplace_back();
    if (near != nullptr) {
      // Planes differ little: the place along the rail's tangent is all that counts.
      start = {near->grid, near->pressure};
      const Vector3 shift = near->frame.origin - patch.frame.origin;
      start->grid.lateral_first += dot(shift, patch.frame.lateral);
      start->grid.longitudinal_first += dot(shift, patch.frame.longitudinal);
    }
  }
  return starts;
}

Trial SideSolver::sample(const SidePlan& plan) {
  Trial trial;
  trial.elements = request_.elements;
  trial.depth = plan.depth;
  trial.links = plan.found.links;
  trial.left_out_s = plan.left_out_s;
  const auto remesh_start = Clock::now();
  const PosedPair pair{wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - plan.depth};
  const ContactFrame& main_frame = plan.patches[plan.found.main].frame;
  for (const PatchPlan& patch : plan.patches) {
    PatchTrial& made = trial.patches.emplace_back();
    made.place = patch.place;
    made.frame = patch.frame;
    made.area = patch.area;
    made.grid = mesh_grid(patch.area, patch.mesh,
                          edges_at_boundary(patch.area, patch.place, rail_, patch.frame));
    // Rounding may lift the product of two unit vectors above 1.
    made.share = request_.normal_load ? std::min(dot(patch.frame.normal, main_frame.normal), 1.0)
                                      : patch.frame.normal.z;
    made.distance = sample_undeformed_distance(pair, patch.frame, made.grid);
  }
  result_.times.remesh += seconds_since(remesh_start);
  return trial;
}

Trial SideSolver::try_plan(const SidePlan& plan, double tolerance,
                           const std::vector<std::optional<StartPressure>>& starts) {
  Trial trial = sample(plan);
  const auto mechanics_start = Clock::now();
  std::vector<PatchGap> gaps;
  for (const PatchTrial& patch : trial.patches) {
    PatchGap& gap = gaps.emplace_back();
    gap.grid = patch.grid;
    gap.undeformed_distance = patch.distance;
    gap.approach_share = patch.share;
    if (!starts.empty()) {
      gap.start = starts[gaps.size() - 1];
    }
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
    problem.rounding_share = accuracy_rounding_share;
  }
  problem.maximum_iterations = request_.maximum_iterations;
  problem.elements = request_.elements;
  PatchInteraction interaction;
  if (trial.patches.size() > 1) {
    const std::size_t count = trial.patches.size();
    bool any = false;
    double across = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3 origin = trial.patches[k].frame.origin;
      if (k > 0) {
        const Vector3 step = origin - trial.patches[k - 1].frame.origin;
        across += std::hypot(step.y, step.z);
      }
      interaction.places.push_back({across, origin.x});
      for (std::size_t l = 0; l < count; ++l) {
        const double closeness = k == l || request_.interaction ? 1.0 : plan.found.closeness(k, l);
        interaction.closeness.push_back(closeness);
        if (k != l) {
          any = any || closeness > 0.0;
          trial.patches[k].closeness = std::max(trial.patches[k].closeness, closeness);
        }
      }
    }
    problem.interaction = any ? &interaction : nullptr;
  }
  JointSolution solution = solve_joint(problem);
  for (std::size_t k = 0; k < trial.patches.size(); ++k) {
    PatchTrial& patch = trial.patches[k];
    patch.pressure = std::move(solution.patches[k].pressure);
    patch.normal_force = solution.patches[k].normal_force;
    patch.contact = summarise_pressure(patch.grid, patch.pressure);
  }
  if (problem.interaction != nullptr) {
    trial.interaction = std::move(interaction);
  }
  result_.iterations += solution.iterations;
  result_.convolutions += solution.convolutions;
  trial.approach = solution.approach;
  trial.stop_reason = solution.stop_reason;
  trial.pressure_error = solution.pressure_error;
  const ContactFrame& main_frame = plan.patches[plan.found.main].frame;
  const double along = request_.normal_load ? main_frame.normal.z : 1.0;
  trial.next_depth = plan.depth + solution.approach / along;
  result_.times.mechanics += seconds_since(mechanics_start);
  return trial;
}

Resolution SideSolver::start_resolution() const {
  if (request_.grid) {
    return {2.0 * coarse_resolution, coarse_resolution};
  }
  Resolution resolution = usual_resolution();
  if (memory_.valid && memory_.accuracy == request_.accuracy) {
    for (const SideMemory::Patch& patch : memory_.patches) {
      resolution.lateral = std::max(resolution.lateral, patch.resolution.lateral);
    }
  }
  return resolution;
}

Resolution SideSolver::usual_resolution() const {
  return {first_lateral_resolution * std::sqrt(std::sqrt(1e-2 / grid_accuracy())),
          longitudinal_resolution(longitudinal_share * grid_accuracy(), 1.0, request_.elements)};
}

std::vector<Resolution> SideSolver::by_patch(const Trial& trial,
                                             const Resolution& resolution) const {
  std::vector<Resolution> resolutions;
  for (const PatchTrial& patch : trial.patches) {
    Resolution wanted = resolution;
    if (!request_.grid && !patch.no_contact()) {
      wanted.longitudinal = std::max(
          wanted.longitudinal, longitudinal_resolution(longitudinal_share * grid_accuracy(),
                                                       patch.slenderness(), request_.elements));
    }
    resolutions.push_back(
        wanted.times(std::clamp(std::sqrt(trial.weight(patch)), least_resolution_share, 1.0)));
  }
  return resolutions;
}

bool SideSolver::must_grow(const Trial& trial) const {
  return std::any_of(trial.patches.begin(), trial.patches.end(), [this](const PatchTrial& patch) {
    if (!patch.touches_edge()) {
      return false;
    }
    const PlaneArea larger = planner_.limited(patch.grown(final_growth, least_grown_elements()),
                                              {patch.place, patch.frame, patch.area, {}});
    const double least = 0.5 * patch.grid.lateral_step;
    return larger.width() > patch.area.width() + least ||
           larger.length() > patch.area.length() * (1.0 + 1e-9);
  });
}

/// Whether the wheel would slide along the tangent by too much on its way to the depth found.
bool SideSolver::slides(const Trial& trial) const {
  if (request_.position_is_prescribed()) {
    return false;
  }
  double sine = 0.0;
  for (const PatchTrial& patch : trial.patches) {
    if (!patch.no_contact()) {
      sine = std::max(sine, trial.weight(patch) * std::abs(std::sin(patch.frame.angle())));
    }
  }
  const double share = std::min(greatest_slide_share, 2.0 * request_.accuracy);
  return std::abs(trial.next_depth - trial.depth) * sine > share * trial.next_depth;
}

/// Whether patches would be closer to each other, or less close, at the depth found, or planes that
/// have turned towards each other be turned otherwise.
bool SideSolver::changes_closeness(const Trial& trial) const {
  if (request_.position_is_prescribed() || !(trial.next_depth > 0.0) ||
      !(trial.has_close_patches() || trial.has_turned_planes())) {
    return false;
  }
  const ContactPatches found = planner_.patches_at(trial.next_depth);
  const auto holder = [&found](const ContactPatch& place) {
    const auto patch =
        std::find_if(found.patches.begin(), found.patches.end(),
                     [&place](const ContactPatch& candidate) { return candidate.holds(place); });
    return static_cast<std::size_t>(patch - found.patches.begin());
  };
  for (std::size_t k = 0; k < trial.patches.size(); ++k) {
    const PatchTrial& patch = trial.patches[k];
    const std::size_t here = holder(patch.place);
    if (here == found.patches.size()) {
      continue;
    }
    const double share_change = std::cos(found.patches[here].angle) - std::cos(patch.place.angle);
    if (patch.place.angle != patch.place.own_angle &&
        trial.weight(patch) * std::abs(share_change) > greatest_share_change * request_.accuracy) {
      return true;
    }
    const std::size_t next =
        k < trial.links.size() ? holder(trial.patches[k + 1].place) : found.patches.size();
    if (next < found.patches.size() && std::abs(found.closeness(here, next) - trial.links[k]) >
                                           greatest_closeness_change * request_.accuracy) {
      return true;
    }
  }
  return false;
}

/// The depth that the solution asks for; where closeness grows with depth and depth with closeness,
/// further on, by the feedback that the last two trials have shown.
double SideSolver::improved_depth(const Trial& trial) {
  const double change = trial.depth - told_depth_;
  if (!trial.has_close_patches() || trial.patches.size() != told_patches_) {
    feedback_ = 0.0;
  } else if (std::abs(change) > telling_change * trial.depth) {
    feedback_ = std::clamp((trial.next_depth - told_next_) / change, 0.0, greatest_feedback);
  }
  told_depth_ = trial.depth;
  told_next_ = trial.next_depth;
  told_patches_ = trial.patches.size();
  const double improved = trial.depth + (trial.next_depth - trial.depth) / (1.0 - feedback_);
  // Not above the first touch, where there is nothing to sample.
  return std::max(improved, least_depth_left * trial.depth);
}

/// Coarse solutions until depth, planes and extents agree with each other.
Trial SideSolver::settle_on_coarse_grids(double depth, const Resolution& resolution) {
  const bool from_memory = memory_.valid && !request_.grid;
  SidePlan plan = planner_.first_plan(depth, resolution);
  if (from_memory && memory_.patches.size() == plan.patches.size()) {
    plan = planner_.remembered_plan(memory_, depth);
    for (PatchPlan& patch : plan.patches) {
      patch.mesh.lateral_step *= 2.0;
    }
  }
  const double coarse_tolerance =
      std::min(iteration_share * coarse_depth_share, iteration_share * grid_accuracy());
  Trial trial;
  for (int attempt = 0; attempt < coarse_limit; ++attempt) {
    trial = try_plan(plan, coarse_tolerance, {});
    check_depth_found(request_, trial.next_depth); // before planes are turned and areas grown there
    if (trial.no_contact()) {
      for (PatchPlan& patch : plan.patches) { // contact smaller than an element: look closer
        patch.area = patch.area.widened(-0.25);
        patch.mesh.lateral_step *= 0.5;
        patch.mesh.longitudinal_step *= 0.5;
      }
      continue;
    }
    const bool depth_settled =
        request_.position_is_prescribed() ||
        (std::abs(trial.next_depth - depth) <= coarse_depth_share * trial.next_depth &&
         !changes_closeness(trial));
    const std::vector<Resolution> resolutions = by_patch(trial, resolution);
    bool filled = true;
    for (std::size_t k = 0; k < trial.patches.size(); ++k) {
      const PatchTrial& patch = trial.patches[k];
      filled = filled && (patch.no_contact() ||
                          (patch.rows() >= least_fill * resolutions[k].lateral &&
                           patch.columns() >= least_fill * resolutions[k].longitudinal));
    }
    if (depth_settled && filled && !must_grow(trial)) {
      break;
    }
    if (!depth_settled) {
      depth = improved_depth(trial);
    }
    plan = planner_.next_plan(trial, depth, resolutions, coarse_growth);
  }
  return trial;
}

Trial SideSolver::solve_on_final_grid(Trial coarse_trial, const Resolution& resolution) {
  // What errors are estimated from, and whose pressures are the start of the next.
  auto coarser = std::make_shared<const Trial>(std::move(coarse_trial));
  std::shared_ptr<const Trial> last = coarser;
  const double depth = request_.position_is_prescribed()
                           ? coarser->depth
                           : std::max(coarser->next_depth, least_depth_left * coarser->depth);
  std::vector<Resolution> resolutions = by_patch(*coarser, resolution);
  SidePlan plan = planner_.next_plan(*coarser, depth, resolutions, final_growth);
  int failures = 0;
  for (int attempt = 0;; ++attempt) {
    for (PatchPlan& patch : plan.patches) {
      patch.mesh.counts = request_.grid;
    }
    Trial trial = try_plan(plan, tolerance(), starts_from(*last, plan));
    if (trial.no_contact() || attempt == final_limit) {
      mark_unsettled(trial, attempt + 1, result_.warnings);
      return trial;
    }
    if (must_grow(trial)) {
      ++result_.regrown;
      for (std::size_t k = 0; k < plan.patches.size(); ++k) {
        plan.patches[k].area = planner_.limited(
            trial.patches[k].grown(final_growth, least_grown_elements()), plan.patches[k]);
      }
      last = std::make_shared<const Trial>(std::move(trial));
      continue;
    }
    if (add_missed(trial, plan)) {
      ++result_.regrown;
      last = std::make_shared<const Trial>(std::move(trial));
      continue;
    }
    if (slides(trial) || changes_closeness(trial)) {
      // The same areas and meshes at the other depth.
      const double other_depth = improved_depth(trial);
      SidePlan next = planner_.empty_plan(other_depth);
      if (next.patches.size() == plan.patches.size()) {
        for (std::size_t k = 0; k < plan.patches.size(); ++k) {
          next.patches[k].area =
              planner_.limited(planner_.carried_over(plan.patches[k].area, plan.patches[k].frame,
                                                     next.patches[k].frame),
                               next.patches[k]);
          next.patches[k].mesh = plan.patches[k].mesh;
        }
      } else {
        next = planner_.next_plan(trial, other_depth, by_patch(trial, resolution), final_growth);
      }
      plan = std::move(next);
      last = std::make_shared<const Trial>(std::move(trial));
      continue;
    }
    const std::optional<double> before = result_.error_estimate;
    // An error of the depth changes the closeness of patches, and that the depth again.
    const double amplification = 1.0 / (1.0 - feedback_);
    const double across_error =
        amplification * std::max(estimate_error(*coarser, trial, request_.position_is_prescribed()),
                                 narrow_error(trial));
    const double along_error = amplification * longitudinal_error(trial);
    error_ = TrialError{across_error, across_error + along_error};
    result_.error_estimate = error_->total;
    const bool reached = error_->total <= request_.accuracy;
    const bool failed = before && error_->total * least_gain > *before;
    failures = failed ? failures + 1 : 0;
    double rows = 0.0;
    for (const PatchTrial& patch : trial.patches) {
      rows = std::max(rows, patch.rows());
    }
    const bool hopeless = failures >= most_failures || (failed && rows > resolving_resolution);
    if (request_.grid || reached || hopeless || refinement * rows > last_resolution) {
      return trial;
    }
    // The larger of the two errors always, the other one if it takes up half of the accuracy.
    const double half = 0.5 * request_.accuracy;
    const bool finer_along = along_error > half || along_error > across_error;
    const bool finer_across = across_error > half || across_error >= along_error;
    // Along the rail the law of the error tells how many are needed.
    const double along_refinement = std::clamp(
        std::sqrt(along_error / (longitudinal_share * grid_accuracy())), least_along, refinement);
    resolutions.clear();
    for (const PatchTrial& patch : trial.patches) {
      const Resolution now = patch.no_contact() ? resolution : patch.resolution();
      resolutions.push_back({now.lateral * (finer_across ? refinement : 1.0),
                             now.longitudinal * (finer_along ? along_refinement : 1.0)});
    }
    plan = planner_.next_plan(trial, trial.depth, resolutions, final_growth);
    coarser = std::make_shared<const Trial>(std::move(trial));
    last = coarser;
  }
}

std::optional<Trial> SideSolver::solve_as_before(double depth) {
  if (!memory_.valid || !memory_.error_estimate || request_.grid ||
      memory_.accuracy != request_.accuracy) {
    return std::nullopt;
  }
  std::optional<Trial> last; // at another depth
  const bool only_depth_first = memory_.slid;
  for (int attempt = 0; attempt < warm_limit; ++attempt) {
    const SidePlan plan = planner_.remembered_plan(memory_, depth);
    if (!memory_.places_are_near(plan.patches)) {
      return std::nullopt;
    }
    const bool only_depth = only_depth_first && attempt == 0;
    Trial trial = try_plan(plan, (only_depth ? depth_tolerance : 1.0) * tolerance(),
                           last ? starts_from(*last, plan) : memory_.starts());
    if (trial.no_contact() || trial.touches_edge() || narrow_error(trial) > request_.accuracy) {
      return std::nullopt;
    }
    SidePlan checked = plan;
    if (add_missed(trial, checked)) {
      return std::nullopt;
    }
    if (!memory_.estimate_holds(trial)) {
      return std::nullopt;
    }
    const bool settled = !slides(trial) && !changes_closeness(trial);
    memory_.slid = attempt == 0 ? !settled : memory_.slid;
    if (settled && !only_depth) {
      result_.error_estimate = memory_.error_estimate;
      return trial;
    }
    depth = improved_depth(trial);
    last = std::move(trial);
  }
  return std::nullopt;
}

void SideSolver::warn_about(const Trial& trial) {
  auto& warnings = result_.warnings;
  warn_of_rounding(trial, request_, wheel_.radius(), warnings);
  if (trial.stop_reason != StopReason::tolerance_met) {
    warnings.push_back("not converged: " + std::string(name_of(trial.stop_reason)) +
                       ", error of the pressures " + short_text_of(trial.pressure_error));
  }
  if (request_.solver == SolverChoice::paper && trial.patches.size() > 1) {
    warnings.emplace_back("several patches: solved together by the default solver");
  }
  if (slides(trial)) {
    warnings.push_back("the height does not settle with these elements: distances were sampled at "
                       "a depth of " +
                       short_text_of(trial.depth) + " mm, the solution asks for " +
                       short_text_of(trial.next_depth) + " mm");
  }
  for (const PatchTrial& patch : trial.patches) {
    if (patch.no_contact()) {
      continue;
    }
    if (patch.touches_edge()) {
      const double elements = std::min(patch.rows(), patch.columns());
      warnings.emplace_back(
          must_grow(trial) ? "contact touches the edge of the potential contact area"
          : elements < least_grown_elements()
              ? "contact of one or two elements touches the edge of the grid: they are too large"
              : "contact reaches the boundary to the neighbouring patch");
    }
    const double turn = std::max(std::abs(patch.place.angle_first - patch.frame.angle()),
                                 std::abs(patch.place.angle_last - patch.frame.angle()));
    if (request_.gap == GapConvention::vertical) {
      if (std::abs(patch.place.own_angle) > vertical_convention_limit) {
        warnings.push_back("vertical distances at a contact angle of " +
                           short_text_of(patch.place.own_angle) + " rad (good up to " +
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
  if (trial.left_out_s) {
    warnings.push_back("wheel and rail also meet at s_wheel = " + short_text_of(*trial.left_out_s) +
                       " mm under another angle; with vertical distances that patch is left out");
  }
}

/// Patches that share a plane.
struct PlanePatches {
  std::vector<std::size_t> patches; ///< of a trial, largest normal force first
  double normal_force = 0.0;
};

/// Largest normal force first; without the patches that do not touch, if there are pressures.
std::vector<PlanePatches> patches_by_plane(const Trial& trial, bool solved) {
  std::vector<PlanePatches> planes;
  bool begins = true;
  for (std::size_t k = 0; k < trial.patches.size(); ++k) {
    const PatchTrial& patch = trial.patches[k];
    begins = begins || !patch.place.with_last;
    if (solved && patch.no_contact()) {
      continue;
    }
    if (begins) {
      planes.emplace_back();
    }
    begins = false;
    planes.back().patches.push_back(k);
    planes.back().normal_force += patch.normal_force;
  }
  for (PlanePatches& plane : planes) {
    std::stable_sort(plane.patches.begin(), plane.patches.end(),
                     [&trial](std::size_t one, std::size_t other) {
                       return trial.patches[one].normal_force > trial.patches[other].normal_force;
                     });
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const PlanePatches& one, const PlanePatches& other) {
                     return one.normal_force > other.normal_force;
                   });
  return planes;
}

void SideSolver::take(Trial trial) {
  result_.in_contact = !result_.solved || !trial.no_contact();
  result_.depth = trial.depth;
  result_.approach = trial.approach;
  result_.next_depth = trial.next_depth;
  result_.vertical = equilibrium_.vertical - trial.depth;
  result_.peak_pressure = trial.peak_pressure();
  result_.combined_modulus = request_.combined_modulus;
  result_.elements = request_.elements;
  result_.gap = request_.gap;
  result_.joining_distance = request_.joining_distance;
  result_.stop_reason = trial.stop_reason;
  if (!request_.position_is_prescribed()) {
    result_.load = request_.load();
  }
  const std::vector<PlanePatches> planes = patches_by_plane(trial, result_.solved);
  std::vector<std::size_t> order;
  for (const PlanePatches& plane : planes) {
    order.insert(order.end(), plane.patches.begin(), plane.patches.end());
  }
  if (trial.interaction) {
    PatchInteraction& taken = result_.interaction.emplace();
    for (const std::size_t k : order) {
      taken.places.push_back(trial.interaction->places[k]);
      for (const std::size_t l : order) {
        taken.closeness.push_back(trial.interaction->closeness[k * trial.patches.size() + l]);
      }
    }
  }
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    for (const std::size_t k : planes[plane].patches) {
      PatchTrial& patch = trial.patches[k];
      PatchSolution& taken = result_.patches.emplace_back();
      taken.plane = plane;
      taken.approach = patch.overlap(trial.approach);
      taken.place = patch.place;
      taken.frame = patch.frame;
      taken.grid = patch.grid;
      taken.share = patch.share;
      taken.closeness = patch.closeness;
      taken.normal_force = patch.normal_force;
      taken.contact = patch.contact;
      taken.undeformed_distance = std::move(patch.distance);
      taken.pressure = std::move(patch.pressure);
    }
  }
}

/// The potential contact areas of penetration, with the elements that solutions start with.
Trial SideSolver::sample_penetration(double depth) {
  SidePlan plan = planner_.first_plan(depth, usual_resolution());
  for (PatchPlan& patch : plan.patches) {
    patch.mesh.counts = request_.grid;
  }
  Trial trial = sample(plan);
  for (PatchTrial& patch : trial.patches) {
    patch.pressure.assign(patch.grid.element_count(), 0.0);
  }
  trial.next_depth = depth;
  return trial;
}

SideSolution SideSolver::solve() {
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
    take(sample_penetration(depth));
    return std::move(result_);
  }
  std::optional<Trial> trial = solve_as_before(depth);
  const bool as_before = trial.has_value();
  if (!trial) {
    const Resolution resolution = start_resolution();
    Trial coarse =
        settle_on_coarse_grids(depth, {0.5 * resolution.lateral, resolution.longitudinal});
    if (coarse.no_contact()) {
      throw Error(ErrorCode::internal, "no contact found at a depth of " + text_of(depth) + " mm");
    }
    trial = solve_on_final_grid(std::move(coarse), resolution);
    check_depth_found(request_, trial->next_depth);
  }
  memory_.remember(rail_, request_, equilibrium_.pose.lateral, *trial, error_, as_before,
                   grid_accuracy());
  warn_about(*trial);
  take(std::move(*trial));
  return std::move(result_);
}

} // namespace

SideSolution solve_side(const WheelSurface& wheel, const RailSurface& rail,
                        const SideEquilibrium& equilibrium, const SideRequest& request,
                        NormalSolver& solver, SideMemory& memory) {
  return SideSolver(wheel, rail, equilibrium, request, solver, memory).solve();
}

} // namespace wrc
