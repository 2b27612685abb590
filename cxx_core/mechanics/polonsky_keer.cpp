/// Conjugate gradients with an active set on the full grid: the paper's method, the baseline.
///
/// Polonsky & Keer, Wear 231 (1999) 206-219, section 3, with the convolution of
/// displacement_operator.hpp. Each iteration takes two convolutions as the original does: one for
/// the gap, one for the direction. Departures from the original, all named:
///  - it stops when the update sum|p - p_old|/sum p AND the complementarity error of the same
///    pressures (largest |g| in contact, largest overlap outside, relative to the largest u) are at
///    or below the tolerance, since the update alone understates the error by two orders;
///    Pressures are then off by 5 to 70 tolerances relative to the peak (measured up to 154
///    elements across), since rough errors of p move the surface little;
///  - it stops as stagnated when no better pressures came up for `polonsky_keer_stagnation_window`
///  iterations,
///    and hands back the best it saw;
///  - a direction along which the energy does not fall is replaced by the steepest descent;
///  - when contact is even or empty but overlap remains, a Jacobi-like step opens new contact;
///  - a prescribed approach: no mean removal, no scaling to the load.
/// Inside, lengths are counted in longitudinal steps, the modulus is 1 and pressures are of the
/// order of 1, so that the units and the size of a problem do not matter.

#include "mechanics/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "half_space/displacement_operator.hpp"
#include "mechanics/constants.hpp"

namespace wrc {

namespace {

/// The problem without dimensions: distances from the least one, modulus 1, longitudinal step 1.
struct DimensionlessProblem {
  Grid grid;
  std::vector<double> distance;
  std::vector<double> shares; ///< of the approach, by element
  bool load_prescribed;
  Elements elements;
  std::span<const double> angles; ///< of rows along a curve
  double load = 0.0;              ///< sum of share times pressure, found when it is prescribed
  double approach = 0.0;          ///< given when it is prescribed
  double pressure_scale = 0.0;    ///< MPa for pressure 1
};

struct DimensionlessResult {
  std::vector<double> pressure;
  int iterations;
  StopReason stop_reason;
};

double sum_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum;
}

/// sqrt(s level - h) where positive: the shape of a Hertzian pressure over the penetrated elements.
/// Evenly spread over h <= s level where nothing lies below the level (a punch).
std::vector<double> start_shape(const DimensionlessProblem& problem, double level) {
  const std::vector<double>& distance = problem.distance;
  std::vector<double> shape(distance.size());
  for (std::size_t index = 0; index < shape.size(); ++index) {
    shape[index] = std::sqrt(std::max(0.0, level * problem.shares[index] - distance[index]));
  }
  if (sum_of(shape) == 0.0) {
    for (std::size_t index = 0; index < shape.size(); ++index) {
      shape[index] = distance[index] <= level * problem.shares[index] ? 1.0 : 0.0;
    }
  }
  return shape;
}

/// The level below which the start draws pressures for a prescribed load.
double quantile_of(const DimensionlessProblem& problem, double share) {
  std::vector<double> ordered = problem.distance;
  std::transform(ordered.begin(), ordered.end(), problem.shares.begin(), ordered.begin(),
                 std::divides<>());
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(ordered.size() - 1));
  const auto place = ordered.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(ordered.begin(), place, ordered.end());
  return *place;
}

double load_of(std::span<const double> pressure, std::span<const double> shares) {
  return std::inner_product(pressure.begin(), pressure.end(), shares.begin(), 0.0);
}

/// Relative to that of the patch.
std::vector<double> shares_of(const PatchGap& patch) {
  std::vector<double> shares(patch.grid.element_count(), 1.0);
  std::transform(patch.shares.begin(), patch.shares.end(), shares.begin(),
                 [&](double share) { return share / patch.approach_cosine; });
  return shares;
}

/// The approach at which the first element touches.
double first_touch(const PatchGap& patch) {
  double touch = std::numeric_limits<double>::infinity();
  for (std::size_t index = 0; index < patch.undeformed_distance.size(); ++index) {
    touch = std::min(touch, patch.undeformed_distance[index] / patch.share(index));
  }
  return touch;
}

