/// What every answer must satisfy: nothing kept between calls shows, both precisions and both
/// methods agree; and of each method symmetry, shift, invariance of units and scale.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "pressure/pressure_field.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::normal_solver_properties_test {
namespace {

constexpr double fine_tolerance = 1e-9;
/// Errors of Polonsky & Keer's pressures over the tolerance of its gaps: up to 70 seen.
constexpr double paper_amplification = 150.0;

void expect_same_bits(const PatchSolution& left, const PatchSolution& right,
                      const std::string& name) {
  EXPECT_EQ(left.pressure, right.pressure) << name;
  EXPECT_EQ(left.approach, right.approach) << name;
  EXPECT_EQ(left.normal_force, right.normal_force) << name;
  EXPECT_EQ(left.iterations, right.iterations) << name;
  EXPECT_EQ(left.stop_reason, right.stop_reason) << name;
}

TEST(NormalSolver, CachedDataChangeNoBit) {
  for (const Precision precision : {Precision::mixed, Precision::double_only}) {
    NormalSolver warm(PlannerRigor::estimate, precision);
    // Twice the same round: other sizes and element shapes come in between.
    for (int round = 0; round < 2; ++round) {
      for (const auto& [rows, columns] :
           {std::pair<std::size_t, std::size_t>{70, 50}, {24, 24}, {33, 61}, {7, 100}}) {
        for (const double aspect : {1.0, 1.0 / 30.0}) {
          for (const ContactCase& example : contact_cases(rows, columns, aspect)) {
            const double tolerance = round == 0 ? 1e-3 : 1e-7;
            const PatchProblem by_load =
                with_load(example.grid, example.distance, case_load * aspect, tolerance);
            const PatchSolution loaded = warm.solve(by_load);
            expect_same_bits(loaded, NormalSolver(PlannerRigor::estimate, precision).solve(by_load),
                             example.name);
            const PatchProblem by_approach =
                with_approach(example.grid, example.distance, loaded.approach, tolerance);
            expect_same_bits(warm.solve(by_approach),
                             NormalSolver(PlannerRigor::estimate, precision).solve(by_approach),
                             example.name + ", approach");
          }
        }
      }
    }
  }
}

TEST(NormalSolver, MovedObjectsSolve) {
  const Grid grid = centred_grid(40, 30, 0.2, 0.2);
  const std::vector<double> distance = hertz_gap(grid, 1e-2, 1e-2);
  const PatchProblem problem = with_load(grid, distance, 1000.0, 1e-6);
  NormalSolver first;
  const PatchSolution expected = first.solve(problem);
  NormalSolver second(std::move(first));
  expect_same_bits(second.solve(problem), expected, "moved into a new one");
  NormalSolver third(PlannerRigor::estimate, Precision::double_only);
  third = std::move(second);
  expect_same_bits(third.solve(problem), expected, "moved into another");
}

TEST(NormalSolver, PrecisionsAgree) {
  NormalSolver mixed;
  NormalSolver precise(PlannerRigor::estimate, Precision::double_only);
  for (const ContactCase& example : contact_cases(64, 50, 1.0)) {
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      const PatchProblem problem = with_load(example.grid, example.distance, case_load, tolerance);
      const PatchSolution left = mixed.solve(problem);
      const PatchSolution right = precise.solve(problem);
      EXPECT_LE(pressure_error(left.pressure, right.pressure) / tolerance, 2.0)
          << example.name << " " << tolerance;
      // The approach is a mean over contact: far better than the largest error of p.
      EXPECT_NEAR(left.approach / right.approach, 1.0, tolerance) << example.name;
    }
  }
}

TEST(NormalSolver, MethodsAgree) {
  NormalSolver solver;
  for (const double aspect : {1.0, 6.0}) {
    for (const ContactCase& example : contact_cases(41, 37, aspect)) {
      const PatchProblem by_load =
          with_load(example.grid, example.distance, case_load * aspect, fine_tolerance);
      const PatchSolution paper = solve_with_polonsky_keer(by_load);
      const PatchSolution loaded = solver.solve(by_load);
      EXPECT_LE(pressure_error(loaded.pressure, paper.pressure),
                paper_amplification * fine_tolerance)
          << example.name;
      EXPECT_NEAR(loaded.approach / paper.approach, 1.0, paper_amplification * fine_tolerance);
      const PatchProblem by_approach =
          with_approach(example.grid, example.distance, paper.approach, fine_tolerance);
      const PatchSolution pressed = solver.solve(by_approach);
      EXPECT_LE(pressure_error(pressed.pressure,
                               PatchSolution(solve_with_polonsky_keer(by_approach)).pressure),
                paper_amplification * fine_tolerance)
          << example.name << ", approach";
    }
  }
}

