#include "patches/plane_area.hpp"

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

Grid grid_over_real(const PlaneArea& area, std::size_t lateral_count, double longitudinal_count) {
  Grid grid = grid_over(area, lateral_count, even_count(longitudinal_count));
  grid.longitudinal_step = area.length() / longitudinal_count;
  const double more = static_cast<double>(grid.longitudinal_count) - longitudinal_count;
  grid.longitudinal_first =
      area.longitudinal_first + 0.5 * grid.longitudinal_step - 0.5 * more * grid.longitudinal_step;
  return grid;
}

} // namespace wrc
