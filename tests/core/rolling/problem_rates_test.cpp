/// Derivatives of creep forces by creepages, friction, grids, pressures and edges against
/// differences.
#include "rolling/problem_rates.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "rolling/rolling_problem.hpp"
#include "support/rolling_ellipse.hpp"

namespace wrc::test::problem_rates_test {
namespace {

/// Fx, Fy and Mz.
std::array<double, 3> forces_of(const RollingSolution& solution) {
  return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment};
}

Creepages scaled(const Creepages& creepages, std::size_t changed, double factor) {
  std::array<double, 3> values{creepages.longitudinal, creepages.lateral, creepages.spin};
  values[changed] *= factor;
  return {values[0], values[1], values[2]};
}

// From small creepages to saturation; differences over 2e-4 of each creepage at a tolerance of
// 1e-8. Elements that change between adhesion and slip within them are the rest.
TEST(ProblemRates, DerivativesAreThoseOfDifferences) {
  Ellipse ellipse;
  ellipse.a = 4.0;
  ellipse.b = 6.0;
  RollingSolver solver;
  for (const double size : {0.02, 0.5, 1.0, 3.0}) {
    const Creepages creepages{-0.0012 * size, 0.0008 * size, 0.0003 * size};
    RollingProblem problem = ellipse.problem(creepages, 1e-6);
    problem.derivatives = true;
    const std::array<double, 9> rates = solver.solve(problem).by_creepage;
    problem.derivatives = false;
    problem.tolerance = 1e-8;
    const std::array<double, 3> values{creepages.longitudinal, creepages.lateral, creepages.spin};
    for (std::size_t k = 0; k < 3; ++k) {
      constexpr double change = 1e-4;
      problem.creepages = scaled(creepages, k, 1.0 + change);
      const auto above = forces_of(solver.solve(problem));
      problem.creepages = scaled(creepages, k, 1.0 - change);
      const auto below = forces_of(solver.solve(problem));
      for (std::size_t force = 0; force < 3; ++force) {
        const double difference = (above[force] - below[force]) / (2.0 * change);
        const double unit = friction * load * (force == 2 ? 5.0 : 1.0);
        EXPECT_NEAR(rates[3 * force + k] * values[k] / unit, difference / unit, 1.5e-3)
            << size << " force " << force << " by creepage " << k;
      }
    }
  }
}

/// By a longitudinal stretch, a lateral one, a shift, pressures that lean to one side and leading
/// edges that move within their elements; forces of the moved problem are those of a problem of its
/// own.
TEST(ProblemRates, RatesOfProblemsAreThoseOfDifferences) {
  Ellipse ellipse;
  ellipse.a = 4.0;
  ellipse.b = 6.0;
  RollingProblem problem = ellipse.problem({-0.0007, 0.0005, 0.0003}, 1e-8);
  const Grid grid = problem.grid;
  const std::vector<double> pressure(problem.pressure.begin(), problem.pressure.end());
  std::vector<double> leaning(pressure);
  for (std::size_t i = 0; i < leaning.size(); ++i) {
    leaning[i] *= grid.lateral(i / grid.longitudinal_count) / ellipse.b;
  }
  const std::vector<double> same(pressure.size());
  std::vector<double> firsts(pressure.size());
  std::vector<double> covered(pressure.size());
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const bool ends = (i + 1) % grid.longitudinal_count == 0 || !(pressure[i + 1] > 0.0);
    firsts[i] = pressure[i] > 0.0 && ends ? 1.0 : 0.0;
    covered[i] = pressure[i] > 0.0 ? 1.0 - 0.4 * firsts[i] : 0.0;
  }
  problem.covered = covered;
  const std::vector<ProblemRate> rates{
      {grid.longitudinal_first, grid.longitudinal_step, 0.0, 0.0, same},
      {0.0, 0.0, grid.lateral_first, grid.lateral_step, pressure},
      {3.0, 0.0, 2.0, 0.0, same},
      {0.0, 0.0, 0.0, 0.0, leaning},
      {0.0, 0.0, 0.0, 0.0, same, firsts}};
  problem.rates = rates;
  RollingSolver solver;
  const auto found = solver.solve(problem).by_rate;
  ASSERT_EQ(found.size(), rates.size());
  for (std::size_t k = 0; k < rates.size(); ++k) {
    constexpr double change = 1e-4;
    const auto after = [&](double step) {
      std::vector<double> moved(pressure);
      for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] += step * rates[k].pressure[i];
      }
      RollingProblem other = problem;
      other.rates = {};
      other.pressure = moved;
      std::vector<double> edges(covered);
      for (std::size_t i = 0; i < rates[k].covered.size(); ++i) {
        edges[i] += step * rates[k].covered[i];
      }
      other.covered = edges;
      other.grid.longitudinal_first += step * rates[k].longitudinal_first;
      other.grid.longitudinal_step += step * rates[k].longitudinal_step;
      other.grid.lateral_first += step * rates[k].lateral_first;
      other.grid.lateral_step += step * rates[k].lateral_step;
      return forces_of(solver.solve(other));
    };
    const auto ahead = after(change);
    const auto behind = after(-change);
    for (std::size_t force = 0; force < 3; ++force) {
      const double unit = friction * load * (force == 2 ? 5.0 : 1.0);
      EXPECT_NEAR(found[k][force] / unit, (ahead[force] - behind[force]) / (2.0 * change) / unit,
                  1.5e-3)
          << "rate " << k << " force " << force;
    }
  }
}

// The problem is homogeneous: friction and creepages k times as large give forces k times as large.
TEST(ProblemRates, DerivativesByFrictionFollowFromThoseByCreepages) {
  Ellipse ellipse;
  RollingSolver solver;
  const Creepages w{-0.001, 0.0008, 0.0003};
  RollingProblem problem = ellipse.problem(w, 1e-8);
  problem.derivatives = true;
  const RollingSolution solution = solver.solve(problem);
  const auto force = forces_of(solution);
  constexpr double change = 1e-4;
  problem.derivatives = false;
  problem.friction = friction * (1.0 + change);
  const auto above = forces_of(solver.solve(problem));
  problem.friction = friction * (1.0 - change);
  const auto below = forces_of(solver.solve(problem));
  for (std::size_t i = 0; i < 3; ++i) {
    const double* rates = solution.by_creepage.data() + 3 * i;
    const double by_friction =
        force[i] - rates[0] * w.longitudinal - rates[1] * w.lateral - rates[2] * w.spin;
    EXPECT_NEAR(by_friction, (above[i] - below[i]) / (2.0 * change),
                1.5e-3 * friction * load * (i == 2 ? ellipse.a : 1.0));
  }
}

TEST(ProblemRates, DerivativesAreComputedOnRequestOnlyAndChangeNothing) {
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem({-0.001, 0.0, 0.0});
  const RollingSolution plain = RollingSolver().solve(problem);
  EXPECT_EQ(plain.by_creepage, (std::array<double, 9>{}));
  problem.derivatives = true;
  RollingSolver solver;
  const RollingSolution with = solver.solve(problem);
  EXPECT_EQ(with.traction_x, plain.traction_x);
  problem.derivatives = false;
  EXPECT_EQ(solver.solve(problem).traction_y, plain.traction_y);
}

} // namespace
} // namespace wrc::test::problem_rates_test
