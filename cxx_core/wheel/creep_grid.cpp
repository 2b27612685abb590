#include "wheel/creep_grid.hpp"

#include <algorithm>
#include <cmath>

#include "wheel/constants.hpp"

namespace wrc {

Grid grid_around_contact(const Grid& grid, const SmoothPressure& pressure, double accuracy,
                         int lobes) {
  const auto along = pressure.longitudinal_extent();
  const auto across = pressure.lateral_extent();
  if (!along || !across) {
    return grid;
  }
  const double usual = std::pow(share_of_creep_columns * accuracy / creep_error_of_one_column,
                                -1.0 / creep_error_order);
  const double ratio =
      static_cast<double>(lobes) * (along->last - along->first) / (across->last - across->first);
  const double longer = std::pow(ratio, creep_sides_exponent);
  const double columns = std::clamp(usual * longer, min_creep_columns, max_creep_columns);
  const double rows =
      std::max(creep_rows_by_columns * usual / longer, min_creep_rows) * static_cast<double>(lobes);
  const auto even = [](double count) {
    return 2 * static_cast<std::size_t>(std::ceil(0.5 * count));
  };
  Grid result;
  result.longitudinal_count = even(columns);
  result.lateral_count = even(std::min(rows, 2.0 * max_creep_columns));
  return moved_around_contact(result, pressure);
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

double equivalent_columns(const Grid& grid, int lobes) {
  return std::sqrt(static_cast<double>(grid.element_count()) /
                   (creep_rows_by_columns * static_cast<double>(lobes)));
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