/// What holds for the default method and for that of Polonsky & Keer.
class EachMethod : public testing::TestWithParam<bool> {
protected:
  PatchSolution solve(const PatchProblem& problem) {
    return is_paper ? solve_with_polonsky_keer(problem) : solver_.solve(problem);
  }
  const bool is_paper = GetParam();
  /// Two answers, each within the tolerance of the same exact one.
  const double same_answer = 2.0 * fine_tolerance * (is_paper ? paper_amplification : 1.0);

private:
  NormalSolver solver_;
};
INSTANTIATE_TEST_SUITE_P(Methods, EachMethod, testing::Bool(), [](const auto& tested) {
  return std::string(tested.param ? "PolonskyKeer" : "Default");
});

/// Rows, columns or both in reverse order.
std::vector<double> mirror(const Grid& grid, const std::vector<double>& values, bool rows,
                           bool columns) {
  std::vector<double> result(values.size());
  for (std::size_t index = 0; index < values.size(); ++index) {
    const std::size_t row = index / grid.longitudinal_count;
    const std::size_t column = index % grid.longitudinal_count;
    result[(rows ? grid.lateral_count - 1 - row : row) * grid.longitudinal_count +
           (columns ? grid.longitudinal_count - 1 - column : column)] = values[index];
  }
  return result;
}

TEST_P(EachMethod, MirroredGapGivesMirroredPressure) {
  for (const auto& [rows, columns] : {std::pair<std::size_t, std::size_t>{24, 19}, {70, 45}}) {
    for (const ContactCase& example : contact_cases(rows, columns, 1.0)) {
      const PatchSolution straight =
          solve(with_load(example.grid, example.distance, case_load, fine_tolerance));
      for (const auto& [flip_rows, flip_columns] :
           {std::pair{true, false}, {false, true}, {true, true}}) {
        const std::vector<double> mirrored =
            mirror(example.grid, example.distance, flip_rows, flip_columns);
        const PatchSolution reflected =
            solve(with_load(example.grid, mirrored, case_load, fine_tolerance));
        EXPECT_LE(pressure_error(mirror(example.grid, reflected.pressure, flip_rows, flip_columns),
                                 straight.pressure),
                  same_answer)
            << example.name;
      }
    }
  }
}

TEST_P(EachMethod, TransposedGapGivesTransposedPressure) {
  for (const ContactCase& example : contact_cases(70, 45, 3.0)) {
    const Grid& grid = example.grid;
    const Grid turned = centred_grid(grid.longitudinal_count, grid.lateral_count,
                                     grid.longitudinal_step, grid.lateral_step);
    const auto transpose = [&](const std::vector<double>& values, std::size_t columns) {
      std::vector<double> result(values.size());
      for (std::size_t index = 0; index < values.size(); ++index) {
        result[index % columns * (values.size() / columns) + index / columns] = values[index];
      }
      return result;
    };
    const std::vector<double> distance = transpose(example.distance, grid.longitudinal_count);
    const PatchSolution straight =
        solve(with_load(grid, example.distance, 3.0 * case_load, fine_tolerance));
    const PatchSolution across =
        solve(with_load(turned, distance, 3.0 * case_load, fine_tolerance));
    EXPECT_LE(
        pressure_error(transpose(across.pressure, turned.longitudinal_count), straight.pressure),
        same_answer)
        << example.name;
  }
}

TEST_P(EachMethod, ShiftByOneElementShiftsThePressure) {
  const Grid grid = centred_grid(73, 58, 0.1, 0.12);
  Grid moved = grid;
  moved.lateral_first += grid.lateral_step;
  moved.longitudinal_first += grid.longitudinal_step;
  const std::vector<double> first = hertz_gap(grid, 1.0 / 400.0, 1.0 / 100.0);
  const std::vector<double> second = hertz_gap(moved, 1.0 / 400.0, 1.0 / 100.0);
  const PatchSolution before = solve(with_load(grid, first, 2000.0, fine_tolerance));
  const PatchSolution after = solve(with_load(moved, second, 2000.0, fine_tolerance));
  std::vector<double> shifted(before.pressure.size(), 0.0);
  for (std::size_t row = 1; row < grid.lateral_count; ++row) {
    std::copy_n(before.pressure.data() + row * 58 + 1, 57, shifted.data() + (row - 1) * 58);
  }
  EXPECT_LE(pressure_error(after.pressure, shifted), same_answer);
}

TEST(NormalSolver, UnitsInPowersOfTwoChangeNoBit) {
  NormalSolver solver;
  for (const ContactCase& example : contact_cases(45, 50, 2.0)) {
    const PatchSolution expected =
        solver.solve(with_load(example.grid, example.distance, case_load, 1e-6));
    for (const double length : {0x1p-40, 0x1p20}) {
      for (const double stress : {0x1p-20, 0x1p30}) {
        Grid grid = example.grid;
        grid.lateral_step *= length;
        grid.longitudinal_step *= length;
        std::vector<double> distance = example.distance;
        for (double& value : distance) {
          value *= length;
        }
        PatchProblem problem =
            with_load(grid, distance, case_load * stress * length * length, 1e-6);
        problem.combined_modulus *= stress;
        PatchSolution solution = solver.solve(problem);
        for (double& value : solution.pressure) {
          value /= stress;
        }
        EXPECT_EQ(solution.pressure, expected.pressure) << example.name;
        EXPECT_EQ(solution.approach, expected.approach * length) << example.name;
      }
    }
  }
}

