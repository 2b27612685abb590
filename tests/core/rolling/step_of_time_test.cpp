/// Steps of time: between a shift and steady rolling, which are solved by themselves.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rolling/rolling_contact.hpp"
#include "support/errors.hpp"
#include "support/rolling_ellipse.hpp"

namespace wrc::test::step_of_time_test {
namespace {

constexpr Creepages moderate{-0.0012, 0.0008, 0.0003};
constexpr double tolerance = 1e-6;

std::array<double, 3> forces_of(const RollingSolution& solution) {
  return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment / 5.0};
}

void expect_near(const RollingSolution& one, const RollingSolution& other, double difference) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(relative(forces_of(one)[i]), relative(forces_of(other)[i]), difference) << i;
  }
}

/// Slip of the displacements before a step.
struct Before {
  std::vector<double> x, y;

  void put_into(RollingProblem& problem) const {
    problem.slip_x = x;
    problem.slip_y = y;
  }
};

Before slip_after(const RollingSolution& solution, double step_length) {
  Before before{solution.displacement_x, solution.displacement_y};
  for (std::vector<double>* field : {&before.x, &before.y}) {
    for (double& value : *field) {
      value /= -step_length;
    }
  }
  return before;
}

TEST(StepOfTime, IsAShiftAtStandstill) {
  Ellipse ellipse;
  RollingSolver solver;
  constexpr double length = 0.01; // mm
  for (const double size : {0.3, 1.0, 3.0}) {
    const Creepages w{size * 1e-2, -size * 5e-3, size * 1e-3}; // in mm of a shift: mm, rad
    RollingProblem problem = ellipse.problem(w, tolerance);
    problem.motion = TangentialMotion::shift;
    const RollingSolution shift = solver.solve(problem);
    EXPECT_TRUE(shift.displacement_x.empty());
    problem.motion = TangentialMotion::rolling;
    problem.creepages = {w.longitudinal / length, w.lateral / length, w.spin / length};
    problem.step_length = length;
    problem.rolling_share = 0.0;
    const RollingSolution step = solver.solve(problem);
    EXPECT_TRUE(step.converged);
    expect_near(step, shift, 1e-5);
  }
}

TEST(StepOfTime, IsSteadyRollingIfItIsLongOrNothingChanges) {
  Ellipse ellipse;
  RollingSolver solver;
  RollingProblem problem = ellipse.problem(moderate, tolerance);
  const RollingSolution steady = solver.solve(problem);
  problem.step_length = 1e7;
  expect_near(solver.solve(problem), steady, 1e-5);
  // From no tractions, by steps of a fifth of the contact.
  problem.step_length = 2.0;
  RollingSolution step = solver.solve(problem);
  const double first = step.longitudinal_force / steady.longitudinal_force;
  EXPECT_GT(first, 0.1);
  EXPECT_LT(first, 0.6);
  for (int i = 0; i < 60; ++i) {
    const Before before = slip_after(step, problem.step_length);
    before.put_into(problem);
    step = solver.solve(problem);
  }
  expect_near(step, steady, 1e-4);
}

/// A long step leaves the displacements of steady rolling, whatever its iteration leaves.
TEST(StepOfTime, BeginsWithSteadyRollingAfterALongStep) {
  Ellipse ellipse;
  RollingSolver solver;
  RollingProblem problem = ellipse.problem(moderate, 1e-3);
  const RollingSolution steady = solver.solve(problem);
  problem.step_length = 1e10;
  RollingSolution step = solver.solve(problem);
  for (const double length : {2.0, 0.1}) {
    const Before before = slip_after(step, length);
    before.put_into(problem);
    problem.step_length = length;
    step = solver.solve(problem);
    expect_near(step, steady, 5e-3);
  }
}

/// Small steps follow the transient solution of one element's length each.
TEST(StepOfTime, BuildsForcesUpAsTransientRollingDoes) {
  RollingSolver solver;
  Ellipse ellipse;
  RollingProblem transient = ellipse.problem(moderate, 1e-5);
  transient.motion = TangentialMotion::transient;
  RollingProblem problem = ellipse.problem(moderate, 1e-5);
  problem.step_length = problem.grid.longitudinal_step;
  RollingSolution kalker;
  RollingSolution step;
  Before before;
  for (int i = 0; i < 16; ++i) {
    const RollingSolution last = kalker;
    transient.previous_x = last.traction_x;
    transient.previous_y = last.traction_y;
    kalker = solver.solve(transient);
    before = i == 0 ? before : slip_after(step, problem.step_length);
    before.put_into(problem);
    step = solver.solve(problem);
    // The implicit step smooths over sqrt(16) elements; its grid's error is 1 %.
    EXPECT_NEAR(relative(step.longitudinal_force), relative(kalker.longitudinal_force), 0.04) << i;
    EXPECT_NEAR(relative(step.lateral_force), relative(kalker.lateral_force), 0.04) << i;
  }
}

