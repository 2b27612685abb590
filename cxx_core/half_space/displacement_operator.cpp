#include "half_space/displacement_operator.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "base/error.hpp"

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

} // namespace wrc
