#include "mechanics/displacement_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wrc {

DisplacementBound::DisplacementBound(const Grid& grid, std::span<const double> pressure,
                                     double combined_modulus) {
  const double scale = grid.element_area() / (std::numbers::pi * combined_modulus);
  const double element_square =
      (grid.longitudinal_step * grid.longitudinal_step + grid.lateral_step * grid.lateral_step) /
      12.0;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double* values = pressure.data() + row * grid.longitudinal_count;
    double sum = 0.0;
    double moment = 0.0;
    double square = 0.0;
    double offset = 0.0;
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column, offset += 1.0) {
      sum += values[column];
      moment += values[column] * offset;
      square += values[column] * offset * offset;
    }
    if (sum > 0.0) {
      const double mean = moment / sum;
      const double variance = std::max(0.0, square / sum - mean * mean);
      rows_.push_back({grid.lateral(row), grid.longitudinal_first + mean * grid.longitudinal_step,
                       variance * grid.longitudinal_step * grid.longitudinal_step + element_square,
                       sum * scale});
    }
  }
}

double DisplacementBound::at(double longitudinal, double lateral) const {
  double displacement = 0.0;
  for (const Row& row : rows_) {
    const double x = longitudinal - row.mean;
    const double y = lateral - row.lateral;
    displacement += row.displacement / std::sqrt(x * x + y * y + row.mean_square);
  }
  return displacement;
}

} // namespace wrc
