#include "pressure/contact_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pressure/constants.hpp"

namespace wrc {
namespace {

/// Sums of pressures, and of their moments along the rail, in elements.
struct Moments {
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;

  void add(double pressure, double place) {
    sum += pressure;
    first += pressure * place;
    second += pressure * place * place;
  }
  /// Sum of squared distances from the middle.
  [[nodiscard]] double about_middle() const {
    return sum > 0.0 ? second - first * first / sum : 0.0;
  }
};

/// Total variation of the slope of a quantity over rows; differences over several rows do not see
/// by how much single elements at the edge differ.
double variation_of_slope(std::span<const double> of_rows) {
  const auto in_contact = static_cast<std::size_t>(
      std::ranges::count_if(of_rows, [](double force) { return force > 0.0; }));
  const std::size_t span = std::max(in_contact / rows_of_differences, std::size_t{1});
  const auto at = [&](std::size_t i) { // from two spans before the first row
    return i < 2 * span || i - 2 * span >= of_rows.size() ? 0.0 : of_rows[i - 2 * span];
  };
  double variation = 0.0;
  for (std::size_t i = span; i < of_rows.size() + 3 * span; ++i) {
    variation += std::abs(at(i - span) - 2.0 * at(i) + at(i + span));
  }
  return variation / static_cast<double>(span * span);
}

} // namespace

ContactScale contact_scale(const Grid& grid, std::span<const double> pressure) {
  std::vector<double> force;
  Moments all;
  double within_rows = 0.0;
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    Moments row;
    for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
      row.add(pressure[i * grid.longitudinal_count + j], static_cast<double>(j));
    }
    force.push_back(row.sum);
    within_rows += row.about_middle();
    all.sum += row.sum;
    all.first += row.first;
    all.second += row.second;
  }
  const double of_lines = within_rows / all.sum + variance_of_element;
  const double of_contact = all.about_middle() / all.sum + variance_of_element;
  return {grid.lateral_step * std::sqrt(variation_of_ellipse * all.sum / variation_of_slope(force)),
          grid.longitudinal_step * 2.0 * std::sqrt(5.0 / of_contact) * of_lines};
}

} // namespace wrc
