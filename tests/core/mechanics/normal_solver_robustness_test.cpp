/// Cases that broke trials of such solvers: least grids, single elements, split, sharp and rough
/// contacts, extreme elements, loads, lengths and sizes. Each at four tolerances, for a load and
/// for an approach, with the conditions recomputed and p compared with the exact answer.
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "half_space/displacement_operator.hpp"
#include "half_space/influence_coefficients.hpp"
#include "pressure/pressure_field.hpp"
#include "support/dense_reference.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::normal_solver_robustness_test {
namespace {

/// Cholesky factors of a matrix whose condition is some hundreds, and the exact tolerance.
constexpr double dense_agreement = 1e-10;

void expect_dense_answer(const Grid& grid, const std::vector<double>& distance,
                         const PatchSolution& solution, const std::string& name) {
  const PatchProblem by_load = with_load(grid, distance, solution.normal_force, exact_tolerance);
  EXPECT_LE(pressure_error(solution.pressure, solve_densely(by_load).pressure), dense_agreement)
      << name;
  const PatchProblem by_approach =
      with_approach(grid, distance, solution.approach, exact_tolerance);
  EXPECT_LE(
      pressure_error(solve_exactly(by_approach).pressure, solve_densely(by_approach).pressure),
      dense_agreement)
      << name << ", approach";
}

TEST(NormalSolverRobustness, LeastGrids) {
  using Size = std::pair<std::size_t, std::size_t>;
  NormalSolver solver;
  for (const auto& [rows, columns] :
       {Size{1, 1}, Size{1, 2}, Size{1, 9}, Size{9, 1}, Size{2, 3}, Size{3, 2}, Size{5, 7}}) {
    for (const double aspect : {1.0 / 200.0, 1.0, 100.0}) {
      const Grid grid = centred_grid(rows, columns, 0.5, 0.5 * aspect);
      const double area = grid.element_area() * static_cast<double>(grid.element_count());
      // From one element in contact to all of them.
      for (const double mean_pressure : {0.1, 100.0, 1e5}) {
        const std::string name = std::to_string(rows) + " x " + std::to_string(columns) +
                                 ", aspect " + std::to_string(aspect) + ", mean pressure " +
                                 std::to_string(mean_pressure);
        for (const double curvature : {0.0, 1.0 / 200.0}) {
          std::vector<double> distance = hertz_gap(grid, curvature, curvature);
          const PatchSolution exact =
              expect_solved(solver, grid, distance, mean_pressure * area, name);
          expect_dense_answer(grid, distance, exact, name);
        }
      }
    }
  }
}

TEST(NormalSolverRobustness, LongNarrowGrids) {
  using Size = std::pair<std::size_t, std::size_t>;
  NormalSolver solver;
  for (const auto& [rows, columns] : {Size{1, 100}, Size{100, 1}, Size{251, 2}, Size{2, 251}}) {
    for (const ContactCase& example : contact_cases(rows, columns, 1.0)) {
      expect_solved(solver, example.grid, example.distance, case_load,
                    example.name + ", " + std::to_string(rows) + " rows");
    }
  }
}

TEST(NormalSolverRobustness, OneElementInContact) {
  NormalSolver solver;
  const Grid small = centred_grid(15, 13, 0.1, 0.1);
  std::vector<double> distance = hertz_gap(small, 1.0, 1.0);
  const std::size_t place = 5 * 13 + 4;
  distance[place] = -0.01;
  const PatchSolution single = expect_solved(solver, small, distance, 1.0, "small grid");
  EXPECT_DOUBLE_EQ(single.pressure[place], 100.0);
  EXPECT_EQ(std::count(single.pressure.begin(), single.pressure.end(), 0.0), 15 * 13 - 1);
  expect_dense_answer(small, distance, single, "small grid");

  // The coarser grids see little of the peak, and at the higher load the rest touches as well.
  const Grid large = centred_grid(150, 130, 0.1, 0.1);
  distance = hertz_gap(large, 1e-4, 1e-4);
  distance[50 * 130 + 40] = -0.01;
  for (const double load : {1.0, 10.0, 1000.0}) {
    expect_solved(solver, large, distance, load, "large grid, load " + std::to_string(load));
  }
}

TEST(NormalSolverRobustness, AllGapsAtAllLoadsAndElementShapes) {
  NormalSolver solver;
  for (const double aspect : {1.0 / 200.0, 1.0, 100.0}) {
    for (const ContactCase& example : contact_cases(41, 37, aspect)) {
      for (const double factor : {1e-4, 1.0, 100.0, 1e4}) {
        expect_solved(solver, example.grid, example.distance, case_load * aspect * factor,
                      example.name + ", aspect " + std::to_string(aspect) + ", load x " +
                          std::to_string(factor));
      }
    }
  }
}

TEST(NormalSolverRobustness, LeastLoads) {
  // An approach cannot be prescribed here: its rounding is no longer small against displacements.
  NormalSolver solver;
  for (const double aspect : {1.0 / 200.0, 1.0, 100.0}) {
    for (const ContactCase& example : contact_cases(41, 37, aspect)) {
      const double load = case_load * aspect * 1e-9;
      PatchProblem problem = with_load(example.grid, example.distance, load, exact_tolerance);
      const PatchSolution exact = solve_exactly(problem);
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
        problem.tolerance = tolerance;
        expect_answer(problem, solver.solve(problem), exact.pressure, example.name);
      }
    }
  }
}

