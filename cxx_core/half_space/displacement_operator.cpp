#include "half_space/displacement_operator.hpp"

#include <algorithm>
#include <cmath>
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

void check_angles(std::span<const double> angles, const Grid& grid) {
  if (angles.empty()) {
    return;
  }
  if (angles.size() != grid.lateral_count) {
    throw_invalid_argument("angles.size", static_cast<double>(angles.size()),
                           "must be the grid's " + std::to_string(grid.lateral_count) + " rows");
  }
  const auto wrong =
      std::ranges::find_if(angles, [](double angle) { return !std::isfinite(angle); });
  if (wrong != angles.end()) {
    throw_invalid_argument("angles[" + std::to_string(wrong - angles.begin()) + "]", *wrong,
                           "must be finite");
  }
}

DisplacementOperator::DisplacementOperator(const Grid& grid, double combined_modulus,
                                           Elements elements, std::span<const double> angles)
    : lateral_count_(checked(grid).lateral_count), longitudinal_count_(grid.longitudinal_count),
      scale_(grid.longitudinal_step / (std::numbers::pi * combined_modulus)) {
  check_positive("combined_modulus", combined_modulus);
  check_angles(angles, grid);
  // Lengths in units of the longitudinal step, so that no scale of the grid can over- or underflow.
  InfluenceCache cache;
  convolution_ = BoxConvolution<double>::linear(
      {lateral_count_, longitudinal_count_, lateral_count_, longitudinal_count_},
      {grid.lateral_step / grid.longitudinal_step, elements}, cache, {angles, angles});
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
  convolution_.apply(pressure.data(), displacement.data(), workspace_);
  for (double& value : displacement) {
    value *= scale_;
  }
}

} // namespace wrc
