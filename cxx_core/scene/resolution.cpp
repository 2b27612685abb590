#include "scene/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wrc {
namespace {

/// Rows over the penetration for an accuracy of forces of 1e-2, the power by which they grow, and
/// columns for these rows: 98.7 to 100 of 100 wheels meet accuracies from 1e-1 to 3e-4.
constexpr double rows_at_one_percent = 21.0;
constexpr double rows_exponent = 0.35;
constexpr double columns_by_rows = 0.45;
/// The fewest that still hold a patch.
constexpr double least_rows = 10.0;
constexpr double least_columns = 8.0;
/// The law of the header.
constexpr double integral_error = 2.6;
constexpr double integral_order = 2.18;
constexpr double force_by_depth = 1.5;
/// Rows of the coarse solution before pressures: fewer miss crests. It has few columns, since
/// contact is smooth along the rail.
constexpr double crest_rows = 40.0;
/// Pressures are computed to this at least: with fewer rows crests are missed by chance.
constexpr double coarsest_accuracy = 1e-2;
/// The error of a lower crest may lift it above the highest one by this many times as much.
constexpr double lower_crest_weight = 4.0;
/// Shares of the accuracy for which elements across and along the rail are chosen; some of it is
/// left for the iteration.
constexpr double crest_share = 0.4;
constexpr double longitudinal_share = 0.35;
/// A finer grid has so many times as many rows or columns at least: crests get narrower as they are
/// resolved.
constexpr double least_refinement = 1.6;
/// The laws of the header: for crests, along the rail, and what of the error of integrals pmax has.
constexpr double crest_second_order = 0.03;
constexpr double crest_third_order = 1.6;
constexpr double longitudinal_third_order = 1.2;
constexpr double integral_share_of_pressure = 0.2;
/// Largest pressures change by less than this from the coarse grid to the final one (0.08 at most
/// from 48 rows on in 808 wheels), unless there is a kink.
constexpr double resolved_change = 0.2;
/// Where contact is longer than wide, elements that are long against its tips resolve them badly.
constexpr double tip_second_order = 0.06;
/// Elements of constant pressure: pmax is that much too high by the second order, and integrals are
/// off by so many times as much.
constexpr double constant_second_order = 0.2;
constexpr double constant_integral_factor = 3.0;
/// Waves of the pressure between valleys, as rough profiles have: of their height with four rows a
/// wave a quarter may be lost, and less by the fourth order.
constexpr double wave_error = 64.0;
constexpr double wave_order = 4.0;
/// Fewer elements are never enough.
constexpr double least_resolution = 4.0;
/// At the top of a semi-elliptic pressure n elements wide the second difference is 4 / n^2 of it.
constexpr double top_difference = 4.0;

/// A law of error: c2/n^2 + c3/n^3.
struct ErrorLaw {
  double second_order = 0.0;
  double third_order = 0.0;

  [[nodiscard]] double at(double n) const { return (second_order + third_order / n) / (n * n); }
  /// Elements for an error.
  [[nodiscard]] double elements_for(double error) const {
    double n = least_resolution;
    while (at(n) > error) {
      n *= 1.01;
    }
    return n;
  }
};

ErrorLaw crest_law(Elements elements) {
  const double added = elements == Elements::constant ? constant_second_order : 0.0;
  return {crest_second_order + added, crest_third_order};
}

/// `slenderness`: length of the contact over its width.
ErrorLaw longitudinal_law(Elements elements, double slenderness) {
  const double tips = tip_second_order * std::max(0.0, std::log(slenderness));
  return {elements == Elements::constant ? constant_second_order + tips : tips,
          longitudinal_third_order};
}

std::size_t whole(double count) {
  return static_cast<std::size_t>(std::ceil(count));
}

/// From experience, and so that the law is below the accuracy.
double rows_for(double accuracy) {
  return std::max({rows_at_one_percent * std::pow(1e-2 / accuracy, rows_exponent),
                   std::pow(integral_error / (0.95 * accuracy), 1.0 / integral_order), least_rows});
}

/// Of the depth: a force is that much worse.
double depth_accuracy(const AccuracyGoal& goal) {
  return goal.accuracy / (goal.position_is_prescribed ? force_by_depth : 1.0);
}

double pressure_accuracy(const AccuracyGoal& goal) {
  return std::min(goal.accuracy, coarsest_accuracy);
}

/// A local maximum of the largest pressures of the rows.
struct Crest {
  double pressure = 0.0;
  double elements = 0.0; ///< across the rail, under a semi-ellipse
  double height = 0.0;   ///< above the valley beside it, if there is pressure; or else 0
  double wave = 0.0;     ///< rows of the cosine with this height and second difference

