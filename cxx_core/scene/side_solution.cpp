#include "scene/side_solution.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "mechanics/displacement_bound.hpp"
#include "mechanics/displacement_operator.hpp"

namespace wrc {
namespace {

/// Elements across the contact of the coarse solutions before a grid given by hand.
constexpr double coarse_resolution = 24.0;
constexpr int coarse_limit = 60;
constexpr int final_limit = 20;
/// Share of the elements across that coarse solutions must reach of those aimed at.
constexpr double least_fill = 0.6;
/// Hertzian contact takes 1/sqrt(2) of the width of virtual penetration.
constexpr double contact_share = 0.7;
/// Room around the place where the last contact lay, in widths of virtual penetration.
constexpr double memory_margin = 0.08;
/// Room left around the contact found on a grid, in that grid's elements.
constexpr double margin_elements = 1.5;
/// By how much an edge that contact touches moves out, in widths of the area.
constexpr double coarse_growth = 0.5;
constexpr double final_growth = 0.15;
/// Overlap beyond the area, in largest displacements, that counts as contact left out ...
constexpr double missed_overlap = 1e-4;
/// ... and the room given to it across, mm: the distance of the scan's nodes.
constexpr double missed_margin = 0.5;
/// A slide by this share of the depth changes pmax by about 1e-4: changes of 0.8 to 1.9 % were
/// measured for slides of 0.17 to 0.42.
constexpr double greatest_slide_share = 2e-3;
/// The coarse depth is settled when it changes by less than this share.
constexpr double coarse_depth_share = 0.02;
/// Contact angle above which distances along the wheelset's axis mislead, rad.
constexpr double vertical_convention_limit = 0.15;
/// Elements across the contact with which an accuracy of 1e-2 starts, across the rail. Profiles are
/// not smooth there, their curvature jumps.
constexpr double first_lateral_resolution = 20.0;
/// Share of the accuracy that goes to the discretisation along the rail, where contact is smooth.
constexpr double longitudinal_share = 0.25;
/// Elements across the contact at which it gives up.
constexpr double last_resolution = 800.0;
/// Refining by less tells too little about the error.
constexpr double refinement = 2.0;
/// Share of the accuracy that estimates aim at when the number of elements is chosen.
constexpr double aimed_share = 0.55;
/// Share of the accuracy that the iteration may take.
constexpr double iteration_share = 0.2;
/// Refining by two should divide the error by four. A gain below the least one twice in a row, or
/// once on a grid that should resolve any smooth contact, is no convergence (a kink of a profile in
/// the contact has no bounded pressure): further grids would be wasted.
constexpr double least_gain = 1.4;
constexpr double resolving_resolution = 90.0;
constexpr int most_failures = 2;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class SideSolver {
public:
  SideSolver(const WheelSurface& wheel, const RailSurface& rail, const SideEquilibrium& equilibrium,
             const SideRequest& request, NormalSolver& solver, SideMemory& memory)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request), solver_(solver),
        memory_(memory) {}