TEST_P(EachMethod, PressuresOfAPunchAreProportionalToTheLoad) {
  const Grid grid = centred_grid(40, 62, 0.2, 0.1);
  const std::vector<double> flat(grid.element_count(), 0.0);
  const PatchSolution unit = solve(with_load(grid, flat, 1.0, fine_tolerance));
  EXPECT_GT(*std::min_element(unit.pressure.begin(), unit.pressure.end()), 0.0);
  for (const double load : {1e-9, 3.0, 1e12}) {
    PatchSolution scaled = solve(with_load(grid, flat, load, fine_tolerance));
    for (double& value : scaled.pressure) {
      value /= load;
    }
    EXPECT_LE(pressure_error(scaled.pressure, unit.pressure), same_answer);
    EXPECT_NEAR(scaled.approach / load / unit.approach, 1.0, same_answer);
  }
}

TEST_P(EachMethod, AddedHeightMovesTheApproachOnly) {
  const Grid grid = centred_grid(50, 40, 0.2, 0.2);
  std::vector<double> distance = hertz_gap(grid, 1.0 / 128.0, 1.0 / 64.0);
  const PatchSolution low = solve(with_load(grid, distance, 3000.0, fine_tolerance));
  for (double& value : distance) {
    value -= 0.5;
  }
  const PatchSolution high = solve(with_load(grid, distance, 3000.0, fine_tolerance));
  EXPECT_LE(pressure_error(high.pressure, low.pressure), same_answer);
  EXPECT_NEAR(high.approach, low.approach - 0.5, load_rounding);
}

TEST_P(EachMethod, NothingPressedNothingIsSolved) {
  const Grid grid = centred_grid(4, 5, 1.0, 1.0);
  std::vector<double> distance(20, 1e3);
  distance[7] = -0.25;
  const PatchSolution unloaded = solve(with_load(grid, distance, 0.0, 1e-6));
  EXPECT_EQ(unloaded.approach, -0.25);
  const PatchSolution apart = solve(with_approach(grid, distance, -0.3, 1e-6));
  EXPECT_EQ(apart.approach, -0.3);
  const PatchSolution touching = solve(with_approach(grid, distance, -0.25, 1e-6));
  for (const PatchSolution& solution : {unloaded, apart, touching}) {
    EXPECT_EQ(solution.pressure, std::vector<double>(20, 0.0));
    EXPECT_EQ(solution.normal_force, 0.0);
    EXPECT_EQ(solution.iterations, 0);
    const Residuals residuals =
        compute_residuals(with_approach(grid, distance, solution.approach, 1e-6), solution.pressure,
                          solution.approach);
    EXPECT_EQ(residuals.complementarity, 0.0);
    EXPECT_GE(residuals.least_gap, 0.0);
    EXPECT_EQ(residuals.load_balance, 0.0);
    EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met);
  }
}

TEST(NormalSolver, StopsAreNamedAndBadToleranceIsRefused) {
  const Grid grid = centred_grid(40, 24, 0.2, 0.2);
  const std::vector<double> distance = hertz_gap(grid, 1.0 / 300.0, 1.0 / 300.0);
  PatchProblem problem = with_load(grid, distance, 4000.0, 1e-8);
  for (const Precision precision : {Precision::mixed, Precision::double_only}) {
    NormalSolver solver(PlannerRigor::estimate, precision);
    problem.maximum_iterations = 2;
    problem.tolerance = 1e-8;
    const PatchSolution early = solver.solve(problem);
    EXPECT_EQ(early.stop_reason, StopReason::iteration_limit);
    EXPECT_LE(compute_residuals(problem, early.pressure, early.approach).load_balance,
              load_rounding);
    problem.maximum_iterations = 5000;
    // Out of reach: the answer is as good as rounding allows, and the iteration ends.
    problem.tolerance = 1e-17;
    const PatchSolution floor = solver.solve(problem);
    EXPECT_NE(floor.stop_reason, StopReason::iteration_limit);
    EXPECT_LE(compute_residuals(problem, floor.pressure, floor.approach).complementarity, 1e-12);
    // A refused problem leaves the object usable.
    problem.tolerance = 0.2;
    EXPECT_THROW(solver.solve(problem), Error);
    problem.tolerance = 1e-17;
    expect_same_bits(solver.solve(problem), floor, "after a refusal");
  }
}

} // namespace
} // namespace wrc::test::normal_solver_properties_test
