/// Rigid slip given for each element: what is planar in it counts as creepages do, the rest by its
/// own rates and power.
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "rolling/fastsim.hpp"
#include "rolling/rolling_contact.hpp"
#include "support/errors.hpp"
#include "support/rolling_ellipse.hpp"

namespace wrc::test::given_slip_test {
namespace {

constexpr Creepages moderate{-0.0012, 0.0008, 0.0003};

struct Slip {
  std::vector<double> x, y;
};

/// Of creepages, and with a part that no creepages have: it bends across and along.
Slip slip_of(const Grid& grid, const Creepages& creepages, double bend) {
  Slip slip;
  for (std::size_t j = 0; j < grid.lateral_count; ++j) {
    for (std::size_t i = 0; i < grid.longitudinal_count; ++i) {
      const double x = grid.longitudinal(i);
      const double y = grid.lateral(j);
      slip.x.push_back(creepages.longitudinal - creepages.spin * y + bend * y * y);
      slip.y.push_back(creepages.lateral + creepages.spin * x + 2.0 * bend * x * y);
    }
  }
  return slip;
}

std::array<double, 3> forces_of(const RollingSolution& solution) {
  return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment};
}

void expect_equal(const RollingSolution& one, const RollingSolution& other, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(forces_of(one)[i], forces_of(other)[i],
                tolerance * friction * load * (i == 2 ? 5.0 : 1.0))
        << i;
  }
  EXPECT_NEAR(one.friction_power, other.friction_power, tolerance * std::abs(one.friction_power));
}

// Half of the creepages as creepages, half as a field: on all grids of the cascade, in each motion
// and for FASTSIM, but for rounding.
TEST(GivenSlip, CountsAsCreepagesDo) {
  RollingSolver solver;
  for (const TangentialMotion motion :
       {TangentialMotion::rolling, TangentialMotion::transient, TangentialMotion::shift}) {
    Ellipse ellipse;
    const double size = motion == TangentialMotion::shift ? 5.0 : 1.0;
    const Creepages whole{size * moderate.longitudinal, size * moderate.lateral,
                          size * moderate.spin};
    const Creepages half{0.5 * whole.longitudinal, 0.5 * whole.lateral, 0.5 * whole.spin};
    RollingProblem problem = ellipse.problem(whole, 1e-6);
    problem.motion = motion;
    const RollingSolution by_creepages = solver.solve(problem);
    const Slip slip = slip_of(problem.grid, half, 0.0);
    problem.creepages = half;
    problem.slip_x = slip.x;
    problem.slip_y = slip.y;
    const RollingSolution by_slip = solver.solve(problem);
    SCOPED_TRACE(static_cast<int>(motion));
    expect_equal(by_creepages, by_slip, 1e-5);
    EXPECT_NEAR(by_creepages.numerical_loss, by_slip.numerical_loss, 1e-4);
  }
  // FASTSIM has a flexibility of its own for spin, which a field has no part in.
  Ellipse ellipse;
  const Creepages translation{moderate.longitudinal, moderate.lateral, 0.0};
  RollingProblem problem = ellipse.problem(translation);
  const Flexibilities flexibilities = flexibilities_of(problem, solver);
  const RollingSolution by_creepages = solve_with_fastsim(problem, flexibilities);
  const Slip slip = slip_of(problem.grid, translation, 0.0);
  problem.creepages = {};
  problem.slip_x = slip.x;
  problem.slip_y = slip.y;
  expect_equal(by_creepages, solve_with_fastsim(problem, flexibilities), 1e-9);
}

// With large slips of any shape tractions are mu p against them: a sum of its own.
TEST(GivenSlip, TractionsOpposeTheSlipOfEachElement) {
  RollingSolver solver;
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem({}, 1e-5);
  const Slip slip = slip_of(problem.grid, {0.05, 0.02, 0.0}, 2e-3);
  problem.slip_x = slip.x;
  problem.slip_y = slip.y;
  const RollingSolution solution = solver.solve(problem);
  std::array<double, 3> sums{};
  double power = 0.0;
  for (std::size_t i = 0; i < problem.pressure.size(); ++i) {
    const double size = std::hypot(slip.x[i], slip.y[i]);
    const double bound = problem.grid.element_area() * friction * problem.pressure[i];
    const double x = -bound * slip.x[i] / size;
    const double y = -bound * slip.y[i] / size;
    sums[0] += x;
    sums[1] += y;
    sums[2] += problem.grid.longitudinal(i % problem.grid.longitudinal_count) * y -
               problem.grid.lateral(i / problem.grid.longitudinal_count) * x;
    power += bound * size;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    // What tractions displace turns the slip a little: 2e-3 of it.
    EXPECT_NEAR(forces_of(solution)[i], sums[i], 5e-3 * friction * load) << i;
  }
  EXPECT_NEAR(solution.friction_power, power, 2e-3 * power);
  EXPECT_EQ(solution.adhesion_area, 0.0);
}

