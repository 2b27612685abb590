#include "rolling/unlike_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "rolling/constants.hpp"

namespace wrc {

namespace {

/// Pressures with the change from one normal solution to another, of the same load; none where the
/// contact that is given does not reach.
void add_change(std::span<const double> given, std::span<const double> covered,
                const std::vector<double>& from, const std::vector<double>& to,
                std::vector<double>& pressure) {
  double sum = 0.0;
  double given_sum = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const bool reached = covered.empty() || covered[i] > 0.0;
    pressure[i] = reached ? std::max(given[i] + to[i] - from[i], 0.0) : 0.0;
    sum += pressure[i];
    given_sum += given[i];
  }
  for (double& p : pressure) {
    p *= sum > 0.0 ? given_sum / sum : 0.0;
  }
}

} // namespace

UnlikeSolution solve_unlike(const RollingProblem& problem, std::span<const double> distance,
                            double combined_modulus, double tolerance, RollingSolver& rolling) {
  UnlikeSolution result;
  result.pressure.assign(problem.pressure.begin(), problem.pressure.end());
  RollingProblem tangential = problem;
  tangential.pressure = result.pressure;
  result.rolling = rolling.solve(tangential);
  if (result.rolling.normal_displacement.empty()) {
    result.converged = result.rolling.converged;
    return result;
  }
  const double area = problem.grid.element_area();
  const double load = area * std::accumulate(problem.pressure.begin(), problem.pressure.end(), 0.0);
  std::vector<double> opened(distance.begin(), distance.end());
  const PatchGap patch{problem.grid, opened};
  NormalProblem normal;
  normal.patches = {&patch, 1};
  normal.combined_modulus = combined_modulus;
  normal.load = load;
  normal.tolerance = std::min(tolerance, unlike_normal_tolerance);
  normal.elements = Elements::smooth;
  NormalSolver solver;
  const std::vector<double> without = solver.solve(normal).patches.front().pressure;
  while (result.alternations < alternation_limit && !result.converged) {
    ++result.alternations;
    std::transform(distance.begin(), distance.end(), result.rolling.normal_displacement.begin(),
                   opened.begin(), std::plus<>());
    add_change(problem.pressure, problem.covered, without,
               solver.solve(normal).patches.front().pressure, result.pressure);
    RollingSolution next = rolling.solve(tangential);
    const double moved = std::hypot(next.longitudinal_force - result.rolling.longitudinal_force,
                                    next.lateral_force - result.rolling.lateral_force);
    next.iterations += result.rolling.iterations;
    next.convolutions += result.rolling.convolutions;
    result.converged = next.converged && moved <= tolerance * problem.friction * load;
    result.rolling = std::move(next);
  }
  for (std::size_t i = 0; i < result.pressure.size(); ++i) {
    result.pressure_change += area / load * std::abs(result.pressure[i] - problem.pressure[i]);
  }
  return result;
}

} // namespace wrc
