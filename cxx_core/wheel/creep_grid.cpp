#include "wheel/creep_grid.hpp"

#include <algorithm>
#include <cmath>

#include "wheel/constants.hpp"

namespace wrc {

CreepGrid grid_around_contact(const Grid& of_pressures, const SmoothPressure& pressure,
                              double accuracy, int lobes) {
  const auto along = pressure.longitudinal_extent();
  const auto across = pressure.lateral_extent();
  if (!along || !across) {
    return {of_pressures, 1.0};
  }
  const double wanted = std::sqrt(creep_error_of_one_column / (share_of_creep_columns * accuracy));
  const double lobe_count = static_cast<double>(lobes);
  const double sides = lobe_count * along->longest / across->longest;
  const double columns_by_wanted = std::pow(sides, creep_columns_exponent);
  const double rows_by_wanted = creep_rows_by_columns * std::pow(sides, -creep_rows_exponent);
  const double columns =
      std::max(std::min(wanted * columns_by_wanted,
                        max_creep_columns * along->longest / (along->last - along->first)),
               min_creep_columns);
  const double rows =
      std::max(std::min(wanted * rows_by_wanted, 2.0 * max_creep_columns * across->longest /
                                                     (lobe_count * (across->last - across->first))),
               min_creep_rows);
  const auto over = [](const SmoothPressure::Extent& extent, double on_longest) {
    return 2 * static_cast<std::size_t>(
                   std::ceil(0.5 * on_longest * (extent.last - extent.first) / extent.longest));
  };
  CreepGrid result;
  result.columns = std::min(columns / columns_by_wanted, rows / rows_by_wanted);
  result.grid.longitudinal_count = over(*along, columns);
  result.grid.lateral_count = over(*across, lobe_count * rows);
  result.grid = moved_around_contact(result.grid, pressure);
  return result;
}

Grid moved_around_contact(const Grid& grid, const SmoothPressure& pressure) {
  Grid result = grid;
  const auto divide = [](const auto& extent, std::size_t count, double& first, double& step) {
    if (extent) {
      step = (extent->last - extent->first) / static_cast<double>(count);
      first = extent->first + 0.5 * step;
    }
  };
  divide(pressure.longitudinal_extent(), grid.longitudinal_count, result.longitudinal_first,
         result.longitudinal_step);
  divide(pressure.lateral_extent(), grid.lateral_count, result.lateral_first, result.lateral_step);
  return result;
}

Grid extended_to(const Grid& inner, const Grid& outer) {
  Grid result = inner;
  const auto extend = [](double& first, std::size_t& count, double step, double outer_first,
                         double outer_last) {
    const double last = first + static_cast<double>(count - 1) * step;
    const auto elements = [&](double room) {
      return std::min(static_cast<std::size_t>(std::ceil(std::max(room, 0.0) / step)), count / 2);
    };
    const std::size_t before = elements(first - outer_first);
    count += before + elements(outer_last - last);
    first -= static_cast<double>(before) * step;
  };
  extend(result.longitudinal_first, result.longitudinal_count, inner.longitudinal_step,
         outer.longitudinal_first, outer.longitudinal(outer.longitudinal_count - 1));
  extend(result.lateral_first, result.lateral_count, inner.lateral_step, outer.lateral_first,
         outer.lateral(outer.lateral_count - 1));
  return result;
}

} // namespace wrc
