#include "accuracy/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc {
namespace {

/// Rows over the penetration for an accuracy of 1e-2, and the power by which they grow: the fewest
/// with which 99.5 of 100 wheels meet accuracies from 1e-1 to 3e-4 (`wrc_tradeoff`).
constexpr double rows_at_one_percent = 21.0;
constexpr double rows_exponent = 0.355;
constexpr double columns_by_rows = 0.45;
/// The fewest that still hold a patch.
constexpr double min_rows = 10.0;
constexpr double min_columns = 8.0;
/// The law of the header, of what it is larger, and how much worse elements of constant pressure
/// are.
constexpr double error_of_one_row = 1.5;
constexpr double force_by_depth = 1.5;
constexpr double constant_elements_error = 3.0;
/// Share of its grid that contact takes each way as a rule.
constexpr double usual_share_of_row = 0.7;
/// Of the accuracy, what rows may leave; the rest is for the iteration.
constexpr double share_of_rows = 0.7;

/// Elements each way that an estimate above the accuracy takes, as a multiple of those before, at
/// most: at a kink no number of rows resolves a crest. The error of a crest falls with the power
/// of 1 to 2 of the rows, so as many times as many rows suffice as the error is too large. Rounded
/// up to powers of the root of 2: numbers of elements that followed each step of the scene would
/// make forces jump in each.
constexpr double max_refinement = 4.0;

std::size_t whole(double count) {
  return static_cast<std::size_t>(std::ceil(count));
}

double error_factor(const AccuracyGoal& goal) {
  return (goal.position_is_prescribed ? force_by_depth : 1.0) *
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
  return counts_with(rows_for(goal.accuracy / error_factor(goal)));
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
          times(by_law(error.columns), counts.longitudinal)};
}

} // namespace wrc
