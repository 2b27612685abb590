/// Hertz's pressures on an ellipse, as a rolling problem.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "rolling/rolling_contact.hpp"

namespace wrc::test {

inline constexpr double friction = 0.3;
inline constexpr double load = 80000.0;
inline constexpr double shear_modulus = 82000.0;

/// Hertz's pressures on a rectangle around an ellipse of semi-axes a (along x) and b.
struct Ellipse {
  double a = 5.0;
  double b = 5.0;
  std::size_t along = 32;
  std::size_t across = 32;
  double shift = 0.0; ///< of the grid along x, in elements
  bool scaled = true; ///< to the load
  double poisson = 0.28;
  std::vector<double> pressure{};

  RollingProblem problem(const Creepages& creepages, double tolerance = 1e-4) {
    RollingProblem result;
    const auto columns = static_cast<double>(along);
    const auto rows = static_cast<double>(across);
    result.grid = {across,         along,
                   2.0 * b / rows, 2.0 * a / columns,
                   -b + b / rows,  -a + a / columns + shift * 2.0 * a / columns};
    pressure.assign(along * across, 0.0);
    const double largest = 1.5 * load / (std::numbers::pi * a * b);
    double sum = 0.0;
    for (std::size_t j = 0; j < across; ++j) {
      for (std::size_t i = 0; i < along; ++i) {
        const double x = result.grid.longitudinal(i) / a;
        const double y = result.grid.lateral(j) / b;
        const double height = std::max(0.0, 1.0 - x * x - y * y);
        pressure[j * along + i] = largest * std::sqrt(height);
        sum += pressure[j * along + i] * result.grid.element_area();
      }
    }
    for (double& p : pressure) {
      p *= scaled ? load / sum : 1.0;
    }
    result.pressure = pressure;
    result.friction = friction;
    result.shear_modulus = shear_modulus;
    result.poisson = poisson;
    result.creepages = creepages;
    result.tolerance = tolerance;
    return result;
  }
};

inline double relative(double force) {
  return force / (friction * load);
}

} // namespace wrc::test
