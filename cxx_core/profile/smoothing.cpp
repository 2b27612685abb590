#include "profile/smoothing.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "profile/reinsch_spline.hpp"

namespace wrc {
namespace {

void check(std::span<const double> abscissa, std::span<const double> value, double wavelength) {
  if (abscissa.size() != value.size()) {
    throw_invalid_argument("number of values", std::to_string(value.size()),
                           std::to_string(abscissa.size()) + ", as there are abscissae");
  }
  if (abscissa.size() < 3) {
    throw_invalid_argument("number of values", std::to_string(value.size()), "at least 3");
  }
  if (!(wavelength > 0.0) || !std::isfinite(wavelength)) {
    throw_invalid_argument("smoothing wavelength", wavelength, "a positive finite number, mm");
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!std::isfinite(value[i])) {
      throw_invalid_argument("value " + std::to_string(i), value[i], "a finite number");
    }
    if (i > 0 && !(abscissa[i] > abscissa[i - 1])) {
      throw_invalid_argument("abscissa " + std::to_string(i), abscissa[i],
                             "above " + text_of(abscissa[i - 1]));
    }
  }
}

std::vector<Position> smooth_over(const std::vector<double>& arc, std::span<const Position> points,
                                  double wavelength) {
  std::vector<double> lateral;
  std::vector<double> height;
  for (const Position& point : points) {
    lateral.push_back(point[0]);
    height.push_back(point[1]);
  }
  lateral = smooth_values(arc, lateral, wavelength);
  height = smooth_values(arc, height, wavelength);
  std::vector<Position> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back({lateral[i], height[i]});
  }
  return result;
}

std::vector<double> chord_lengths(std::span<const Position> points) {
  std::vector<double> arc;
  for (std::size_t i = 0; i < points.size(); ++i) {
    arc.push_back(i == 0 ? 0.0
                         : arc.back() + std::hypot(points[i][0] - points[i - 1][0],
                                                   points[i][1] - points[i - 1][1]));
  }
  return arc;
}

} // namespace

std::vector<double> smooth_values(std::span<const double> abscissa, std::span<const double> value,
                                  double wavelength) {
  check(abscissa, value, wavelength);
  return ReinschSpline({abscissa.begin(), abscissa.end()}, wavelength, false)
      .fit({value.begin(), value.end()})
      .value;
}

std::vector<Position> smooth_points(std::span<const Position> points, double wavelength) {
  const std::vector<Position> first = smooth_over(chord_lengths(points), points, wavelength);
  return smooth_over(chord_lengths(first), points, wavelength);
}

} // namespace wrc