  /// Error that its rows leave, MPa.
  [[nodiscard]] double error(const ErrorLaw& law) const {
    const double as_wave = height > 0.0 ? wave_error * height / std::pow(wave, wave_order) : 0.0;
    return std::max(law.at(elements) * pressure, as_wave);
  }
  /// How many times as many rows an error takes, MPa.
  [[nodiscard]] double refinement_for(double error, const ErrorLaw& law) const {
    const double as_wave =
        height > 0.0 ? std::pow(wave_error * height / error, 1.0 / wave_order) / wave : 0.0;
    return std::max(law.elements_for(error / pressure) / elements, as_wave);
  }
};

/// The lowest value on the way down from a top, up or down the rows.
double valley_beside(const std::vector<double>& tops, std::size_t top, std::ptrdiff_t step) {
  auto at = static_cast<std::ptrdiff_t>(top);
  const auto value = [&tops](std::ptrdiff_t row) { return tops[static_cast<std::size_t>(row)]; };
  while (value(at) > 0.0 && value(at + step) <= value(at)) {
    at += step;
  }
  return value(at);
}

std::vector<Crest> crests_of(const PatchOnGrid& patch) {
  std::vector<double> tops = patch.row_peaks();
  tops.insert(tops.begin(), 0.0);
  tops.push_back(0.0);
  std::vector<Crest> crests;
  for (std::size_t i = 1; i + 1 < tops.size(); ++i) {
    if (tops[i] > 0.0 && tops[i] >= tops[i - 1] && tops[i] >= tops[i + 1]) {
      const double difference = std::max(2.0 * tops[i] - tops[i - 1] - tops[i + 1], 1e-6 * tops[i]);
      const double valley = std::max(valley_beside(tops, i, -1), valley_beside(tops, i, 1));
      Crest& crest = crests.emplace_back();
      crest.pressure = tops[i];
      crest.elements = std::sqrt(top_difference * tops[i] / difference);
      if (valley > 0.0 && valley < tops[i]) {
        crest.height = tops[i] - valley;
        crest.wave =
            2.0 * std::numbers::pi / std::acos(std::max(-1.0, 1.0 - difference / crest.height));
      }
    }
  }
  return crests;
}

double highest_element(const GridSolution& solution) {
  double highest = 0.0;
  for (const PatchOnGrid& patch : solution.patches) {
    highest = std::max(highest, patch.contact.largest_element_pressure);
  }
  return highest;
}

/// Elements under pressure along the rail, through the peak of a patch.
double elements_through_peak(const PatchOnGrid& patch) {
  const std::size_t columns = patch.grid.longitudinal_count;
  const std::size_t peak = patch.contact.largest_element;
  const auto row = patch.pressure.begin() + static_cast<std::ptrdiff_t>(peak - peak % columns);
  return static_cast<double>(std::count_if(row, row + static_cast<std::ptrdiff_t>(columns),
                                           [](double p) { return p > 0.0; }));
}

double slenderness(const PatchOnGrid& patch) {
  return patch.columns() * patch.grid.longitudinal_step / (patch.rows() * patch.grid.lateral_step);
}

/// What the crests of a patch leave, relative to the wheel's largest pressure.
double crest_error_of(const PatchOnGrid& patch, double highest, const ErrorLaw& law) {
  double missing = 0.0;
  for (const Crest& crest : crests_of(patch)) {
    const double error = crest.error(law);
    missing = std::max(missing, crest.pressure < highest
                                    ? crest.pressure + lower_crest_weight * error - highest
                                    : error);
  }
  return missing / highest;
}

/// How many times as many rows the crests of a patch take.
double crest_refinement(const PatchOnGrid& patch, double highest, double accuracy,
                        const ErrorLaw& law) {
  double refinement = 0.0;
  for (const Crest& crest : crests_of(patch)) {
    // Enough for the accuracy, or so that a lower one stays below the highest for sure.
    const double lift = crest.pressure < highest
                            ? (highest - crest.pressure) / crest.pressure / lower_crest_weight
                            : 0.0;
    const double error = std::max(crest_share * accuracy, lift) * crest.pressure;
    refinement = std::max(refinement, crest.refinement_for(error, law));
  }
  return refinement;
}

/// Of integrals, with the fewest rows that a patch has.
double integral_error_of(const GridSolution& solution, const AccuracyGoal& goal) {
  double error = 0.0;
  for (const PatchOnGrid& patch : solution.patches) {
    const double rows = static_cast<double>(patch.grid.lateral_count);
    error = std::max(error, integral_error * std::pow(rows, -integral_order));
  }
  return error * (goal.position_is_prescribed ? force_by_depth : 1.0) *
         (solution.elements == Elements::constant ? constant_integral_factor : 1.0);
}

} // namespace