class ActiveSetIteration {
public:
  ActiveSetIteration(const DimensionlessProblem& problem, std::vector<double> start)
      : problem_(problem), operator_(problem.grid, 1.0, problem.elements, problem.angles),
        pressure_(std::move(start)), gap_(pressure_.size()), direction_(pressure_.size(), 0.0),
        response_(pressure_.size()) {}

  DimensionlessResult run(double tolerance, int maximum_iterations);

private:
  /// Gap of the present pressures; returns their complementarity error.
  double evaluate_gap();
  /// New direction; returns the step along it, 0 when there is none.
  double choose_step();
  double choose_step_along_direction();
  /// Moves the pressures; returns the relative update.
  double move(double step);
  /// A step that is safe for any pressures: the inverse of a bound of the largest eigenvalue of A.
  double safe_step();

  [[nodiscard]] bool in_contact(std::size_t index) const { return pressure_[index] > 0.0; }

  const DimensionlessProblem& problem_;
  DisplacementOperator operator_;
  std::vector<double> pressure_;
  std::vector<double> gap_;
  std::vector<double> direction_;
  std::vector<double> response_;
  double last_gap_square_ = 1.0;
  bool keep_direction_ = false;
  double safe_step_ = 0.0;
};

double ActiveSetIteration::evaluate_gap() {
  operator_.apply(pressure_, gap_);
  double largest_displacement = 0.0;
  double contact_sum = 0.0;
  double squares = 0.0;
  for (std::size_t index = 0; index < gap_.size(); ++index) {
    largest_displacement = std::max(largest_displacement, gap_[index]);
    gap_[index] += problem_.distance[index];
    if (in_contact(index)) {
      const double share = problem_.shares[index];
      contact_sum += share * gap_[index];
      squares += share * share;
    }
  }
  const double approach = problem_.load_prescribed ? contact_sum / squares : problem_.approach;
  double largest_error = 0.0;
  for (std::size_t index = 0; index < gap_.size(); ++index) {
    gap_[index] -= problem_.shares[index] * approach;
    largest_error =
        std::max(largest_error, in_contact(index) ? std::abs(gap_[index]) : -gap_[index]);
  }
  return largest_displacement > 0.0 ? largest_error / largest_displacement
                                    : std::numeric_limits<double>::infinity();
}

double ActiveSetIteration::choose_step_along_direction() {
  operator_.apply(direction_, response_);
  double response_mean = 0.0;
  if (problem_.load_prescribed) {
    double squares = 0.0;
    for (std::size_t index = 0; index < response_.size(); ++index) {
      if (in_contact(index)) {
        const double share = problem_.shares[index];
        response_mean += share * response_[index];
        squares += share * share;
      }
    }
    response_mean /= squares;
  }
  double descent = 0.0;
  double curvature = 0.0;
  for (std::size_t index = 0; index < response_.size(); ++index) {
    if (in_contact(index)) {
      descent += gap_[index] * direction_[index];
      curvature += (response_[index] - response_mean * problem_.shares[index]) * direction_[index];
    }
  }
  return descent > 0.0 && curvature > 0.0 ? descent / curvature : 0.0;
}

double ActiveSetIteration::choose_step() {
  double gap_square = 0.0;
  for (std::size_t index = 0; index < gap_.size(); ++index) {
    gap_square += in_contact(index) ? gap_[index] * gap_[index] : 0.0;
  }
  const double share = keep_direction_ ? gap_square / last_gap_square_ : 0.0;
  last_gap_square_ = gap_square;
  if (gap_square == 0.0) {
    keep_direction_ = false;
    std::fill(direction_.begin(), direction_.end(), 0.0);
    return 0.0;
  }
  for (std::size_t index = 0; index < gap_.size(); ++index) {
    direction_[index] = in_contact(index) ? gap_[index] + share * direction_[index] : 0.0;
  }
  double step = choose_step_along_direction();
  if (step == 0.0 && share > 0.0) {
    for (std::size_t index = 0; index < gap_.size(); ++index) {
      direction_[index] = in_contact(index) ? gap_[index] : 0.0;
    }
    step = choose_step_along_direction();
  }
  return step;
}