  SideSolution solve();

private:
  [[nodiscard]] bool position_is_prescribed() const { return request_.vertical.has_value(); }
  [[nodiscard]] double prescribed_load() const {
    return request_.normal_load ? *request_.normal_load : request_.vertical_load.value_or(0.0);
  }
  [[nodiscard]] ContactFrame frame_at(double depth) const;
  [[nodiscard]] double first_depth() const;
  /// The rectangle that holds all penetration at a depth.
  [[nodiscard]] PlaneArea penetrated_area(double depth, const ContactFrame& frame) const {
    return area_of(find_penetration_region(equilibrium_.scan, depth), rail_, frame);
  }
  /// `start`: an earlier trial whose pressures are near; none if null.
  Trial try_area(const ContactFrame& frame, const PlaneArea& area, const Mesh& mesh, double depth,
                 double tolerance, const Trial* start);
  [[nodiscard]] NormalSolution solve_normal(const NormalProblem& problem);
  /// The same rectangle of the track, seen in the plane of another frame.
  [[nodiscard]] PlaneArea carried_over(const PlaneArea& area, const ContactFrame& from,
                                       const ContactFrame& to) const;
  [[nodiscard]] Resolution usual_resolution() const;
  [[nodiscard]] Resolution start_resolution() const;
  Trial settle_on_coarse_grids(double depth, const Resolution& resolution);
  /// `resolution` is what to begin with, and then what was needed.
  Trial solve_on_final_grid(const Trial& coarse, Resolution& resolution);
  /// The area that also holds contact which a solution has left out; none if there is none.
  [[nodiscard]] std::optional<PlaneArea> area_with_missed_contact(const Trial& trial) const;
  void warn_about(const Trial& trial);
  void remember(const Trial& trial, const Resolution& resolution);

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  const SideRequest& request_;
  NormalSolver& solver_;
  SideMemory& memory_;
  SideSolution result_;
  double lateral_error_ = 0.0; ///< of the last trial: what elements across the rail leave
};

/// The plane at a depth: through the penetration-weighted place of the rail, at the weighted angle.
ContactFrame SideSolver::frame_at(double depth) const {
  const PenetrationRegion region = find_penetration_region(equilibrium_.scan, depth);
  const double x = equilibrium_.scan.candidates.front().wheel.position.x;
  const Vector3 origin{x, region.mean_y, rail_.graph().at_lateral(region.mean_y).height};
  return request_.gap == GapConvention::tangent
             ? tangent_frame(origin, region.mean_angle)
             : vertical_frame(origin, Rotation(equilibrium_.pose));
}

double SideSolver::first_depth() const {
  if (position_is_prescribed()) {
    return equilibrium_.vertical - *request_.vertical;
  }
  if (memory_.valid) {
    // Hertz: the approach goes with the load to the power of 2/3.
    const double ratio = prescribed_load() / memory_.load;
    return memory_.depth * std::cbrt(ratio * ratio);
  }
  const double angle = equilibrium_.scan.candidates.front().rail_angle;
  const double load =
      request_.normal_load ? *request_.normal_load : *request_.vertical_load / std::cos(angle);
  return estimate_depth(equilibrium_.scan, request_.combined_modulus, load);
}

NormalSolution SideSolver::solve_normal(const NormalProblem& problem) {
  return request_.solver == SolverChoice::paper ? solve_with_polonsky_keer(problem)
                                                : solver_.solve(problem);
}

Trial SideSolver::try_area(const ContactFrame& frame, const PlaneArea& area, const Mesh& mesh,
                           double depth, double tolerance, const Trial* start) {
  Trial trial;
  trial.frame = frame;
  trial.area = area;
  trial.grid = mesh_grid(area, mesh);
  trial.depth = depth;
  const auto remesh_start = Clock::now();
  trial.distance = sample_undeformed_distance(
      {wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - depth}, frame, trial.grid);
  result_.times.remesh += seconds_since(remesh_start);

  const auto mechanics_start = Clock::now();
  NormalProblem problem;
  problem.grid = trial.grid;
  problem.undeformed_distance = trial.distance;
  problem.combined_modulus = request_.combined_modulus;
  const double cosine = frame.normal.z;
  if (position_is_prescribed()) {
    problem.approach = 0.0; // the wheel has been lowered already
  } else {
    problem.normal_load =
        request_.normal_load ? *request_.normal_load : *request_.vertical_load / cosine;
  }
  problem.tolerance = tolerance;
  problem.maximum_iterations = request_.maximum_iterations;
  trial.normal_load = problem.normal_load;
  if (start != nullptr) {
    // Planes differ little: the place along the rail's tangent is all that counts.
    StartPressure near{start->grid, start->normal.pressure};
    const Vector3 shift = start->frame.origin - frame.origin;
    near.grid.lateral_first += dot(shift, frame.lateral);
    near.grid.longitudinal_first += dot(shift, frame.longitudinal);
    problem.start = near;
  }
  trial.normal = solve_normal(problem);
  result_.iterations += trial.normal.iterations;
  trial.contact = summarise_pressure(trial.grid, trial.normal.pressure);
  trial.next_depth = depth + trial.normal.approach / cosine;
  result_.times.mechanics += seconds_since(mechanics_start);
  return trial;
}

PlaneArea SideSolver::carried_over(const PlaneArea& area, const ContactFrame& from,
                                   const ContactFrame& to) const {
  PenetrationRegion region;
  region.y_first = region.x_first = std::numeric_limits<double>::infinity();
  region.y_last = region.x_last = -std::numeric_limits<double>::infinity();
  for (const double lateral : {area.lateral_first, area.lateral_last}) {
    for (const double longitudinal : {area.longitudinal_first, area.longitudinal_last}) {
      const Vector3 place = from.to_track(longitudinal, lateral, 0.0);
      region.y_first = std::min(region.y_first, place.y);
      region.y_last = std::max(region.y_last, place.y);
      region.x_first = std::min(region.x_first, place.x);
      region.x_last = std::max(region.x_last, place.x);
    }
  }
  return area_of(region, rail_, to);
}

Resolution SideSolver::start_resolution() const {
  if (request_.grid) {
    return {2.0 * coarse_resolution, coarse_resolution};
  }
  if (memory_.valid && memory_.accuracy == request_.accuracy) {
    return memory_.resolution;
  }
  return usual_resolution();
}

Resolution SideSolver::usual_resolution() const {
  return {first_lateral_resolution * std::cbrt(1e-2 / request_.accuracy),
          longitudinal_resolution(longitudinal_share * request_.accuracy)};
}

/// Coarse solutions until depth, plane and extent agree with each other.
Trial SideSolver::settle_on_coarse_grids(double depth, const Resolution& resolution) {
  ContactFrame frame = frame_at(depth);
  const PlaneArea penetrated = penetrated_area(depth, frame);
  PlaneArea area = penetrated.widened(0.05);
  Mesh mesh{contact_share * penetrated.width() / resolution.lateral,
            contact_share * penetrated.length() / resolution.longitudinal,
            {}};
  if (memory_.valid) {
    const double width = penetrated.width();
    const double length = penetrated.length();
    mesh.lateral_step = (memory_.lateral_last - memory_.lateral_first) * width / resolution.lateral;
    mesh.longitudinal_step =
        (memory_.longitudinal_last - memory_.longitudinal_first) * length / resolution.longitudinal;
    area = {penetrated.lateral_first + (memory_.lateral_first - memory_margin) * width,
            penetrated.lateral_first + (memory_.lateral_last + memory_margin) * width,
            penetrated.longitudinal_first + (memory_.longitudinal_first - memory_margin) * length,
            penetrated.longitudinal_first + (memory_.longitudinal_last + memory_margin) * length};
  }
  const double tolerance = iteration_share * coarse_depth_share;
  Trial trial;
  for (int attempt = 0; attempt < coarse_limit; ++attempt) {
    trial = try_area(frame, area, mesh, depth,
                     std::min(tolerance, iteration_share * request_.accuracy), nullptr);
    if (trial.no_contact()) {
      area = area.widened(-0.25); // a contact smaller than an element: look closer
      mesh.lateral_step *= 0.5;
      mesh.longitudinal_step *= 0.5;
      continue;
    }
    const bool depth_settled =
        position_is_prescribed() ||
        std::abs(trial.next_depth - depth) <= coarse_depth_share * trial.next_depth;
    const bool filled = trial.rows() >= least_fill * resolution.lateral &&
                        trial.columns() >= least_fill * resolution.longitudinal;
    if (depth_settled && filled && !trial.touches_edge()) {
      break;
    }
    area = trial.touches_edge() ? trial.grown(coarse_growth) : trial.contact_area(margin_elements);
    mesh = trial.mesh_across(resolution);
    if (!depth_settled && trial.next_depth > 0.0) {
      depth = trial.next_depth;
      const ContactFrame next = frame_at(depth);
      area = carried_over(area, frame, next);
      frame = next;
    }
  }
  return trial;
}

/// Contact can be missing where the bodies penetrate beyond the area. Every sample of the scan
/// there is checked with the displacement that the pressures found cause at its place.
std::optional<PlaneArea> SideSolver::area_with_missed_contact(const Trial& trial) const {
  const PenetrationRegion region = find_penetration_region(equilibrium_.scan, trial.depth);
  const PosedPair pair{wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - trial.depth};
  const DisplacementBound bound(trial.grid, trial.normal.pressure, request_.combined_modulus);
  const double largest_displacement =
      bound.at(trial.contact.centroid_longitudinal, trial.contact.centroid_lateral);
  PlaneArea larger = trial.area;
  bool missed = false;
  for (const DistanceSample& sample : equilibrium_.scan.samples) {
    const Vector3 wheel_place = sample.wheel.position;
    const double penetration = trial.depth - (sample.distance + equilibrium_.vertical);
    if (penetration <= 0.0 || wheel_place.y < region.y_first || wheel_place.y > region.y_last) {
      continue;
    }
    const Vector3 place =
        Vector3{wheel_place.x, wheel_place.y, wheel_place.z - sample.distance} - trial.frame.origin;
    const double lateral = dot(place, trial.frame.lateral);
    const double longitudinal = dot(place, trial.frame.longitudinal);
    if (lateral >= trial.area.lateral_first && lateral <= trial.area.lateral_last &&
        longitudinal >= trial.area.longitudinal_first &&
        longitudinal <= trial.area.longitudinal_last) {
      continue;
    }
    const SurfacePlace surfaces = surfaces_at(pair, trial.frame, longitudinal, lateral);
    if (!surfaces.on_rail || !surfaces.on_wheel) {
      continue;
    }
    const double distance = dot(surfaces.wheel - surfaces.rail, trial.frame.normal);
    const double limit = -missed_overlap * largest_displacement;
    if (distance - trial.normal.approach + bound.at(longitudinal, lateral) >= limit) {
      continue;
    }
    const double gap = distance - trial.normal.approach +
                       displacement_at(trial.grid, trial.normal.pressure, request_.combined_modulus,
                                       longitudinal, lateral);
    if (gap < limit) {
      missed = true;
      const double half_length = std::sqrt(2.0 * penetration / sample.wheel.normal_curvature);
      larger.lateral_first = std::min(larger.lateral_first, lateral - missed_margin);
      larger.lateral_last = std::max(larger.lateral_last, lateral + missed_margin);
      larger.longitudinal_first = std::min(larger.longitudinal_first, longitudinal - half_length);
      larger.longitudinal_last = std::max(larger.longitudinal_last, longitudinal + half_length);
    }
  }
  return missed ? std::optional(larger) : std::nullopt;
}

Trial SideSolver::solve_on_final_grid(const Trial& coarse, Resolution& resolution) {
  double depth = position_is_prescribed() ? coarse.depth : coarse.next_depth;
  ContactFrame frame = frame_at(depth);
  PlaneArea area = carried_over(coarse.contact_area(margin_elements), coarse.frame, frame);
  const double tolerance = request_.grid
                               ? request_.tolerance
                               : std::min(request_.tolerance, iteration_share * request_.accuracy);
  int failures = 0;
  Trial coarser = coarse; // what errors are estimated from
  Trial last = coarse;    // whose pressures are the start of the next
  for (int attempt = 0;; ++attempt) {
    Mesh mesh = coarser.mesh_across(resolution);
    mesh.counts = request_.grid;
    Trial trial = try_area(frame, area, mesh, depth, tolerance, &last);
    if (trial.no_contact() || attempt == final_limit) {
      return trial;
    }
    if (trial.touches_edge()) {
      ++result_.regrown;
      area = trial.grown(final_growth);
      last = std::move(trial);
      continue;
    }
    if (const auto larger = area_with_missed_contact(trial)) {
      ++result_.regrown;
      area = *larger;
      last = std::move(trial);
      continue;
    }
    const double slide = std::abs(trial.next_depth - depth) * std::abs(std::sin(frame.angle()));
    const double slide_share = std::min(greatest_slide_share, 2.0 * request_.accuracy);
    if (!position_is_prescribed() && slide > slide_share * trial.next_depth) {
      depth = trial.next_depth;
      const ContactFrame next = frame_at(depth);
      area = carried_over(area, frame, next);
      frame = next;
      last = std::move(trial);
      continue;
    }
    const std::optional<double> before = result_.error_estimate;
    lateral_error_ = estimate_error(coarser, trial, position_is_prescribed());
    const double along_error = longitudinal_error(trial);
    result_.error_estimate = lateral_error_ + along_error;
    const bool reached = *result_.error_estimate <= request_.accuracy;
    const bool failed = before && *result_.error_estimate * least_gain > *before;
    failures = failed ? failures + 1 : 0;
    const bool hopeless =
        failures >= most_failures || (failed && trial.rows() > resolving_resolution);
    if (request_.grid || reached || hopeless || refinement * trial.rows() > last_resolution) {
      return trial;
    }
    resolution = trial.resolution();
    // The larger of the two errors always, the other one if it takes up half of the accuracy.
    const double half = 0.5 * request_.accuracy;
    if (along_error > half || along_error > lateral_error_) {
      resolution.longitudinal *= refinement;
    }
    if (lateral_error_ > half || lateral_error_ >= along_error) {
      resolution.lateral *= refinement;
    }
    area = trial.contact_area(margin_elements);
    last = trial;
    coarser = std::move(trial);
  }
}

void SideSolver::warn_about(const Trial& trial) {
  auto& warnings = result_.warnings;
  if (trial.normal.stop_reason != StopReason::tolerance_met) {
    warnings.push_back("not converged: " + std::string(name_of(trial.normal.stop_reason)) +
                       " after " + std::to_string(trial.normal.iterations) +
                       " iterations, error of the pressures " +
                       text_of(trial.normal.pressure_error));
  }
  if (trial.touches_edge()) {
    warnings.emplace_back("contact touches the edge of the potential contact area");
  }
  if (request_.gap == GapConvention::vertical) {
    const double angle =
        find_penetration_region(equilibrium_.scan, std::max(trial.depth, 1e-9)).mean_angle;
    if (std::abs(angle) > vertical_convention_limit) {
      warnings.push_back("vertical distances at a contact angle of " + text_of(angle) +
                         " rad (good up to " + text_of(vertical_convention_limit) +
                         "): use solve.gap = \"tangent\"");
    }
  }
  if (!request_.grid && (!result_.error_estimate || *result_.error_estimate > request_.accuracy)) {
    warnings.push_back("accuracy " + text_of(request_.accuracy) + " not reached" +
                       (result_.error_estimate
                            ? ": estimated error " + text_of(*result_.error_estimate)
                            : std::string()));
  }
  const PenetrationRegion region = find_penetration_region(equilibrium_.scan, trial.depth);
  if (region.other_regions) {
    warnings.push_back(
        "wheel and rail also meet at s_wheel = " + text_of(region.other_wheel_lateral) +
        " mm under another angle; that patch is not computed");
  }
}

SideSolution SideSolver::solve() {
  if (equilibrium_.scan.candidates.front().at_profile_end) {
    result_.warnings.emplace_back(
        "contact at the end of a profile, or where the rail turns upright");
  }
  result_.vertical = equilibrium_.vertical;
  const double load =
      request_.normal_load ? *request_.normal_load : request_.vertical_load.value_or(1.0);
  const double depth = load > 0.0 ? first_depth() : 0.0;
  if (!(depth > 0.0)) {
    result_.warnings.emplace_back(position_is_prescribed() ? "no contact at this height"
                                                           : "no load");
    return std::move(result_);
  }
  Resolution resolution = start_resolution();
  const Trial coarse =
      settle_on_coarse_grids(depth, {0.5 * resolution.lateral, resolution.longitudinal});
  if (coarse.no_contact()) {
    throw Error(ErrorCode::internal, "no contact found at a depth of " + text_of(depth) + " mm");
  }
  Trial trial = solve_on_final_grid(coarse, resolution);
  remember(trial, resolution);
  warn_about(trial);
  result_.in_contact = !trial.no_contact();
  result_.frame = trial.frame;
  result_.grid = trial.grid;
  result_.depth = trial.depth;
  result_.vertical = equilibrium_.vertical - trial.depth;
  result_.approach = trial.next_depth * trial.frame.normal.z;
  result_.peak_pressure = trial.contact.peak_pressure;
  result_.regions = pressure_regions(trial.grid, trial.normal.pressure);
  result_.undeformed_distance = std::move(trial.distance);
  result_.normal = std::move(trial.normal);
  result_.combined_modulus = request_.combined_modulus;
  if (!position_is_prescribed()) {
    result_.normal_load = trial.normal_load;
  }
  return std::move(result_);
}

void SideSolver::remember(const Trial& trial, const Resolution& resolution) {
  memory_.valid = !trial.no_contact() && !position_is_prescribed();
  if (!memory_.valid) {
    return;
  }
  memory_.depth = trial.next_depth;
  memory_.load = prescribed_load();
  memory_.accuracy = request_.accuracy;
  // Begin the next time with as many elements as are enough, but not with less than half of these.
  const double surplus = std::sqrt(lateral_error_ / (aimed_share * request_.accuracy));
  const double factor = std::clamp(surplus, 0.5, 1.0);
  const Resolution least = usual_resolution();
  memory_.resolution = {std::max(factor * resolution.lateral, least.lateral), least.longitudinal};
  const PlaneArea penetrated = penetrated_area(trial.next_depth, trial.frame);
  const PlaneArea contact = trial.contact_area(0.0);
  memory_.lateral_first = (contact.lateral_first - penetrated.lateral_first) / penetrated.width();
  memory_.lateral_last = (contact.lateral_last - penetrated.lateral_first) / penetrated.width();
  memory_.longitudinal_first =
      (contact.longitudinal_first - penetrated.longitudinal_first) / penetrated.length();
  memory_.longitudinal_last =
      (contact.longitudinal_last - penetrated.longitudinal_first) / penetrated.length();
}

} // namespace

SideSolution solve_side(const WheelSurface& wheel, const RailSurface& rail,
                        const SideEquilibrium& equilibrium, const SideRequest& request,
                        NormalSolver& solver, SideMemory& memory) {
  return SideSolver(wheel, rail, equilibrium, request, solver, memory).solve();
}

NormalProblem problem_of(const SideSolution& solution) {
  NormalProblem problem;
  problem.grid = solution.grid;
  problem.undeformed_distance = solution.undeformed_distance;
  problem.combined_modulus = solution.combined_modulus;
  problem.normal_load = solution.normal_load;
  if (!solution.normal_load) {
    problem.approach = 0.0;
  }
  return problem;
}

} // namespace wrc
