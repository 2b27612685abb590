#include "support/contact_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace wrc::test {

namespace {

std::vector<double> sample(const Grid& grid, const std::function<double(double, double)>& gap) {
  std::vector<double> distance;
  distance.reserve(grid.element_count());
  for (std::size_t index = 0; index < grid.element_count(); ++index) {
    distance.push_back(gap(grid.longitudinal(index % grid.longitudinal_count),
                           grid.lateral(index / grid.longitudinal_count)));
  }
  return distance;
}

} // namespace

Grid centred_grid(std::size_t lateral_count, std::size_t longitudinal_count, double lateral_step,
                  double longitudinal_step) {
  return {lateral_count,
          longitudinal_count,
          lateral_step,
          longitudinal_step,
          -0.5 * lateral_step * static_cast<double>(lateral_count - 1),
          -0.5 * longitudinal_step * static_cast<double>(longitudinal_count - 1)};
}

std::vector<double> hertz_gap(const Grid& grid, double longitudinal_curvature,
                              double lateral_curvature) {
  return sample(grid, [=](double x, double y) {
    return 0.5 * (longitudinal_curvature * x * x + lateral_curvature * y * y);
  });
}

std::vector<ContactCase> contact_cases(std::size_t lateral_count, std::size_t longitudinal_count,
                                       double aspect_ratio) {
  // 6 mm x 6 mm times the aspect ratio, whatever the number of elements.
  const double lateral_step = 6.0 / static_cast<double>(lateral_count);
  const double longitudinal_step = 6.0 * aspect_ratio / static_cast<double>(longitudinal_count);
  const Grid grid =
      centred_grid(lateral_count, longitudinal_count, lateral_step, longitudinal_step);
  std::mt19937_64 generator(20);
  return {
      {"hertz", grid,
       sample(grid, [](double x, double y) { return x * x / 900.0 + y * y / 200.0; })},
      {"two lobes", grid,
       sample(grid,
              [](double x, double y) {
                const double right = (y + 1.5) * (y + 1.5) / 60.0 + 0.0003;
                return x * x / 900.0 + std::min((y - 1.7) * (y - 1.7) / 100.0, right);
              })},
      {"wedge", grid,
       sample(grid, [](double x, double y) { return 0.003 * std::abs(y) + x * x / 900.0; })},
      {"noise", grid,
       sample(grid,
              [&generator](double, double) {
                return 0.01 * static_cast<double>(generator() >> 11) * 0x1p-53;
              })},
      {"flat punch", grid, std::vector<double>(grid.element_count(), 0.0)},
      {"ending body", grid,
       sample(grid, [](double x, double y) { return std::abs(y) > 1.0 ? 1e3 : x * x / 900.0; })},
  };
}

} // namespace wrc::test
