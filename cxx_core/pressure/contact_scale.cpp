#include "pressure/contact_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pressure/constants.hpp"

namespace wrc {
namespace {

/// Total variation of the slope of the rows' forces; differences over several rows do not see by
/// how much single elements at the edge differ.
double variation_of_slope(std::span<const ContactRow> rows, std::size_t span) {
  const auto at = [&](std::size_t i) { // from two spans before the first row
    return i < 2 * span || i - 2 * span >= rows.size() ? 0.0 : rows[i - 2 * span].force;
  };
  double variation = 0.0;
  for (std::size_t i = span; i < rows.size() + 3 * span; ++i) {
    variation += std::abs(at(i - span) - 2.0 * at(i) + at(i + span));
  }
  return variation / static_cast<double>(span * span);
}

/// Row of pressures.
ContactRow row_of(std::span<const double> pressure, double step) {
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t j = 0; j < pressure.size(); ++j) {
    const double place = static_cast<double>(j) * step;
    sum += pressure[j];
    first += pressure[j] * place;
    second += pressure[j] * place * place;
  }
  if (!(sum > 0.0)) {
    return {};
  }
  const double middle = first / sum;
  return {sum, middle, second / sum - middle * middle + variance_of_element * step * step};
}

} // namespace

ContactScale contact_scale(std::span<const ContactRow> rows, double height, std::size_t span) {
  double force = 0.0;
  double first = 0.0;
  double second = 0.0;
  double of_lines = 0.0;
  for (const ContactRow& row : rows) {
    force += row.force;
    first += row.force * row.middle;
    second += row.force * row.middle * row.middle;
    of_lines += row.force * row.variance;
  }
  of_lines /= force;
  const double middle = first / force;
  const double of_contact = of_lines + std::max(second / force - middle * middle, 0.0);
  const double narrower = std::sqrt(of_lines / of_contact);
  return {narrower * height *
              std::sqrt(variation_of_ellipse * force / variation_of_slope(rows, span)),
          2.0 * std::sqrt(5.0 * of_lines)};
}

std::vector<ContactRow> contact_rows(const Grid& grid, std::span<const double> pressure) {
  std::vector<ContactRow> rows;
  rows.reserve(grid.lateral_count);
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    rows.push_back(row_of(pressure.subspan(i * grid.longitudinal_count, grid.longitudinal_count),
                          grid.longitudinal_step));
  }
  return rows;
}

ContactScale contact_scale(std::span<const ContactRow> rows, double height) {
  const auto in_contact = static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [](const ContactRow& row) { return row.force > 0.0; }));
  return contact_scale(rows, height, std::max(in_contact / rows_of_differences, std::size_t{1}));
}

ContactScale contact_scale(const Grid& grid, std::span<const double> pressure) {
  return contact_scale(contact_rows(grid, pressure), grid.lateral_step);
}

} // namespace wrc