double ActiveSetIteration::safe_step() {
  if (safe_step_ == 0.0) {
    const std::vector<double> ones(pressure_.size(), 1.0);
    std::vector<double> row_sums(pressure_.size());
    operator_.apply(ones, row_sums);
    safe_step_ = 1.0 / *std::max_element(row_sums.begin(), row_sums.end());
  }
  return safe_step_;
}

double ActiveSetIteration::move(double step) {
  // response_ is spent by now and keeps the old pressures.
  std::copy(pressure_.begin(), pressure_.end(), response_.begin());
  const double overlap_step = step > 0.0 ? step : safe_step();
  bool overlap_found = false;
  for (std::size_t index = 0; index < pressure_.size(); ++index) {
    pressure_[index] = std::max(0.0, pressure_[index] - step * direction_[index]);
    if (pressure_[index] == 0.0 && gap_[index] < 0.0) {
      pressure_[index] = -overlap_step * gap_[index];
      overlap_found = true;
    }
  }
  keep_direction_ = !overlap_found && step > 0.0;

  double sum = sum_of(pressure_);
  if (problem_.load_prescribed) {
    const double load = load_of(pressure_, problem_.shares);
    if (load <= 0.0) {
      // A direction kept over a change of contact may take all load away: start afresh instead.
      std::copy(response_.begin(), response_.end(), pressure_.begin());
      keep_direction_ = false;
      return std::numeric_limits<double>::infinity();
    }
    const double factor = problem_.load / load;
    for (double& value : pressure_) {
      value *= factor;
    }
    sum *= factor;
  }
  double change = 0.0;
  for (std::size_t index = 0; index < pressure_.size(); ++index) {
    change += std::abs(pressure_[index] - response_[index]);
  }
  return sum > 0.0 ? change / sum : std::numeric_limits<double>::infinity();
}

DimensionlessResult ActiveSetIteration::run(double tolerance, int maximum_iterations) {
  DimensionlessResult best{pressure_, 0, StopReason::iteration_limit};
  double least_error = std::numeric_limits<double>::infinity();
  double update = std::numeric_limits<double>::infinity();
  int best_iteration = 0;
  for (int iteration = 0;; ++iteration) {
    best.iterations = iteration;
    const double error = std::max(update, evaluate_gap());
    if (error < least_error) {
      least_error = error;
      best.pressure = pressure_;
      best_iteration = iteration;
    }
    if (error <= tolerance) {
      best.stop_reason = StopReason::tolerance_met;
      return best;
    }
    if (iteration - best_iteration >= polonsky_keer_stagnation_window) {
      best.stop_reason = StopReason::stagnation;
      return best;
    }
    if (iteration == maximum_iterations) {
      return best;
    }
    update = move(choose_step());
  }
}

/// A problem with a contact to be found: load > 0, or approach above the first touch.
DimensionlessProblem scale_problem(const NormalProblem& problem, double touch) {
  const PatchGap& patch = problem.patches.front();
  const Grid& grid = patch.grid;
  const std::span<const double> distances = patch.undeformed_distance;
  const double step = grid.longitudinal_step;
  DimensionlessProblem scaled{
      {grid.lateral_count, grid.longitudinal_count, grid.lateral_step / step, 1.0, 0.0, 0.0},
      std::vector<double>(distances.size()),
      shares_of(patch),
      problem.load.has_value(),
      problem.elements,
      patch.angles};
  // Where the load is given, one element that carries it all has pressure 1; lengths follow from
  // u ~ p step / E*. Where the approach is given, it is the unit of normal distances.
  double normal_scale = 0.0;
  if (scaled.load_prescribed) {
    scaled.load = 1.0;
    scaled.pressure_scale = *problem.load / patch.approach_cosine / step / grid.lateral_step;
    normal_scale = scaled.pressure_scale / problem.combined_modulus * step;
  } else {
    normal_scale = (*problem.approach - touch) * patch.approach_cosine;
    scaled.approach = 1.0;
    scaled.pressure_scale = normal_scale / step * problem.combined_modulus;
  }
  std::transform(distances.begin(), distances.end(), scaled.shares.begin(), scaled.distance.begin(),
                 [=](double distance, double share) {
                   return (distance - touch * patch.approach_cosine * share) / normal_scale;
                 });
  return scaled;
}

