#include "remesh/row_scales.hpp"

#include <algorithm>
#include <cmath>

#include "remesh/constants.hpp"

namespace wrc {
namespace {

template <class Change>
std::vector<double> changed(const Grid& grid, std::span<const double> scales,
                            std::span<const double> field, const Change& change) {
  std::vector<double> result(field.begin(), field.end());
  if (field.empty()) {
    return result;
  }
  double* values = result.data();
  for (const double scale : scales) {
    std::transform(values, values + grid.longitudinal_count, values,
                   [&](double value) { return change(value, scale); });
    values += grid.longitudinal_count;
  }
  return result;
}

} // namespace

std::vector<double> row_scales(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                               const RailNormals& rail) {
  if (!frame.tangent) {
    return {};
  }
  std::vector<double> scales(grid.lateral_count, 1.0);
  WheelRay ray(pair, frame);
  const double first_height = ray.height();
  const auto set = [&](std::size_t row) {
    if (const auto position = ray.solve(0.0, grid.lateral(row))) {
      const double of_wheel = ray.inclination(0.0, grid.lateral(row), *position);
      const double square = 1.0 + std::max(of_wheel * rail.inclination(row), 0.0);
      scales[row] = std::pow(square, -0.5 * scale_by_inclination);
    }
  };
  // Outwards from the frame's origin, each ray from the height that its neighbour met.
  const std::size_t middle =
      nearest_to_zero(grid.lateral_first, grid.lateral_step, grid.lateral_count);
  for (std::size_t row = middle; row < grid.lateral_count; ++row) {
    set(row);
  }
  ray.start_from(first_height);
  for (std::size_t row = middle; row-- > 0;) {
    set(row);
  }
  return scales;
}

std::vector<double> times_scales(const Grid& grid, std::span<const double> scales,
                                 std::span<const double> field) {
  return changed(grid, scales, field, [](double value, double scale) { return value * scale; });
}

std::vector<double> over_scales(const Grid& grid, std::span<const double> scales,
                                std::span<const double> field) {
  return changed(grid, scales, field, [](double value, double scale) { return value / scale; });
}

} // namespace wrc
