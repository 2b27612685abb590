#include "accuracy/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/constants.hpp"
#include "patches/plane_area.hpp"
#include "pressure/contact_scale.hpp"

namespace wrc {
namespace {

/// How much larger errors are than by the law, or must be smaller.
double error_factor(const AccuracyGoal& goal) {
  return (goal.position_is_prescribed ? force_by_depth : 1.0) *
         (goal.stresses ? stress_accuracy_factor : 1.0) *
         (goal.elements == Elements::constant ? constant_elements_error : 1.0);
}

double error_of(double rows, const AccuracyGoal& goal) {
  const double squared = rows * rows;
  return error_factor(goal) * (error_by_squares + error_by_fourth_powers / squared) / squared;
}

double rows_for(double error, const AccuracyGoal& goal) {
  const double of_factor = error / error_factor(goal);
  return std::sqrt((error_by_squares + std::sqrt(error_by_squares * error_by_squares +
                                                 4.0 * error_by_fourth_powers * of_factor)) /
                   (2.0 * of_factor));
}

/// The next power of the root of 2, 1 at least.
double stepped_up(double factor) {
  return std::exp2(0.5 * std::ceil(2.0 * std::log2(std::max(factor, 1.0))));
}

/// Of so many elements over a contact, a number of them in the whole grid that seldom changes:
/// creep forces are to have smooth slopes, and sizes that follow the contact's scale would show in
/// them.
double size_in(double whole, double contact, double count) {
  return whole / static_cast<double>(even_count(stepped(whole / contact) * count));
}

ContactScale scale_of(const Patch& patch) {
  if (!patch.no_contact()) {
    return contact_scale(patch.grid, patch.pressure);
  }
  const double rows = static_cast<double>(patch.grid.lateral_count);
  const double columns = static_cast<double>(patch.grid.longitudinal_count);
  return {usual_share_of_row * rows * patch.grid.lateral_step,
          usual_share_of_row * columns * patch.grid.longitudinal_step};
}

/// Of the forces across the rail, as a share of the grid's width.
double middle_of(const Patch& patch) {
  if (patch.no_contact()) {
    return 0.5;
  }
  const Grid& grid = patch.grid;
  const double rows = (patch.contact.centroid_lateral - grid.lateral_first) / grid.lateral_step;
  return (rows + 0.5) / static_cast<double>(grid.lateral_count);
}

} // namespace

ElementCounts coarse_counts() {
  return {coarse_rows, coarse_columns};
}

std::vector<PatchElements> final_elements(const GridSolution& coarse, const AccuracyGoal& goal) {
  const double for_forces = std::max(rows_for(share_of_law * goal.accuracy, goal), min_rows);
  std::vector<PatchElements> elements;
  for (const Patch& patch : coarse.patches) {
    const ContactScale scale = scale_of(patch);
    const double columns = columns_by_rows * for_forces;
    if (!goal.creep_forces) {
      elements.push_back({patch.penetration.mean_y, scale.across / for_forces,
                          scale.along / static_cast<double>(even_count(columns)),
                          middle_of(patch)});
      continue;
    }
    const double accuracy =
        goal.accuracy / (goal.elements == Elements::constant ? constant_elements_error : 1.0);
    const double growth = std::pow(scale.along / scale.across, columns_by_sides_exponent);
    const Grid& grid = patch.grid;
    elements.push_back(
        {patch.penetration.mean_y,
         size_in(static_cast<double>(grid.lateral_count) * grid.lateral_step, scale.across,
                 std::max(for_forces, std::sqrt(creep_row_law / accuracy))),
         size_in(static_cast<double>(grid.longitudinal_count) * grid.longitudinal_step, scale.along,
                 std::max(columns, growth * std::sqrt(creep_column_law / accuracy))),
         0.5});
  }
  return elements;
}

ErrorEstimate estimate_error(const GridSolution& solution, const AccuracyGoal& goal) {
  ErrorEstimate error;
  double bound = 0.0;
  for (const Patch& patch : solution.patches) {
    if (!patch.no_contact()) {
      const ContactScale scale = contact_scale(patch.grid, patch.pressure);
      const double rows = std::min(scale.across / patch.grid.lateral_step,
                                   scale.along / (columns_by_rows * patch.grid.longitudinal_step));
      error.elements = std::max(error.elements, error_of(rows, goal));
    }
    bound = std::max(bound, patch.contact.peak_pressure + patch.peak_error);
  }
  error.iteration = solution.pressure_error;
  error.crest = bound / solution.peak_pressure() - 1.0;
  return error;
}

std::vector<PatchElements> finer_elements(const GridSolution& solution, const ErrorEstimate& error,
                                          const AccuracyGoal& goal) {
  const double wanted = rows_for(share_of_law * goal.accuracy, goal);
  const double for_crest = (1.0 - share_of_law) * goal.accuracy - error.iteration;
  std::vector<PatchElements> elements;
  for (const Patch& patch : solution.patches) {
    const Grid& grid = patch.grid;
    const ContactScale scale = scale_of(patch);
    const double rows = static_cast<double>(grid.lateral_count);
    // Errors of crests fall more slowly than rows grow: one step more.
    const double times = stepped_up(std::max(wanted * grid.lateral_step / scale.across,
                                             std::numbers::sqrt2 * error.crest / for_crest));
    elements.push_back({patch.penetration.mean_y,
                        grid.lateral_step / std::min(times, std::max(max_crest_rows / rows, 1.0)),
                        grid.longitudinal_step / stepped_up(wanted * columns_by_rows *
                                                            grid.longitudinal_step / scale.along),
                        middle_of(patch)});
  }
  return elements;
}

} // namespace wrc