TEST(StepOfTime, AdhesionKeepsTheWholeShift) {
  Ellipse ellipse;
  RollingSolver solver;
  // As loose an iteration as there may be: what it leaves is made up for.
  RollingProblem problem = ellipse.problem({1e-2, 0.0, 0.0}, 0.02);
  problem.step_length = 0.01; // 0.1 um a step
  problem.rolling_share = 0.0;
  RollingSolution step = solver.solve(problem);
  constexpr int steps = 40;
  for (int i = 1; i < steps; ++i) {
    const Before before = slip_after(step, problem.step_length);
    before.put_into(problem);
    step = solver.solve(problem);
  }
  const std::size_t middle = 16 * 32 + 16;
  EXPECT_NEAR(step.displacement_x[middle], -1e-4 * steps, 1e-12);
  problem.slip_x = problem.slip_y = {};
  problem.creepages.longitudinal *= steps;
  problem.tolerance = tolerance;
  const RollingSolution at_once = solver.solve(problem);
  expect_near(step, at_once, 0.02);
}

/// By creepages, and by the share of rolling, against differences.
TEST(StepOfTime, RatesAreThoseOfDifferences) {
  RollingSolver solver;
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem(moderate, 1e-9);
  problem.step_length = 3.0;
  problem.rolling_share = 0.6;
  const RollingSolution first = solver.solve(problem);
  const Before before = slip_after(first, problem.step_length);
  before.put_into(problem);
  problem.creepages.lateral *= 0.5;
  problem.derivatives = true;
  ProblemRate by_share;
  by_share.pressure.assign(problem.pressure.size(), 0.0);
  by_share.rolling_share = 1.0;
  const std::vector<ProblemRate> rates{by_share};
  problem.rates = rates;
  const RollingSolution at = solver.solve(problem);
  problem.derivatives = false;
  problem.rates = {};
  constexpr double share = 1e-3;
  problem.rolling_share += share;
  const std::array<double, 3> ahead = forces_of(solver.solve(problem));
  problem.rolling_share -= 2.0 * share;
  const std::array<double, 3> behind = forces_of(solver.solve(problem));
  problem.rolling_share += share;
  const double scale = std::abs(ahead[0] - behind[0]) / (2.0 * share);
  EXPECT_GT(scale, 1e3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(at.by_rate[0][i] / (i == 2 ? 5.0 : 1.0), (ahead[i] - behind[i]) / (2.0 * share),
                0.02 * scale)
        << i;
  }
  constexpr double creepage = 1e-6;
  problem.creepages.lateral += creepage;
  const std::array<double, 3> left = forces_of(solver.solve(problem));
  EXPECT_NEAR(at.by_creepage[4], (left[1] - forces_of(at)[1]) / creepage,
              0.02 * std::abs(at.by_creepage[4]));
}

TEST(StepOfTime, RefusesWhatIsNone) {
  Ellipse ellipse;
  const auto with = [&](double length, double share, double difference) {
    RollingProblem problem = ellipse.problem(moderate);
    problem.step_length = length;
    problem.rolling_share = share;
    problem.difference_parameter = difference;
    return problem;
  };
  expect_error(
      ErrorCode::invalid_argument, [&] { check_problem(with(-1.0, 1.0, 0.0)); }, "step_length");
  expect_error(
      ErrorCode::invalid_argument, [&] { check_problem(with(std::nan(""), 1.0, 0.0)); },
      "step_length");
  expect_error(
      ErrorCode::invalid_argument, [&] { check_problem(with(1.0, 1.5, 0.0)); }, "rolling_share");
  expect_error(
      ErrorCode::invalid_argument, [&] { check_problem(with(1.0, 1.0, 0.1)); },
      "difference_parameter");
}

} // namespace
} // namespace wrc::test::step_of_time_test
