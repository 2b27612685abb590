/// How fast tractions of unlike bodies converge, and the slip that pressures cause.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "half_space/influence_coefficients.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc::test::unlike_order_test {
namespace {

constexpr double friction = 0.3;
constexpr double poisson = 0.28;

/// Forces and moment over mu N (and the mean semi-axis) of aluminium on steel, on an ellipse half
/// as long as wide under Hertz's pressure. Creepages are in mu N/(G a b).
std::array<double, 3> forces(std::size_t count, const Creepages& scaled) {
  const double a = std::sqrt(0.5);
  const double b = 1.0 / a;
  const auto n = static_cast<double>(count);
  RollingProblem problem;
  problem.grid = {count, count, 2.0 * b / n, 2.0 * a / n, -b + b / n, -a + a / n};
  std::vector<double> pressure;
  std::vector<double> covered;
  double sum = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    const double y = problem.grid.lateral(j) / b;
    const double half = a * std::sqrt(1.0 - y * y);
    const auto integral = [&](double x) {
      const double at = std::clamp(x / half, -1.0, 1.0);
      return 0.5 * half * half * (at * std::sqrt(1.0 - at * at) + std::asin(at));
    };
    for (std::size_t i = 0; i < count; ++i) {
      const double step = problem.grid.longitudinal_step;
      const double first = problem.grid.longitudinal(i) - 0.5 * step;
      pressure.push_back(std::max(integral(first + step) - integral(first), 0.0));
      covered.push_back(
          std::clamp((std::min(first + step, half) - std::max(first, -half)) / step, 0.0, 1.0));
      sum += pressure.back() * problem.grid.element_area();
    }
  }
  for (double& p : pressure) {
    p /= sum;
  }
  problem.pressure = pressure;
  problem.covered = covered;
  problem.friction = friction;
  problem.shear_modulus = 1.0;
  problem.poisson = poisson;
  problem.difference_parameter = 0.12;
  problem.creepages = {scaled.longitudinal * friction, scaled.lateral * friction,
                       scaled.spin * friction};
  problem.tolerance = 1e-5;
  const RollingSolution solution = RollingSolver().solve(problem);
  EXPECT_TRUE(solution.converged);
  return {solution.longitudinal_force / friction, solution.lateral_force / friction,
          solution.spin_moment / friction};
}

// With the difference of tractions for the slip of pressures too, errors are 1.1e-2, 3.4e-3 and
// 9e-4 on 16, 64 and 128 elements against 256.
TEST(UnlikeOrder, ForcesConverge) {
  for (const Creepages& creepages :
       {Creepages{0.0, 0.0, 0.0}, Creepages{0.3, 0.0, 0.0}, Creepages{-0.3, 0.0, 0.0},
        Creepages{0.0, 0.3, 0.0}, Creepages{0.0, 0.0, 0.3}}) {
    const std::array<double, 3> truth = forces(256, creepages);
    const auto error = [&](std::size_t count) {
      const std::array<double, 3> found = forces(count, creepages);
      double most = 0.0;
      for (std::size_t k = 0; k < truth.size(); ++k) {
        most = std::max(most, std::abs(found[k] - truth[k]));
      }
      return most;
    };
    SCOPED_TRACE(creepages.longitudinal);
    EXPECT_LT(error(16), 7e-3);
    EXPECT_LT(error(64), 1.5e-3);
    EXPECT_LT(error(128), 4e-4);
  }
}

// Midpoint rule on 200 x 200 pieces of the element.
TEST(CrossRateTable, IsTheDerivativeAlongX) {
  constexpr double aspect = 0.7;
  const TractionTable table = cross_rate_table(aspect, 4, 4);
  for (const auto& [column, row] :
       std::vector<std::pair<std::size_t, std::size_t>>{{1, 0}, {0, 1}, {3, 2}, {1, 3}}) {
    double along = 0.0;
    double across = 0.0;
    constexpr int pieces = 200;
    for (int k = 0; k < pieces * pieces; ++k) {
      const double x = static_cast<double>(column) - ((k % pieces + 0.5) / pieces - 0.5);
      const double y = aspect * (static_cast<double>(row) - ((k / pieces + 0.5) / pieces - 0.5));
      const double squared = x * x + y * y;
      const double weight = aspect / (pieces * pieces) / (squared * squared);
      along += weight * (y * y - x * x);
      across -= weight * 2.0 * x * y;
    }
    EXPECT_NEAR(table.longitudinal(row)[column], along, 2e-4);
    EXPECT_NEAR(table.mixed(row)[column], across, 2e-4);
  }
  // A wide element on itself is the plane problem: 2 pi.
  EXPECT_NEAR(cross_rate_table(1e6, 1, 1).longitudinal(0)[0], 2.0 * std::numbers::pi, 1e-5);
}

} // namespace
} // namespace wrc::test::unlike_order_test