ElementCounts counts_for_forces(const AccuracyGoal& goal) {
  const double rows = rows_for(depth_accuracy(goal));
  return {whole(rows), whole(std::max(columns_by_rows * rows, least_columns))};
}

ElementCounts coarse_counts(const AccuracyGoal& goal) {
  const ElementCounts fine = counts_for_forces(goal);
  const auto half = [](std::size_t count, double least) {
    return whole(std::max(0.5 * static_cast<double>(count), least));
  };
  const double rows = goal.of == AccuracyOf::pressures
                          ? crest_rows
                          : std::max(0.5 * static_cast<double>(fine.lateral), least_rows);
  return {whole(rows), half(fine.longitudinal, least_columns)};
}

double crest_error_for(const AccuracyGoal& goal) {
  return crest_share * pressure_accuracy(goal);
}

std::vector<ElementCounts> counts_for_pressures(const GridSolution& coarse,
                                                const AccuracyGoal& goal) {
  const double accuracy = pressure_accuracy(goal);
  const ElementCounts least = counts_for_forces({goal.of, accuracy, goal.position_is_prescribed});
  const double highest = highest_element(coarse);
  std::vector<ElementCounts> counts;
  for (const PatchOnGrid& patch : coarse.patches) {
    ElementCounts& wanted = counts.emplace_back(least);
    if (patch.no_contact() || patch.contact.touches_edge.any()) {
      continue; // pressures at an edge grow with every refinement
    }
    const double rows = crest_refinement(patch, highest, accuracy, crest_law(coarse.elements)) *
                        static_cast<double>(patch.grid.lateral_count);
    wanted.lateral = std::max(least.lateral, std::min(whole(rows), most_rows));
    const double error = longitudinal_share * accuracy / coarse.weight(patch);
    const double columns =
        longitudinal_law(coarse.elements, slenderness(patch)).elements_for(error) /
        elements_through_peak(patch) * static_cast<double>(patch.grid.longitudinal_count);
    wanted.longitudinal = std::max(whole(columns), whole(least_columns));
  }
  return counts;
}

std::vector<ElementCounts> finer_counts(const GridSolution& solution, const AccuracyGoal& goal) {
  std::vector<ElementCounts> counts = counts_for_pressures(solution, goal);
  bool finer = false;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const Grid& grid = solution.patches[k].grid;
    const auto refined = [&finer](std::size_t wanted, std::size_t before) {
      if (wanted <= before || before >= most_rows) {
        return before;
      }
      finer = true;
      const std::size_t least = whole(least_refinement * static_cast<double>(before));
      return std::min(std::max(wanted, least), most_rows);
    };
    counts[k].lateral = refined(counts[k].lateral, grid.lateral_count);
    counts[k].longitudinal = refined(counts[k].longitudinal, grid.longitudinal_count);
  }
  return finer ? counts : std::vector<ElementCounts>{};
}

double estimate_error(const GridSolution& solution, const AccuracyGoal& goal, double coarser_peak) {
  const double integral = integral_error_of(solution, goal);
  if (goal.of == AccuracyOf::forces) {
    return integral + solution.pressure_error;
  }
  const double highest = highest_element(solution);
  double across = integral_share_of_pressure * integral;
  double along = 0.0;
  for (const PatchOnGrid& patch : solution.patches) {
    if (!patch.no_contact()) {
      across = std::max(across, crest_error_of(patch, highest, crest_law(solution.elements)));
      along = std::max(along, solution.weight(patch) *
                                  longitudinal_law(solution.elements, slenderness(patch))
                                      .at(elements_through_peak(patch)));
    }
  }
  const double change =
      std::abs(solution.peak_pressure() - coarser_peak) / solution.peak_pressure();
  return across + along + std::max(0.0, change - resolved_change) + solution.pressure_error;
}

} // namespace wrc
