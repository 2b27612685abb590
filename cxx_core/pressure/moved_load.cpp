#include "pressure/moved_load.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wrc {

double moved_load(const Grid& grid, std::span<const double> pressure, const SmoothPressure& smooth,
                  double middle, double mean_axis) {
  const SmoothPressure::Columns between = smooth.own_columns();
  const auto first =
      std::lround((between.first - grid.longitudinal_first) / grid.longitudinal_step);
  double load = 0.0;
  double moved = 0.0;
  for (std::size_t j = 0; j < between.sums.size(); ++j) {
    const auto column = static_cast<std::size_t>(first + static_cast<long>(j));
    double given = 0.0;
    for (std::size_t at = column; column < grid.longitudinal_count && at < pressure.size();
         at += grid.longitudinal_count) {
      given += pressure[at];
    }
    const double place = between.first + static_cast<double>(j) * grid.longitudinal_step;
    load += given;
    moved += 0.5 * std::abs(between.sums[j] - given) *
             std::max(1.0, std::abs(place - middle) / mean_axis);
  }
  return load > 0.0 ? moved / load : 0.0;
}

} // namespace wrc
