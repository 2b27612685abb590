#include "patches/plane_area.hpp"

#include <cmath>

namespace wrc {

PlaneArea PlaneArea::widened(double share) const {
  return {lateral_first - share * width(), lateral_last + share * width(),
          longitudinal_first - share * length(), longitudinal_last + share * length()};
}

Grid grid_over(const PlaneArea& area, std::size_t lateral_count, std::size_t longitudinal_count) {
  return grid_around(area,
                     {static_cast<double>(lateral_count), static_cast<double>(longitudinal_count)},
                     lateral_count, longitudinal_count);
}

Grid grid_around(const PlaneArea& area, const RealCounts& over, std::size_t lateral_count,
                 std::size_t longitudinal_count) {
  const auto first = [](double edge, double step, double more) {
    return edge + 0.5 * step - 0.5 * more * step;
  };
  Grid grid;
  grid.lateral_count = lateral_count;
  grid.longitudinal_count = longitudinal_count;
  grid.lateral_step = area.width() / over.lateral;
  grid.longitudinal_step = area.length() / over.longitudinal;
  grid.lateral_first = first(area.lateral_first, grid.lateral_step,
                             static_cast<double>(lateral_count) - over.lateral);
  grid.longitudinal_first = first(area.longitudinal_first, grid.longitudinal_step,
                                  static_cast<double>(longitudinal_count) - over.longitudinal);
  return grid;
}

std::size_t even_count(double count) {
  return 2 * static_cast<std::size_t>(std::ceil(0.5 * count));
}

} // namespace wrc
