#include "wheel/creep_grid.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/constants.hpp"
#include "patches/plane_area.hpp"
#include "pressure/contact_scale.hpp"
#include "wheel/constants.hpp"

namespace wrc {

CreepGrid creep_grid(const PatchPressures& pressures, double accuracy) {
  const auto along = pressures.smooth.longitudinal_extent();
  const auto across = pressures.smooth.lateral_extent();
  if (!along || !across) {
    return {pressures.grid};
  }
  const PlaneArea area{across->first, across->last, along->first, along->last};
  const double wanted = std::sqrt(creep_error_of_one_column / (share_of_creep_columns * accuracy));
  const double wide = contact_scale(pressures.grid, pressures.values).across;
  const double by_sides = std::pow(along->longest / wide, columns_by_sides_exponent);
  // As many of these lengths as the rectangle is long and wide.
  const double times_along = area.length() / along->longest;
  const double times_across = area.width() / wide;
  const double columns =
      std::max(std::min(wanted * by_sides, max_creep_columns / times_along), min_creep_columns);
  const double rows =
      std::max(std::min(wanted * creep_rows_by_columns, 2.0 * max_creep_columns / times_across),
               min_creep_rows);
  return {grid_over(area, even_count(rows * times_across), even_count(columns * times_along)),
          std::min(columns / by_sides, rows / creep_rows_by_columns)};
}

Grid moved_around_contact(const Grid& grid, const SmoothPressure& pressure) {
  const auto along = pressure.longitudinal_extent();
  const auto across = pressure.lateral_extent();
  return along && across ? grid_over({across->first, across->last, along->first, along->last},
                                     grid.lateral_count, grid.longitudinal_count)
                         : grid;
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