std::vector<double> start_pressures(const DimensionlessProblem& scaled) {
  const double level =
      scaled.load_prescribed ? quantile_of(scaled, start_quantile) : scaled.approach;
  std::vector<double> pressure = start_shape(scaled, level);
  double factor = 0.0;
  if (scaled.load_prescribed) {
    factor = scaled.load / load_of(pressure, scaled.shares);
  } else {
    // The multiple of the shape with the least energy.
    std::vector<double> displacement(pressure.size());
    DisplacementOperator(scaled.grid, 1.0, scaled.elements, scaled.angles)
        .apply(pressure, displacement);
    double work = 0.0;
    double energy = 0.0;
    for (std::size_t index = 0; index < pressure.size(); ++index) {
      work += pressure[index] * (scaled.approach * scaled.shares[index] - scaled.distance[index]);
      energy += pressure[index] * displacement[index];
    }
    factor = work / energy;
  }
  for (double& value : pressure) {
    value *= factor;
  }
  return pressure;
}

/// Approach and force of the final pressures. Returns their residuals, from a fresh convolution.
Residuals finish_solution(const NormalProblem& problem, NormalSolution& solution) {
  const PatchGap& patch = problem.patches.front();
  const std::span<const double> distance = patch.undeformed_distance;
  const std::vector<double>& pressure = solution.patches.front().pressure;
  std::vector<double> displacement(pressure.size());
  DisplacementOperator(patch.grid, problem.combined_modulus, problem.elements, patch.angles)
      .apply(pressure, displacement);
  if (problem.approach) {
    solution.approach = *problem.approach;
  } else {
    const double touch = first_touch(patch);
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t index = 0; index < distance.size(); ++index) {
      if (pressure[index] > 0.0) {
        const double share = patch.share(index);
        sum += share * ((distance[index] - share * touch) + displacement[index]);
        squares += share * share;
      }
    }
    solution.approach = touch + (squares > 0.0 ? sum / squares : 0.0);
  }
  solution.patches.front().normal_force = sum_of(pressure) * patch.grid.element_area();
  return compute_residuals(problem, pressure, displacement, solution.approach);
}

} // namespace

NormalSolution solve_with_polonsky_keer(const NormalProblem& problem) {
  const PatchGap& patch = single_patch(problem);
  const double touch = first_touch(patch);
  NormalSolution solution;
  std::vector<double>& pressure = solution.patches.emplace_back().pressure;
  if (problem.load ? *problem.load == 0.0 : *problem.approach <= touch) {
    pressure.assign(patch.grid.element_count(), 0.0);
    finish_solution(problem, solution);
    return solution;
  }

  const DimensionlessProblem scaled = scale_problem(problem, touch);
  DimensionlessResult result = ActiveSetIteration(scaled, start_pressures(scaled))
                                   .run(problem.tolerance, problem.maximum_iterations);
  pressure = std::move(result.pressure);
  for (double& value : pressure) {
    value *= scaled.pressure_scale;
  }
  solution.iterations = result.iterations;
  solution.convolutions = result.iterations;
  solution.stop_reason = result.stop_reason;
  const Residuals residuals = finish_solution(problem, solution);
  const double error =
      std::max({residuals.load_balance, residuals.complementarity, -residuals.least_gap});
  solution.pressure_error = pressure_error_per_gap_error * error;
  // The rounding of distances far from 0 can spoil what was reached relative to the least one.
  if (solution.stop_reason == StopReason::tolerance_met && error > problem.tolerance) {
    solution.stop_reason = StopReason::stagnation;
  }
  return solution;
}

} // namespace wrc
