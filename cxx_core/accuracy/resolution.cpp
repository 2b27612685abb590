#include "accuracy/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/constants.hpp"
#include "patches/plane_area.hpp"
#include "pressure/contact_scale.hpp"
#include "pressure/edge_rows.hpp"
#include "remesh/met_distance.hpp"

namespace wrc {
namespace {

/// How much larger errors are than by the law, or must be smaller.
double error_factor(const AccuracyGoal& goal) {
  return (goal.position_is_prescribed ? position_error_factor : 1.0) *
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

/// Error of a contact's place, which falls with the rows as fast as the law's.
double error_of_place(std::span<const ContactRow> of_rows, double rows) {
  const double on_few_rows = 1.0 + error_by_fourth_powers / (error_by_squares * rows * rows);
  return error_by_edges * on_few_rows * edge_error(of_rows);
}

/// The next power of the root of 2, 1 at least.
double stepped_up(double factor) {
  return std::exp2(0.5 * std::ceil(2.0 * std::log2(std::max(factor, 1.0))));
}

/// Element size for `count` elements over a contact, with an even number in the whole grid: edges
/// then keep their positions between elements, which shows in the slopes of creep forces.
double size_in(double whole, double contact, double count) {
  return whole / static_cast<double>(even_count(whole / contact * count));
}

/// How many columns there are for each one along a gap that is a parabola.
double columns_of_bent(double bend) {
  return 1.0 + (bent_columns - 1.0) * bend;
}

/// Error of a force where a profile has a kink under the pressures, to first order in the rows.
double error_at_ridge(const Patch& patch) {
  return patch.ridge > 0.0
             ? error_by_ridge * patch.ridge * patch.grid.lateral_step / patch.overlap()
             : 0.0;
}

/// Error of the largest pressure by a crest along the rail, MPa: as far as its second difference in
/// the row exceeds that of a semi-ellipse as long as the row's pressures. None beside an end of a
/// part, where no number of columns resolves the pressures.
double error_along(const Patch& patch) {
  const std::size_t columns = patch.grid.longitudinal_count;
  const auto top = static_cast<std::size_t>(
      std::max_element(patch.pressure.begin(), patch.pressure.end()) - patch.pressure.begin());
  const std::size_t column = top % columns;
  const double* row = &patch.pressure[top - column];
  double force = 0.0;
  double moment = 0.0;
  double second_moment = 0.0;
  for (std::size_t j = 0; j < columns; ++j) {
    const auto place = static_cast<double>(j) - static_cast<double>(column);
    force += row[j];
    moment += row[j] * place;
    second_moment += row[j] * place * place;
  }
  const double variance = second_moment / force - moment * moment / (force * force);
  const auto is_cut = [&](std::size_t at) {
    return at < patch.undeformed_distance.size() && !is_met(patch.undeformed_distance[at]);
  };
  if ((column > 0 && is_cut(top - 1)) || (column + 1 < columns && is_cut(top + 1))) {
    return 0.0;
  }
  const double before = column > 0 ? row[column - 1] : 0.0;
  const double after = column + 1 < columns ? row[column + 1] : 0.0;
  const double difference = 2.0 * row[column] - before - after;
  const double of_ellipse = row[column] / (4.0 * variance);
  return variance > 0.0 ? error_by_second_difference * std::max(difference - of_ellipse, 0.0) : 0.0;
}

} // namespace

double AccuracyGoal::of_contact() const {
  return std::min(accuracy, coarsest_accuracy);
}

ElementCounts coarse_counts() {
  return {coarse_rows, coarse_columns};
}

std::vector<PatchElements> final_elements(std::span<const ExpectedContact> contacts,
                                          const AccuracyGoal& goal) {
  const double for_forces = rows_for(share_of_law * goal.of_contact(), goal);
  const double columns = columns_by_rows * for_forces;
  std::vector<PatchElements> elements;
  for (const ExpectedContact& contact : contacts) {
    const ContactScale& scale = contact.scale;
    const double bent = columns_of_bent(contact.bend);
    if (!goal.creep_forces) {
      elements.push_back({contact.mean_x, contact.mean_y, scale.across / for_forces,
                          scale.along / (bent * static_cast<double>(even_count(columns))),
                          contact.middle});
      continue;
    }
    const double accuracy =
        goal.accuracy / (goal.elements == Elements::constant ? constant_elements_error : 1.0);
    const double growth =
        std::max(std::pow(scale.along / scale.across, columns_by_sides_exponent), contact.bend);
    elements.push_back(
        {contact.mean_x, contact.mean_y,
         size_in(contact.width, scale.across,
                 std::max(for_forces, std::sqrt(creep_row_law / accuracy))),
         size_in(contact.length, scale.along,
                 bent * std::max(columns, growth * std::sqrt(creep_column_law / accuracy))),
         0.5});
  }
  return elements;
}

ErrorEstimate estimate_error(const GridSolution& solution, const AccuracyGoal& goal) {
  ErrorEstimate error;
  double bound = 0.0;
  double weighted = 0.0;
  double weighted_edges = 0.0;
  double forces = 0.0;
  for (const Patch& patch : solution.patches) {
    if (!patch.no_contact()) {
      const std::vector<ContactRow> of_rows = contact_rows(patch.grid, patch.pressure);
      const ContactScale scale = contact_scale(of_rows, patch.grid.lateral_step);
      const double rows = std::min(scale.across / patch.grid.lateral_step,
                                   scale.along / (columns_by_rows * patch.grid.longitudinal_step));
      const double of_patch = std::max(error_of(rows, goal), least_error * goal.of_contact());
      error.elements = std::max(error.elements, of_patch);
      const double of_edges = error_of_place(of_rows, rows);
      error.edges = std::max(error.edges, of_edges);
      weighted += patch.normal_force * of_patch;
      weighted_edges += patch.normal_force * of_edges;
      forces += patch.normal_force;
      error.ridge =
          std::max({error.ridge, error_at_ridge(patch), patch.growth / solution.peak_pressure()});
      if (!goal.forces_only) {
        error.along = std::max(error.along, error_along(patch) / solution.peak_pressure());
      }
    }
    bound = std::max(bound, patch.contact.peak_pressure + patch.peak_error);
  }
  if (goal.forces_only && solution.patches.size() > 1 && forces > 0.0) {
    error.elements = weighted / forces;
    error.edges = weighted_edges / forces;
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
    if (patch.no_contact()) {
      elements.push_back({patch.penetration.mean_x, patch.penetration.mean_y, grid.lateral_step,
                          grid.longitudinal_step, 0.5});
      continue;
    }
    const ContactScale scale = contact_scale(grid, patch.pressure);
    const double rows = static_cast<double>(grid.lateral_count);
    const double middle = (patch.contact.centroid_lateral - grid.lateral_first) / grid.lateral_step;
    // Errors of crests fall more slowly than rows grow: one step more.
    const double times = stepped_up(std::max(wanted * grid.lateral_step / scale.across,
                                             std::numbers::sqrt2 * error.crest / for_crest));
    const double times_along =
        stepped_up(std::max(wanted * columns_by_rows * grid.longitudinal_step / scale.along,
                            error.along / goal.accuracy));
    const auto at_most = [](double factor, double count) {
      return std::min(factor, std::max(max_crest_rows / count, 1.0));
    };
    elements.push_back({patch.penetration.mean_x, patch.penetration.mean_y,
                        grid.lateral_step / at_most(times, rows),
                        grid.longitudinal_step /
                            at_most(times_along, static_cast<double>(grid.longitudinal_count)),
                        (middle + 0.5) / rows});
  }
  return elements;
}

} // namespace wrc
