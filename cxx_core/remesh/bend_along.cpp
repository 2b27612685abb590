#include "remesh/bend_along.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "remesh/constants.hpp"

namespace wrc {
namespace {

/// What a parabola leaves of values with these weights, squared, in sum.
double left_by_parabola(std::span<const double> values, std::span<const double> weights) {
  const auto product = [&weights](const std::vector<double>& one, const std::vector<double>& two) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      sum += weights[i] * one[i] * two[i];
    }
    return sum;
  };
  const auto subtract = [&product](std::vector<double>& from, const std::vector<double>& power) {
    const double square = product(power, power);
    const double share = square > 0.0 ? product(from, power) / square : 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      from[i] -= share * power[i];
    }
  };
  std::vector<double> left(values.begin(), values.end());
  std::vector<std::vector<double>> powers; // orthogonal ones
  for (int degree = 0; degree <= 2; ++degree) {
    std::vector<double> power(values.size());
    for (std::size_t i = 0; i < power.size(); ++i) {
      power[i] = std::pow(static_cast<double>(i), degree);
    }
    for (const std::vector<double>& lower : powers) {
      subtract(power, lower);
    }
    subtract(left, power);
    powers.push_back(std::move(power));
  }
  return product(left, left);
}

} // namespace

double bend_along(const Grid& grid, std::span<const double> distance) {
  const double deepest = -*std::min_element(distance.begin(), distance.end());
  if (!(deepest > 0.0)) {
    return 0.0;
  }
  double left = 0.0;
  double all = 0.0;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const auto values = distance.subspan(row * grid.longitudinal_count, grid.longitudinal_count);
    std::vector<double> weights;
    for (const double value : values) {
      weights.push_back(std::max(0.0, -value));
      all += weights.back();
    }
    left += left_by_parabola(values, weights);
  }
  return std::min(std::sqrt(left / all) / (whole_bend * deepest), 1.0);
}

} // namespace wrc
