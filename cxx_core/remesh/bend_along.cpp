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
double left_by_parabola(std::vector<double> left, std::span<const double> weights) {
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
  std::vector<std::vector<double>> powers; // orthogonal ones
  for (int degree = 0; degree <= 2; ++degree) {
    std::vector<double> power(left.size());
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

double bend_along(const Grid& grid, std::span<const double> distance,
                  std::span<const double> plain) {
  const double deepest = -*std::min_element(distance.begin(), distance.end());
  if (!(deepest > 0.0)) {
    return 0.0;
  }
  double left = 0.0;
  double all = 0.0;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    std::vector<double> values;
    std::vector<double> weights;
    for (std::size_t i = row * grid.longitudinal_count; i < (row + 1) * grid.longitudinal_count;
         ++i) {
      values.push_back(distance[i] - plain[i]);
      weights.push_back(std::max(0.0, -distance[i]));
      all += weights.back();
    }
    left += left_by_parabola(std::move(values), weights);
  }
  return std::min(std::sqrt(left / all) / (whole_bend * deepest), 1.0);
}

} // namespace wrc
