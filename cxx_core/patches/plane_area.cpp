#include "patches/plane_area.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {

PlaneArea PlaneArea::widened(double share) const {
  return {lateral_first - share * width(), lateral_last + share * width(),
          longitudinal_first - share * length(), longitudinal_last + share * length()};
}

Grid grid_over(const PlaneArea& area, std::size_t lateral_count, std::size_t longitudinal_count) {
  Grid grid;
  grid.lateral_count = lateral_count;
  grid.longitudinal_count = longitudinal_count;
  grid.lateral_step = area.width() / static_cast<double>(lateral_count);
  grid.longitudinal_step = area.length() / static_cast<double>(longitudinal_count);
  grid.lateral_first = area.lateral_first + 0.5 * grid.lateral_step;
  grid.longitudinal_first = area.longitudinal_first + 0.5 * grid.longitudinal_step;
  return grid;
}

std::size_t even_count(double count) {
  return 2 * static_cast<std::size_t>(std::ceil(0.5 * count));
}

Grid grid_with_sizes(const PlaneArea& area, double lateral_step, double longitudinal_step,
                     double share_of_width) {
  const auto count = [](double length, double step) {
    return static_cast<std::size_t>(std::max(std::lround(length / step), 1L));
  };
  const std::size_t before = count(share_of_width * area.width(), lateral_step);
  const std::size_t half = count(0.5 * area.length(), longitudinal_step);
  Grid grid;
  grid.lateral_count = before + count((1.0 - share_of_width) * area.width(), lateral_step);
  grid.longitudinal_count = 2 * half;
  grid.lateral_step = lateral_step;
  grid.longitudinal_step = longitudinal_step;
  grid.lateral_first = area.lateral_first + share_of_width * area.width() -
                       (static_cast<double>(before) - 0.5) * lateral_step;
  grid.longitudinal_first = 0.5 * (area.longitudinal_first + area.longitudinal_last) -
                            (static_cast<double>(half) - 0.5) * longitudinal_step;
  return grid;
}

} // namespace wrc
