/// Random problems: quadratic and wavy gaps, element shapes, sizes, loads and tolerances.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/dense_reference.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::normal_solver_random_test {
namespace {

constexpr int problem_count = 64;
constexpr std::size_t longest_side = 60;
/// Dense answers take the cube of the number of elements.
constexpr std::size_t most_dense_elements = 400;
/// Cholesky factors of up to 400 elements, and the exact tolerance.
constexpr double dense_agreement = 1e-9;

struct RandomProblem {
  Grid grid;
  std::vector<double> distance;
  double approach = 0.0;
};

RandomProblem draw(std::mt19937_64& generator) {
  const auto between = [&](double least, double largest) {
    return least + (largest - least) * uniform(generator);
  };
  const auto by_ratio = [&](double least, double largest) {
    return least * std::pow(largest / least, uniform(generator));
  };
  RandomProblem problem;
  const std::size_t rows = 1 + generator() % longest_side;
  const std::size_t columns = 1 + generator() % longest_side;
  const double step = by_ratio(0.01, 1.0);
  problem.grid = centred_grid(rows, columns, step * by_ratio(1.0 / 200.0, 100.0), step);
  const double length = step * static_cast<double>(columns);
  const double width = problem.grid.lateral_step * static_cast<double>(rows);
  const double height = std::min(length, width) * by_ratio(1e-4, 1.0);
  const double xx = by_ratio(0.01, 20.0);
  const double yy = by_ratio(0.01, 20.0);
  const double xy = between(-1.0, 1.0) * std::sqrt(xx * yy);
  const double wave = between(0.0, 0.3);
  const double x_waves = between(0.0, 40.0);
  const double y_waves = between(0.0, 40.0);
  const double phase = between(0.0, 6.0);
  const double x_centre = between(-0.6, 0.6);
  const double y_centre = between(-0.6, 0.6);
  for (std::size_t index = 0; index < problem.grid.element_count(); ++index) {
    const double x = problem.grid.longitudinal(index % columns) / length - x_centre;
    const double y = problem.grid.lateral(index / columns) / width - y_centre;
    problem.distance.push_back(height *
                               (xx * x * x + yy * y * y + xy * x * y +
                                wave * std::sin(x_waves * x + phase) * std::cos(y_waves * y)));
  }
  const auto [least, largest] =
      std::minmax_element(problem.distance.begin(), problem.distance.end());
  problem.approach = *least + (*largest - *least + 1e-9 * height) * by_ratio(3e-4, 4.0);
  return problem;
}

TEST(RandomProblems, AreSolved) {
  std::mt19937_64 generator(64);
  NormalSolver mixed;
  NormalSolver precise(PlannerRigor::estimate, Precision::double_only);
  int dense_count = 0;
  for (int number = 0; number < problem_count; ++number) {
    const RandomProblem random = draw(generator);
    const std::string name = "problem " + std::to_string(number);
    PatchProblem problem =
        with_approach(random.grid, random.distance, random.approach, exact_tolerance);
    problem.elements = number % 4 < 2 ? Elements::constant : Elements::smooth;
    PatchSolution exact = solve_exactly(problem);
    if (number % 2 == 1) {
      const Elements elements = problem.elements;
      problem = with_load(random.grid, random.distance, exact.normal_force, exact_tolerance);
      problem.elements = elements;
      exact = solve_exactly(problem);
    }
    if (random.grid.element_count() <= most_dense_elements) {
      ++dense_count;
      EXPECT_LE(pressure_error(exact.pressure, solve_densely(problem).pressure), dense_agreement)
          << name;
    }
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
      problem.tolerance = tolerance;
      expect_answer(problem, mixed.solve(problem), exact.pressure, name + ", mixed");
      expect_answer(problem, precise.solve(problem), exact.pressure, name + ", double");
    }
  }
  EXPECT_GT(dense_count, problem_count / 4);
}

} // namespace
} // namespace wrc::test::normal_solver_random_test
