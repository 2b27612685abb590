#include "creep/creep_grid.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/constants.hpp"
#include "creep/constants.hpp"
#include "patches/plane_area.hpp"
#include "pressure/contact_scale.hpp"

namespace wrc {

namespace {

/// How many there are across and along, within a limit: real numbers.
struct CreepCounts {
  double across;
  double along;
};

CreepCounts within(CreepCounts wanted, double limit) {
  const double times = std::sqrt(wanted.across * wanted.along / limit);
  const double most = std::max(limit / fewest_creep_elements, fewest_creep_elements);
  const auto bounded = [most](double count) { // what is no number counts as few
    return count >= fewest_creep_elements ? std::min(count, most) : fewest_creep_elements;
  };
  const CreepCounts counts{wanted.across / times, wanted.along / times};
  if (counts.across < fewest_creep_elements || counts.along < fewest_creep_elements) {
    return {bounded(counts.across < fewest_creep_elements ? fewest_creep_elements
                                                          : std::min(wanted.across, most)),
            bounded(counts.along < fewest_creep_elements ? fewest_creep_elements
                                                         : std::min(wanted.along, most))};
  }
  return {bounded(counts.across), bounded(counts.along)};
}

/// The even number below.
std::size_t even_count_within(double count) {
  return 2 * static_cast<std::size_t>(std::floor(0.5 * count));
}

} // namespace

CreepGrid creep_grid(const PatchPressures& pressures, double accuracy, double limit) {
  const auto along = pressures.smooth.longitudinal_extent();
  const auto across = pressures.smooth.lateral_extent();
  if (!along || !across) {
    return {pressures.grid, 1.0, static_cast<double>(pressures.grid.element_count())};
  }
  const PlaneArea area{across->first, across->last, along->first, along->last};
  const double wanted = std::sqrt(creep_error_of_one_column / (share_of_creep_columns * accuracy));
  const double wide = contact_scale(pressures.grid, pressures.values).across;
  const double by_sides = (1.0 + (bent_creep_columns - 1.0) * pressures.bend) *
                          std::pow(along->longest / wide, columns_by_sides_exponent);
  // The rectangle's length and width in these lengths.
  const double times_along = area.length() / along->longest;
  const double times_across = area.width() / wide;
  const double columns =
      std::max(std::min(wanted * by_sides, max_creep_columns / times_along), min_creep_columns);
  const double rows =
      std::max(std::min(wanted * creep_rows_by_columns, 2.0 * max_creep_columns / times_across),
               min_creep_rows);
  const CreepCounts counts{rows * times_across, columns * times_along};
  const Grid grid = grid_over(area, even_count(counts.across), even_count(counts.along));
  const double all = static_cast<double>(grid.element_count());
  if (all <= limit) {
    return {grid, std::min(columns / by_sides, rows / creep_rows_by_columns), all};
  }
  const CreepCounts fewer = within(counts, limit);
  return {grid_over(area, even_count_within(fewer.across), even_count_within(fewer.along)),
          std::min(columns * fewer.along / counts.along / by_sides,
                   rows * fewer.across / counts.across / creep_rows_by_columns),
          all, true};
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
      const std::size_t most = count / 2;
      const double wanted = std::ceil(std::max(room, 0.0) / step);
      return wanted < static_cast<double>(most) ? static_cast<std::size_t>(wanted) : most;
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
