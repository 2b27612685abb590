#include "patches/plane_area.hpp"

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

} // namespace wrc
