#include "accuracy/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/constants.hpp"

namespace wrc {
namespace {

std::size_t whole(double count) {
  return static_cast<std::size_t>(std::ceil(count));
}

double error_factor(const AccuracyGoal& goal) {
  return (goal.position_is_prescribed ? force_by_depth : 1.0) *
         (goal.stresses ? stress_accuracy_factor : 1.0) *
         (goal.elements == Elements::constant ? constant_elements_error : 1.0);
}

/// From experience, and so that the law is below the accuracy.
double rows_for(double accuracy) {
  return std::max({rows_at_one_percent * std::pow(1e-2 / accuracy, rows_exponent),
                   std::sqrt(error_of_one_row / (share_of_rows * accuracy)), min_rows});
}

/// Columns of a grid that contact would fill as usual: where it lies askew in its grid, as on the
/// flange with yaw, its longest row is short.
double columns_in_use(const Patch& patch) {
  const auto columns = static_cast<std::ptrdiff_t>(patch.grid.longitudinal_count);
  std::ptrdiff_t longest = 0;
  for (auto row = patch.pressure.begin(); row != patch.pressure.end(); row += columns) {
    longest =
        std::max(longest, std::count_if(row, row + columns, [](double p) { return p > 0.0; }));
  }
  return std::min(static_cast<double>(longest) / usual_share_of_row, static_cast<double>(columns));
}

ElementCounts counts_with(double rows) {
  return {whole(rows), whole(std::max(columns_by_rows * rows, min_columns))};
}

} // namespace

ElementCounts counts_for(const AccuracyGoal& goal) {
  ElementCounts counts = counts_with(rows_for(goal.accuracy / error_factor(goal)));
  if (goal.creep_forces) {
    const double accuracy =
        goal.accuracy / (goal.elements == Elements::constant ? constant_elements_error : 1.0);
    counts.lateral = std::max(counts.lateral, whole(std::sqrt(creep_row_law / accuracy)));
    counts.longitudinal =
        std::max(counts.longitudinal, whole(std::sqrt(creep_column_law / accuracy)));
    counts.longitudinal_growth = columns_by_sides_exponent;
  }
  return counts;
}

Grid grid_over(const PlaneArea& area, const ElementCounts& counts) {
  if (counts.longitudinal_growth == 0.0) {
    return grid_over(area, counts.lateral, counts.longitudinal);
  }
  const double growth = std::pow(area.length() / area.width(), counts.longitudinal_growth);
  const double columns = std::max(growth * static_cast<double>(counts.longitudinal), min_columns);
  return grid_over_real(area, counts.lateral, columns);
}

ElementCounts coarse_counts(double accuracy) {
  return counts_with(std::max(0.5 * rows_for(accuracy), min_rows));
}

ErrorEstimate estimate_error(const GridSolution& solution, const AccuracyGoal& goal) {
  ErrorEstimate error;
  double bound = 0.0;
  const auto law = [&](double rows) {
    return error_factor(goal) * error_of_one_row / (rows * rows);
  };
  for (const Patch& patch : solution.patches) {
    if (!patch.no_contact()) {
      error.rows = std::max(error.rows, law(static_cast<double>(patch.grid.lateral_count)));
      error.columns = std::max(error.columns, law(columns_in_use(patch) / columns_by_rows));
    }
    bound = std::max(bound, patch.contact.peak_pressure + patch.peak_error);
  }
  error.iteration = solution.pressure_error;
  error.crest = bound / solution.peak_pressure() - 1.0;
  return error;
}

ElementCounts refined_counts(const ElementCounts& counts, const ErrorEstimate& error,
                             double accuracy) {
  const auto times = [](double factor, std::size_t count) {
    const double rounded = std::exp2(std::max(0.5 * std::ceil(2.0 * std::log2(factor)), 0.0));
    return whole(std::min(rounded, max_refinement) * static_cast<double>(count));
  };
  const auto by_law = [&](double of_count) {
    return std::sqrt(of_count / (share_of_rows * accuracy));
  };
  const double of_grid = std::min(std::max(error.rows, error.columns), share_of_rows * accuracy);
  const double by_crest = error.crest / (accuracy - of_grid - error.iteration);
  return {times(std::max(by_law(error.rows), by_crest), counts.lateral),
          times(by_law(error.columns), counts.longitudinal), counts.longitudinal_growth};
}

} // namespace wrc
