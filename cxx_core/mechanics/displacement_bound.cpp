#include "mechanics/displacement_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vector_clones.hpp"

namespace wrc {

namespace {

/// sum_j p_j / sqrt((longitudinal - j step)^2 + square).
WRC_VECTOR_CLONES double sum_row(const double* pressure, double longitudinal, double step,
                                 double square, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t j = 0; j < count; ++j) {
    const double x = longitudinal - static_cast<double>(j) * step;
    sum += pressure[j] / std::sqrt(x * x + square);
  }
  return sum;
}

} // namespace

DisplacementBound::DisplacementBound(const Grid& grid, std::span<const double> pressure,
                                     double combined_modulus)
    : grid_(grid), pressure_(pressure),
      scale_(grid.element_area() / (std::numbers::pi * combined_modulus)),
      element_square_((grid.longitudinal_step * grid.longitudinal_step +
                       grid.lateral_step * grid.lateral_step) /
                      12.0) {
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
                       variance * grid.longitudinal_step * grid.longitudinal_step + element_square_,
                       sum * scale_});
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

double DisplacementBound::closer_at(double longitudinal, double lateral) const {
  double sum = 0.0;
  for (std::size_t row = 0; row < grid_.lateral_count; ++row) {
    const double y = lateral - grid_.lateral(row);
    sum += sum_row(pressure_.data() + row * grid_.longitudinal_count,
                   longitudinal - grid_.longitudinal_first, grid_.longitudinal_step,
                   y * y + element_square_, grid_.longitudinal_count);
  }
  return sum * scale_;
}

} // namespace wrc
