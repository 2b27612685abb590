#include "mechanics/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/reductions.hpp"
#include "half_space/displacement_operator.hpp"

namespace wrc {

namespace {

/// Products and quotients of two loads, lengths and moduli in these ranges, squares of lengths
/// among them, neither overflow nor lose digits; whatever the unit, that is enough.
/// Permitted ranges, not a tuning constant.
constexpr double min_scale = 1e-30;
constexpr double max_scale = 1e30;
constexpr double min_load = 1e-60;
constexpr double max_load = 1e60;
/// Influence coefficients are right to 1e-12 between elements of these shapes
/// (docs/evidence/limits.md). A permitted range, not a tuning constant.
constexpr double max_aspect = 1e9;
/// Range of an element's share of the approach, and of its inverse: permitted values, not a tuning
/// constant.
constexpr double max_share = 1e9;

void check_scale(const std::string& argument, double value) {
  if (!(value >= min_scale && value <= max_scale)) {
    throw_invalid_argument(argument, value, "must be between 1e-30 and 1e30");
  }
}

void check_entries(const std::string& argument, std::size_t size, std::size_t expected) {
  if (size != expected) {
    throw_invalid_argument(argument + ".size", static_cast<double>(size),
                           "must be " + std::to_string(expected) + " elements");
  }
}

} // namespace

std::string_view name_of(StopReason reason) {
  switch (reason) {
  case StopReason::tolerance_met:
    return "tolerance_met";
  case StopReason::iteration_limit:
    return "iteration_limit";
  case StopReason::stagnation:
    return "stagnation";
  }
  throw Error(ErrorCode::internal, "stop reason without a name");
}

void check_grid(const Grid& grid) {
  if (grid.lateral_count < 1 || grid.lateral_count > maximum_element_count) {
    throw_invalid_argument("grid.lateral_count", static_cast<double>(grid.lateral_count),
                           "must be between 1 and 2^26");
  }
  // The quotient keeps the product from overflowing.
  if (grid.longitudinal_count < 1 ||
      grid.longitudinal_count > maximum_element_count / grid.lateral_count) {
    throw_invalid_argument("grid.longitudinal_count", static_cast<double>(grid.longitudinal_count),
                           "must be at least 1, with at most 2^26 elements in all");
  }
  check_scale("grid.lateral_step", grid.lateral_step);
  check_scale("grid.longitudinal_step", grid.longitudinal_step);
  if (grid.lateral_step > max_aspect * grid.longitudinal_step ||
      grid.longitudinal_step > max_aspect * grid.lateral_step) {
    throw_invalid_argument("grid.lateral_step/longitudinal_step",
                           grid.lateral_step / grid.longitudinal_step,
                           "must be between 1e-9 and 1e9");
  }
}

namespace {

void check_distances(std::span<const double> distance, const Grid& grid) {
  check_entries("undeformed_distance", distance.size(), grid.element_count());
  const auto wrong = std::find_if(distance.begin(), distance.end(), [](double value) {
    return !(value >= -max_load && value <= std::numeric_limits<double>::max());
  });
  if (wrong != distance.end()) {
    throw_invalid_argument("undeformed_distance[" + std::to_string(wrong - distance.begin()) + "]",
                           *wrong, "must be finite and no less than -1e60");
  }
}

void check_shares(std::span<const double> shares, const Grid& grid) {
  check_entries("shares", shares.size(), grid.element_count());
  const auto wrong = std::find_if(shares.begin(), shares.end(), [](double share) {
    return !(share >= 1.0 / max_share && share <= max_share);
  });
  if (wrong != shares.end()) {
    throw_invalid_argument("shares[" + std::to_string(wrong - shares.begin()) + "]", *wrong,
                           "must be between 1e-9 and 1e9");
  }
}

void check_interaction(const PatchInteraction& interaction, std::size_t count) {
  check_entries("interaction.places", interaction.places.size(), count);
  check_entries("interaction.coupling_weight", interaction.coupling_weight.size(), count * count);
  for (const double coupling_weight : interaction.coupling_weight) {
    if (!(coupling_weight >= 0.0 && coupling_weight <= 1.0)) {
      throw_invalid_argument("interaction.coupling_weight", coupling_weight,
                             "must be between 0 and 1");
    }
  }
}

} // namespace

void check_problem(const NormalProblem& problem) {
  if (problem.patches.empty()) {
    throw_invalid_argument("patches.size", 0.0, "must be at least 1");
  }
  for (const PatchGap& patch : problem.patches) {
    check_grid(patch.grid);
    check_distances(patch.undeformed_distance, patch.grid);
    if (!(patch.approach_cosine > 0.0 && patch.approach_cosine <= 1.0)) {
      throw_invalid_argument("approach_cosine", patch.approach_cosine,
                             "must be greater than 0 and at most 1");
    }
    if (!patch.shares.empty()) {
      check_shares(patch.shares, patch.grid);
    }
    check_angles(patch.angles, patch.grid);
  }
  check_scale("combined_modulus", problem.combined_modulus);
  const std::optional<double>& load = problem.load;
  if (load.has_value() == problem.approach.has_value()) {
    throw_invalid_argument("load and approach", load.has_value() ? "both set" : "none set",
                           "exactly one of the two must be set");
  }
  if (load && *load != 0.0 && !(*load >= min_load && *load <= max_load)) {
    throw_invalid_argument("load", *load, "must be 0 or lie in 1e-60 to 1e60");
  }
  if (problem.approach && !(std::abs(*problem.approach) <= max_load)) {
    throw_invalid_argument("approach", *problem.approach, "must be between -1e60 and 1e60");
  }
  if (!(problem.tolerance > 0.0 && problem.tolerance <= 0.1)) {
    throw_invalid_argument("tolerance", problem.tolerance,
                           "must be greater than 0 and at most 0.1");
  }
  if (problem.maximum_iterations < 1) {
    throw_invalid_argument("maximum_iterations", static_cast<double>(problem.maximum_iterations),
                           "must be at least 1");
  }
  if (problem.interaction != nullptr) {
    check_interaction(*problem.interaction, problem.patches.size());
  }
}

const PatchGap& single_patch(const NormalProblem& problem) {
  check_problem(problem);
  if (problem.patches.size() > 1) {
    throw_invalid_argument("patches.size", static_cast<double>(problem.patches.size()),
                           "must be 1");
  }
  return problem.patches.front();
}

Residuals compute_residuals(const NormalProblem& problem, std::span<const double> pressure,
                            double approach) {
  const PatchGap& patch = single_patch(problem);
  std::vector<double> displacement(patch.grid.element_count());
  DisplacementOperator(patch.grid, problem.combined_modulus, problem.elements, patch.angles)
      .apply(pressure, displacement);
  return compute_residuals(problem, pressure, displacement, approach);
}

Residuals compute_residuals(const NormalProblem& problem, std::span<const double> pressure,
                            std::span<const double> displacement, double approach) {
  const PatchGap& patch = single_patch(problem);
  check_entries("pressure", pressure.size(), patch.grid.element_count());
  check_entries("displacement", displacement.size(), patch.grid.element_count());
  const std::span<const double> distance = patch.undeformed_distance;
  double load = 0.0;
  double largest_displacement = 0.0;
  double largest_contact_gap = 0.0;
  double least_outside_gap = std::numeric_limits<double>::infinity();
  for (std::size_t index = 0; index < pressure.size(); ++index) {
    // Distance and approach first: they are close to each other where it matters.
    const double gap = (distance[index] - patch.share(index) * approach) + displacement[index];
    if (pressure[index] > 0.0) {
      largest_contact_gap = std::max(largest_contact_gap, std::abs(gap));
    } else {
      least_outside_gap = std::min(least_outside_gap, gap);
    }
    load += patch.share(index) * pressure[index];
    largest_displacement = std::max(largest_displacement, displacement[index]);
  }

  double scale = largest_displacement;
  if (scale == 0.0) {
    const auto least = std::min_element(distance.begin(), distance.end());
    scale = std::abs(patch.share(static_cast<std::size_t>(least - distance.begin())) * approach -
                     *least);
  }
  const auto relative = [scale](double gap) { return gap == 0.0 ? 0.0 : gap / scale; };
  Residuals residuals;
  residuals.complementarity = relative(largest_contact_gap);
  residuals.least_gap = std::isfinite(least_outside_gap) ? relative(least_outside_gap) : 0.0;
  if (problem.load) {
    const double imbalance = std::abs(load * patch.grid.element_area() - *problem.load);
    residuals.load_balance = imbalance == 0.0 ? 0.0 : imbalance / *problem.load;
  }
  return residuals;
}

} // namespace wrc
