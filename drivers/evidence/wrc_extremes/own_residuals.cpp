#include "wrc_extremes/own_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "wrc_extremes/dense_solution.hpp"

namespace extremes {
namespace {

/// Largest number of products of a coefficient and a pressure for one check.
constexpr double most_products = 4e8;
/// Beyond, coefficients are computed in double by a rule of fewer points: exact to 1e-15.
constexpr double near_elements = 64.0;
constexpr std::size_t far_order = 4;

/// Coefficients by offset, mm/MPa, from this program's own integrals.
std::vector<double> influence_table(const GapProblem& problem) {
  const double aspect = problem.lateral_step / problem.longitudinal_step;
  const LoveIntegral<long double> near(static_cast<long double>(aspect));
  const double scale = problem.longitudinal_step / std::numbers::pi / problem.combined_modulus;
  const double far = near_elements * std::max(1.0, aspect);
  const std::size_t pitch = problem.columns + 1;
  std::vector<double> constant;
  constant.reserve((problem.rows + 1) * pitch);
  for (std::size_t row = 0; row <= problem.rows; ++row) {
    const double y = static_cast<double>(row) * aspect;
    for (std::size_t column = 0; column < pitch; ++column) {
      const double x = static_cast<double>(column);
      if (x * x + y * y < far * far) {
        constant.push_back(static_cast<double>(near.constant(row, column)));
        continue;
      }
      constant.push_back(integral_by_rule<double, far_order>(x, y, aspect));
    }
  }
  const auto constant_at = [&](std::size_t row, std::size_t column) {
    return constant[row * pitch + column];
  };
  std::vector<double> table;
  table.reserve(problem.count());
  for (std::size_t row = 0; row < problem.rows; ++row) {
    for (std::size_t column = 0; column < problem.columns; ++column) {
      table.push_back(smooth_influence<double>(constant_at, row, column) * scale);
    }
  }
  return table;
}

/// A row's part of the displacement, from both sides of the column.
double row_sum(const double* table, const double* pressure, std::size_t column, std::size_t first,
               std::size_t last) {
  double sum = 0.0;
  const std::size_t middle = std::clamp(column, first, last);
  for (std::size_t j = first; j < middle; ++j) {
    sum += table[column - j] * pressure[j];
  }
  for (std::size_t j = middle; j < last; ++j) {
    sum += table[j - column] * pressure[j];
  }
  return sum;
}

/// The columns of each row that bear pressure.
struct LoadedRow {
  std::size_t row, first, last;
};

std::vector<LoadedRow> loaded_rows(const GapProblem& problem, const std::vector<double>& pressure) {
  std::vector<LoadedRow> loaded;
  for (std::size_t row = 0; row < problem.rows; ++row) {
    const double* values = pressure.data() + row * problem.columns;
    LoadedRow found{row, problem.columns, 0};
    for (std::size_t column = 0; column < problem.columns; ++column) {
      if (values[column] != 0.0) {
        found.first = std::min(found.first, column);
        found.last = column + 1;
      }
    }
    if (found.first < found.last) {
      loaded.push_back(found);
    }
  }
  return loaded;
}

/// All elements if the work allows it, or else a drawn sample.
std::vector<std::size_t> judged_elements(std::size_t count, double products_each,
                                         std::uint64_t seed) {
  const auto allowed = static_cast<std::size_t>(most_products / std::max(1.0, products_each)) + 1;
  std::vector<std::size_t> judged;
  if (allowed >= count) {
    for (std::size_t i = 0; i < count; ++i) {
      judged.push_back(i);
    }
    return judged;
  }
  std::mt19937_64 engine(seed);
  for (std::size_t i = 0; i < allowed; ++i) {
    judged.push_back(static_cast<std::size_t>(engine() % count));
  }
  return judged;
}

} // namespace

OwnResiduals judge_pressures(const GapProblem& problem, const std::vector<double>& pressure,
                             const std::optional<double>& approach, double load,
                             std::uint64_t seed) {
  OwnResiduals residuals;
  const std::vector<LoadedRow> loaded = loaded_rows(problem, pressure);
  double products = 0.0;
  double force = 0.0;
  double largest_pressure = 0.0;
  double most_tension = 0.0;
  for (const LoadedRow& row : loaded) {
    products += static_cast<double>(row.last - row.first);
    double sum = 0.0;
    for (std::size_t j = row.first; j < row.last; ++j) {
      const double p = pressure[row.row * problem.columns + j];
      sum += p;
      largest_pressure = std::max(largest_pressure, p);
      most_tension = std::max(most_tension, -p);
    }
    force += sum;
  }
  force *= problem.lateral_step * problem.longitudinal_step;
  residuals.load_balance = load > 0.0 ? std::abs(force / load - 1.0) : std::abs(force);
  if (loaded.empty()) {
    return residuals;
  }
  residuals.tension = most_tension / largest_pressure;
  const std::vector<double> table = influence_table(problem);
  const auto displacement = [&](std::size_t element) {
    const std::size_t at_row = element / problem.columns;
    double sum = 0.0;
    for (const LoadedRow& row : loaded) {
      const std::size_t apart = row.row > at_row ? row.row - at_row : at_row - row.row;
      sum += row_sum(table.data() + apart * problem.columns,
                     pressure.data() + row.row * problem.columns, element % problem.columns,
                     row.first, row.last);
    }
    return sum;
  };
  // The largest displacement is under or beside the largest pressure: that element is always
  // checked.
  std::vector<std::size_t> judged = judged_elements(problem.count(), products, seed);
  judged.push_back(static_cast<std::size_t>(std::max_element(pressure.begin(), pressure.end()) -
                                            pressure.begin()));
  std::vector<double> reached(judged.size()); // distance and displacement
  double largest = 0.0;
  double contact_sum = 0.0;
  double contact_count = 0.0;
  // From the least distance on, so that far bodies do not round the rest away.
  const double least = *std::min_element(problem.distance.begin(), problem.distance.end());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const double u = displacement(judged[i]);
    largest = std::max(largest, u);
    reached[i] = (problem.distance[judged[i]] - least) + u;
    if (pressure[judged[i]] > 0.0) {
      contact_sum += reached[i];
      contact_count += 1.0;
    }
  }
  const double height = approach ? *approach - least : contact_sum / contact_count;
  double overlap = 0.0;
  double contact_gap = 0.0;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const double gap = reached[i] - height;
    if (pressure[judged[i]] > 0.0) {
      contact_gap = std::max(contact_gap, std::abs(gap));
    } else {
      overlap = std::max(overlap, -gap);
    }
  }
  residuals.overlap = overlap / largest;
  residuals.complementarity = contact_gap / largest;
  residuals.judged = judged.size() - 1;
  return residuals;
}

} // namespace extremes