/// The field's own rates, those of the weights, and of a weighted sum by creepages.
TEST(GivenSlip, RatesAreThoseOfDifferences) {
  RollingSolver solver;
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem(moderate, 1e-8);
  const Slip slip = slip_of(problem.grid, {}, 2e-5);
  const Slip change = slip_of(problem.grid, {1e-4, -2e-4, 0.0}, -1e-5);
  const Slip weights = slip_of(problem.grid, {0.1, 0.2, 0.03}, 0.01);
  problem.slip_x = slip.x;
  problem.slip_y = slip.y;
  problem.weight_x = weights.x;
  problem.weight_y = weights.y;
  ProblemRate rate;
  rate.pressure.resize(problem.pressure.size());
  rate.slip_x = change.x;
  rate.slip_y = change.y;
  rate.weight_x = change.y;
  rate.weight_y = change.x;
  problem.rates = {&rate, 1};
  problem.derivatives = true;
  const RollingSolution found = solver.solve(problem);
  problem.rates = {};
  problem.derivatives = false;
  constexpr double step = 1e-3;
  const auto after = [&](double along, const Creepages& creepages) {
    const auto moved = [along](const std::vector<double>& now, const std::vector<double>& by) {
      std::vector<double> later(now);
      for (std::size_t i = 0; i < later.size(); ++i) {
        later[i] += along * by[i];
      }
      return later;
    };
    const std::vector<double> x = moved(slip.x, change.x);
    const std::vector<double> y = moved(slip.y, change.y);
    const std::vector<double> weight_x = moved(weights.x, rate.weight_x);
    const std::vector<double> weight_y = moved(weights.y, rate.weight_y);
    RollingProblem other = problem;
    other.slip_x = x;
    other.slip_y = y;
    other.weight_x = weight_x;
    other.weight_y = weight_y;
    other.creepages = creepages;
    const RollingSolution solution = solver.solve(other);
    return std::array<double, 4>{solution.longitudinal_force, solution.lateral_force,
                                 solution.spin_moment, solution.weighted_force};
  };
  const auto ahead = after(step, moderate);
  const auto behind = after(-step, moderate);
  for (std::size_t force = 0; force < ahead.size(); ++force) {
    const double unit = friction * load * (force == 2 ? 5.0 : 1.0);
    const double difference = (ahead[force] - behind[force]) / (2.0 * step);
    EXPECT_NEAR(found.by_rate.at(0)[force] / unit, difference / unit, 1.5e-3) << force;
    EXPECT_GT(std::abs(difference), 3e-3 * unit) << force; // stands out of that
  }
  const double creepage = 1e-3 * moderate.longitudinal;
  Creepages more = moderate;
  more.longitudinal += creepage;
  Creepages less = moderate;
  less.longitudinal -= creepage;
  EXPECT_NEAR(found.weighted_by_creepage[0] * moderate.longitudinal,
              500.0 * (after(0.0, more)[3] - after(0.0, less)[3]), 1.5e-3 * friction * load);
}

// Callers may leave anything where there is no pressure.
TEST(GivenSlip, CountsUnderPressureOnly) {
  const auto plans = std::make_shared<LinePlans>();
  RollingSolver solver(plans);
  for (const double tolerance : {1e-3, 1e-6}) { // single and double precision
    Ellipse ellipse;
    RollingProblem problem = ellipse.problem(moderate, tolerance);
    Slip slip = slip_of(problem.grid, {}, 2e-5);
    problem.slip_x = slip.x;
    problem.slip_y = slip.y;
    const RollingSolution without = solver.solve(problem);
    for (const double filler : {0.0, -1.0, 1e10, 1e30}) {
      for (std::size_t i = 0; i < slip.x.size(); ++i) {
        if (!(problem.pressure[i] > 0.0)) {
          slip.x[i] = filler;
          slip.y[i] = -filler;
        }
      }
      const RollingSolution filled = solver.solve(problem);
      SCOPED_TRACE(filler);
      EXPECT_TRUE(filled.converged);
      expect_equal(without, filled, 2.0 * tolerance);
      EXPECT_EQ(filled.adhesion_area, without.adhesion_area);
      const TangentialResiduals residuals =
          compute_residuals(problem, filled.traction_x, filled.traction_y, *plans);
      EXPECT_LE(residuals.natural, 2.0 * tolerance);
    }
  }
}

TEST(GivenSlip, IsValidated) {
  RollingSolver solver;
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem(moderate);
  std::vector<double> values(problem.pressure.size());
  problem.slip_x = values;
  EXPECT_ANY_THROW(solver.solve(problem)); // slip_y is missing
  problem.slip_y = values;
  values[3] = std::nan("");
  EXPECT_ANY_THROW(solver.solve(problem));
}

} // namespace
} // namespace wrc::test::given_slip_test