TEST(NormalSolverRobustness, AllGapsAtAllLengths) {
  NormalSolver solver;
  for (const double length : {1e-15, 1e-6, 1e6, 1e18}) {
    for (ContactCase& example : contact_cases(37, 41, 1.0)) {
      Grid& grid = example.grid;
      grid.lateral_step *= length;
      grid.longitudinal_step *= length;
      grid.lateral_first *= length;
      grid.longitudinal_first *= length;
      for (double& value : example.distance) {
        value *= length;
      }
      expect_solved(solver, grid, example.distance, case_load * length * length,
                    example.name + ", lengths x " + std::to_string(length));
    }
  }
}

TEST(NormalSolverRobustness, AwkwardSizes) {
  using Size = std::pair<std::size_t, std::size_t>;
  NormalSolver solver;
  // Primes, and sizes just around those at which the cascade gets another grid.
  for (const auto& [rows, columns] :
       {Size{127, 61}, Size{33, 16}, Size{33, 15}, Size{32, 32}, Size{16, 500}}) {
    for (const ContactCase& example : contact_cases(rows, columns, 1.0)) {
      expect_solved(solver, example.grid, example.distance, case_load,
                    example.name + ", " + std::to_string(rows) + " rows");
    }
  }
  for (const ContactCase& example : contact_cases(300, 150, 1.0)) {
    const PatchProblem problem = with_load(example.grid, example.distance, case_load, 1e-6);
    expect_answer(problem, solver.solve(problem), solve_exactly(problem).pressure,
                  example.name + ", 300 x 150");
  }
}

/// Two round bodies; the second one `depth` lower than the first one's displacements leave room.
class TwoContacts {
public:
  TwoContacts() {
    const std::vector<double> alone = gap_with(1.0);
    const PatchSolution first = solve_exactly(with_load(grid, alone, load, exact_tolerance));
    std::vector<double> displacement(grid.element_count());
    DisplacementOperator(grid, steel_modulus).apply(first.pressure, displacement);
    room_ = first.approach - displacement[place];
    largest_ = *std::max_element(displacement.begin(), displacement.end());
  }
  [[nodiscard]] std::vector<double> pressed_in(double share) const {
    return gap_with(room_ - share * largest_);
  }

  static constexpr double load = 1000.0;
  static constexpr std::size_t place = (31 + 26) * 24 + 12;
  const Grid grid = centred_grid(64, 24, 0.2, 0.2);

private:
  [[nodiscard]] std::vector<double> gap_with(double height) const {
    std::vector<double> distance = hertz_gap(grid, 1.0 / 100.0, 1.0 / 100.0);
    for (std::size_t index = 0; index < distance.size(); ++index) {
      const double x = grid.longitudinal(index % 24) - grid.longitudinal(place % 24);
      const double y = grid.lateral(index / 24) - grid.lateral(place / 24);
      distance[index] = std::min(distance[index], (x * x + y * y) / 60.0 + height);
    }
    return distance;
  }

  double room_ = 0.0;
  double largest_ = 0.0;
};

TEST(NormalSolverRobustness, SecondContactBarelyPressedIn) {
  const TwoContacts bodies;
  NormalSolver solver;
  for (const double share : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const std::vector<double> distance = bodies.pressed_in(share);
    const std::string name = "pressed in by " + std::to_string(share);
    const PatchSolution exact =
        expect_solved(solver, bodies.grid, distance, TwoContacts::load, name);
    EXPECT_EQ(pressure_regions(bodies.grid, exact.pressure).size(), 2U) << name;
  }
}

TEST(NormalSolverRobustness, SecondContactBelowTheRoundingOfSinglePrecision) {
  // Its pressure is some 6e-6 and 6e-7 of the largest; an independent solver finds it too.
  const TwoContacts bodies;
  NormalSolver solver;
  for (const double share : {1e-6, 1e-7}) {
    const std::vector<double> distance = bodies.pressed_in(share);
    PatchProblem problem = with_load(bodies.grid, distance, TwoContacts::load, 1e-9);
    const PatchSolution exact = solve_with_polonsky_keer(problem);
    EXPECT_EQ(pressure_regions(bodies.grid, exact.pressure).size(), 2U);
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-7, 1e-8}) {
      problem.tolerance = tolerance;
      expect_answer(problem, solver.solve(problem), exact.pressure, std::to_string(share));
    }
  }
}

} // namespace
} // namespace wrc::test::normal_solver_robustness_test
