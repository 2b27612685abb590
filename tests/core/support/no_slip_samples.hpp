/// Kalker's coefficients of one ellipse on one grid, by the full solver.
///
/// Steady rolling without slip (friction without end) for unit xi, eta and phi; the definition is
/// that of rolling/kalker_coefficients.hpp. Lengths are scaled so that the elements whose centres
/// lie in the ellipse have its area: that takes away most of what depends on where the grid stands.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "rolling/rolling_contact.hpp"

namespace wrc::test {

struct NoSlipSample {
  double c11 = 0.0;
  double c22 = 0.0;
  double c23 = 0.0; ///< of the lateral force from spin
  double c32 = 0.0; ///< of the moment from lateral creepage
  double c33 = 0.0;
};

/// The `number`-th place of a grid, in elements along x and y: fractions that fill the unit square
/// evenly (powers of the inverse plastic number).
inline std::array<double, 2> grid_place(int number) {
  constexpr double first = 0.7548776662466927;
  constexpr double second = 0.5698402909980532;
  return {std::fmod(0.5 + number * first, 1.0), std::fmod(0.5 + number * second, 1.0)};
}

/// Elements along and across the ellipse.
struct SampleGrid {
  std::size_t along = 0;
  std::size_t across = 0;
};

/// Semi-axes sqrt(a/b) and sqrt(b/a).
inline NoSlipSample no_slip_sample(double a_over_b, double poisson, const SampleGrid& elements,
                                   int place, double tolerance, RollingSolver& solver,
                                   SlipDifference difference = SlipDifference::biased) {
  const double a = std::sqrt(a_over_b);
  const double b = 1.0 / a;
  const double step_x = 2.0 * a / static_cast<double>(elements.along);
  const double step_y = 2.0 * b / static_cast<double>(elements.across);
  const auto [place_x, place_y] = grid_place(place);
  RollingProblem problem;
  problem.grid = {elements.across + 1,           elements.along + 1,           step_y, step_x,
                  -b + step_y * (place_y - 0.5), -a + step_x * (place_x - 0.5)};
  std::vector<double> pressure(problem.grid.element_count());
  double area = 0.0;
  for (std::size_t j = 0; j <= elements.across; ++j) {
    for (std::size_t i = 0; i <= elements.along; ++i) {
      const double x = problem.grid.longitudinal(i) / a;
      const double y = problem.grid.lateral(j) / b;
      if (x * x + y * y < 1.0) {
        pressure[j * (elements.along + 1) + i] = 1.0;
        area += step_x * step_y;
      }
    }
  }
  problem.pressure = pressure;
  problem.friction = 1e6;
  problem.shear_modulus = 1.0;
  problem.poisson = poisson;
  problem.difference = difference;
  problem.tolerance = tolerance;
  problem.maximum_iterations = 60;
  const double c = std::sqrt(area / std::numbers::pi);
  NoSlipSample sample;
  problem.creepages = {1.0, 0.0, 0.0};
  sample.c11 = -solver.solve(problem).longitudinal_force / (c * c);
  problem.creepages = {0.0, 1.0, 0.0};
  const RollingSolution lateral = solver.solve(problem);
  sample.c22 = -lateral.lateral_force / (c * c);
  sample.c32 = lateral.spin_moment / (c * c * c);
  problem.creepages = {0.0, 0.0, 1.0};
  const RollingSolution spin = solver.solve(problem);
  sample.c23 = -spin.lateral_force / (c * c * c);
  sample.c33 = -spin.spin_moment / (c * c * c * c);
  return sample;
}

} // namespace wrc::test
