#include "mechanics/displacement_operator.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "error.hpp"
#include "vector_clones.hpp"

namespace wrc {

namespace {

void check_positive(const std::string& argument, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw_invalid_argument(argument, value, "must be finite and greater than 0");
  }
}

const Grid& checked(const Grid& grid) {
  if (grid.lateral_count < 1) {
    throw_invalid_argument("grid.lateral_count", 0.0, "must be at least 1");
  }
  if (grid.longitudinal_count < 1) {
    throw_invalid_argument("grid.longitudinal_count", 0.0, "must be at least 1");
  }
  check_positive("grid.lateral_step", grid.lateral_step);
  check_positive("grid.longitudinal_step", grid.longitudinal_step);
  return grid;
}

/// Diagonals of an element beyond which its coefficient is that of its moments to the second, to
/// 1e-4.
constexpr double near_reach = 6.0;

/// Where a place lies, seen from the first element of a row, and what elements of constant pressure
/// add: mean of 1/R over an element = 1/R + dx^2/24 (1/R)_xx + dy^2/24 (1/R)_yy + ..., while those
/// of smooth pressure leave just this out (influence_coefficients.hpp).
struct FarRow {
  double longitudinal = 0.0;
  double lateral = 0.0;
  double step = 0.0;
  double along_square = 0.0;  ///< dx^2/24
  double across_square = 0.0; ///< dy^2/24
};

/// sum_j p_j (mean of 1/R over element j), all of them far away.
WRC_VECTOR_CLONES double sum_far(const FarRow& row, const double* pressure, std::size_t first,
                                 std::size_t end) {
  const double y_square = row.lateral * row.lateral;
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t j = first; j < end; ++j) {
    const double x = row.longitudinal - static_cast<double>(j) * row.step;
    const double x_square = x * x;
    const double inverse = 1.0 / (x_square + y_square);
    const double bend = row.along_square * (2.0 * x_square - y_square) +
                        row.across_square * (2.0 * y_square - x_square);
    sum += pressure[j] * std::sqrt(inverse) * (1.0 + bend * inverse * inverse);
  }
  return sum;
}

} // namespace

DisplacementOperator::DisplacementOperator(const Grid& grid, double combined_modulus,
                                           Elements elements)
    : lateral_count_(checked(grid).lateral_count), longitudinal_count_(grid.longitudinal_count),
      transform_(good_fft_length(2 * grid.lateral_count - 1),
                 good_fft_length(2 * grid.longitudinal_count - 1)) {
  check_positive("combined_modulus", combined_modulus);
  const std::size_t rows = transform_.rows();
  const std::size_t columns = transform_.columns();
  const std::span<double> kernel = transform_.field();

  // Lengths in units of the longitudinal step, so that no scale of the grid can over- or underflow.
  const double aspect = grid.lateral_step / grid.longitudinal_step;
  const std::size_t half_columns = columns / 2 + 1;
  std::vector<double> table((rows / 2 + 1) * half_columns);
  fill_influence_table({aspect, elements}, rows / 2 + 1, half_columns, table);
  for (std::size_t row = 0; row <= rows / 2; ++row) {
    double* values = kernel.data() + row * columns;
    std::copy_n(table.data() + row * half_columns, half_columns, values);
    for (std::size_t column = columns / 2 + 1; column < columns; ++column) {
      values[column] = values[columns - column];
    }
    if (row > 0 && row != rows - row) {
      std::copy_n(values, columns, kernel.data() + (rows - row) * columns);
    }
  }
  transform_.forward();

  const double scale = grid.longitudinal_step / (std::numbers::pi * combined_modulus) /
                       static_cast<double>(rows * columns);
  const std::span<const std::complex<double>> spectrum = transform_.spectrum();
  kernel_spectrum_.resize(spectrum.size());
  std::transform(spectrum.begin(), spectrum.end(), kernel_spectrum_.begin(),
                 [scale](const std::complex<double>& value) { return scale * value.real(); });
}

void DisplacementOperator::apply(std::span<const double> pressure, std::span<double> displacement) {
  const std::size_t element_count = lateral_count_ * longitudinal_count_;
  if (pressure.size() != element_count) {
    throw_invalid_argument("pressure.size", static_cast<double>(pressure.size()),
                           "must be the grid's " + std::to_string(element_count) + " elements");
  }
  if (displacement.size() != element_count) {
    throw_invalid_argument("displacement.size", static_cast<double>(displacement.size()),
                           "must be the grid's " + std::to_string(element_count) + " elements");
  }
  const std::span<double> field = transform_.field();
  const std::size_t columns = transform_.columns();
  std::fill(field.begin(), field.end(), 0.0);
  for (std::size_t row = 0; row < lateral_count_; ++row) {
    std::copy_n(pressure.data() + row * longitudinal_count_, longitudinal_count_,
                field.data() + row * columns);
  }
  transform_.forward();
  const std::span<std::complex<double>> spectrum = transform_.spectrum();
  for (std::size_t index = 0; index < spectrum.size(); ++index) {
    spectrum[index] *= kernel_spectrum_[index];
  }
  transform_.backward();
  for (std::size_t row = 0; row < lateral_count_; ++row) {
    std::copy_n(field.data() + row * columns, longitudinal_count_,
                displacement.data() + row * longitudinal_count_);
  }
}

double displacement_at(const Grid& grid, std::span<const double> pressure, double combined_modulus,
                       double longitudinal, double lateral, Elements elements) {
  const double along = grid.longitudinal_step;
  const double across = grid.lateral_step;
  const double reach = near_reach * std::hypot(along, across);
  const bool constant = elements == Elements::constant;
  FarRow far;
  far.longitudinal = longitudinal - grid.longitudinal_first;
  far.step = along;
  far.along_square = constant ? along * along / 24.0 : 0.0;
  far.across_square = constant ? across * across / 24.0 : 0.0;
  const auto count = static_cast<double>(grid.longitudinal_count);
  double sum = 0.0;
  double displacement = 0.0;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double* values = pressure.data() + row * grid.longitudinal_count;
    far.lateral = lateral - grid.lateral(row);
    const double half = std::sqrt(std::max(0.0, reach * reach - far.lateral * far.lateral));
    const auto place_of = [&](double offset) {
      return static_cast<std::size_t>(
          std::clamp(std::ceil((far.longitudinal + offset) / along), 0.0, count));
    };
    const std::size_t first = half > 0.0 ? place_of(-half) : grid.longitudinal_count;
    const std::size_t end = half > 0.0 ? place_of(half) : grid.longitudinal_count;
    sum += sum_far(far, values, 0, first) + sum_far(far, values, end, grid.longitudinal_count);
    for (std::size_t column = first; column < end; ++column) {
      if (values[column] != 0.0) {
        displacement += values[column] *
                        influence_coefficient(longitudinal - grid.longitudinal(column), far.lateral,
                                              along, across, combined_modulus, elements);
      }
    }
  }
  return displacement + sum * grid.element_area() / (std::numbers::pi * combined_modulus);
}

} // namespace wrc
