/// Any pressures and any creepages: the solver ends, and its answers solve the problem as told.
#include "rolling/rolling_contact.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::rolling_contact_random_test {
namespace {

/// Draws problems of several families, as hard as they come.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  std::size_t count(std::size_t low, std::size_t high) {
    return low + static_cast<std::size_t>(generator_() % (high - low + 1));
  }
  double sign() { return generator_() % 2 == 0 ? 1.0 : -1.0; }

private:
  std::mt19937_64 generator_;
};

struct Drawn {
  RollingProblem problem;
  std::vector<double> pressure;
};

constexpr int families = 7;

/// 0 ellipses, 1 two lobes side by side, 2 two lobes one behind the other, 3 a banana with waves,
/// 4 a flat punch, 5 random pressures with holes, 6 grids of one or two elements.
Drawn draw(int family, Draw& from) {
  Drawn drawn;
  RollingProblem& problem = drawn.problem;
  std::size_t along = from.count(4, 40);
  std::size_t across = from.count(4, 40);
  if (family == 6) {
    along = from.count(1, 2);
    across = from.count(1, 2);
    (from.sign() > 0.0 ? along : across) = from.count(1, 20);
  }
  const double a = from.log_uniform(0.3, 10.0);
  const double b = family == 0 ? a * from.log_uniform(0.02, 50.0) : from.log_uniform(0.3, 10.0);
  const auto columns = static_cast<double>(along);
  const auto rows = static_cast<double>(across);
  problem.grid = {across,        along,           2.0 * b / rows, 2.0 * a / columns,
                  -b + b / rows, -a + a / columns};
  drawn.pressure.resize(along * across);
  const double wave = from.uniform(0.0, 3.0);
  for (std::size_t j = 0; j < across; ++j) {
    for (std::size_t i = 0; i < along; ++i) {
      const double x = problem.grid.longitudinal(i) / a;
      const double y = problem.grid.lateral(j) / b;
      double height = 1.0 - x * x - y * y;
      if (family == 1 || family == 2) {
        const double u = family == 1 ? std::abs(y) : std::abs(x);
        const double v = family == 1 ? x : y;
        height = 0.16 - (u - 0.55) * (u - 0.55) - v * v;
      } else if (family == 3) {
        const double bent = x - 0.5 * y * y + 0.1 * std::sin(wave * 6.0 * y);
        height = 0.4 - bent * bent - 0.4 * y * y;
      } else if (family == 4 || family == 6) {
        height = 1.0;
      } else if (family == 5) {
        height = from.uniform(0.0, 1.0) < 0.3 ? 0.0 : from.uniform(0.0, 1.0);
      }
      drawn.pressure[j * along + i] = 1000.0 * std::sqrt(std::max(height, 0.0));
    }
  }
  problem.pressure = drawn.pressure;
  problem.friction = from.uniform(0.05, 0.6);
  problem.shear_modulus = from.log_uniform(2e4, 1e5);
  problem.poisson = from.uniform(0.0, 0.5);
  const double size =
      problem.friction * 1000.0 / problem.shear_modulus * from.log_uniform(1e-6, 1e4);
  const std::size_t kind = from.count(0, 3);
  problem.creepages = {kind == 2 ? 0.0 : size * from.uniform(-1.0, 1.0),
                       kind == 1 || kind == 2 ? 0.0 : size * from.uniform(-1.0, 1.0),
                       kind == 1 ? 0.0 : size * from.uniform(-1.0, 1.0) / std::sqrt(a * b)};
  problem.motion = from.count(0, 4) == 0 ? TangentialMotion::shift : TangentialMotion::rolling;
  if (problem.motion == TangentialMotion::shift) {
    problem.creepages.longitudinal *= a;
    problem.creepages.lateral *= a;
    problem.creepages.spin *= a;
  }
  problem.tolerance = from.count(0, 3) == 0 ? 1e-5 : 1e-3;
  problem.maximum_iterations = 60;
  return drawn;
}

TEST(RollingContactRandom, EveryAnswerSolvesItsProblem) {
  const auto plans = std::make_shared<LinePlans>();
  RollingSolver solver(plans);
  int failures = 0;
  int cases = 0;
  for (int family = 0; family < families; ++family) {
    Draw from(static_cast<std::uint64_t>(family) + 1);
    for (int number = 0; number < 60; ++number) {
      const Drawn drawn = draw(family, from);
      const RollingProblem& problem = drawn.problem;
      const RollingSolution solution = solver.solve(problem);
      const TangentialResiduals residuals =
          compute_residuals(problem, solution.traction_x, solution.traction_y, *plans);
      SCOPED_TRACE("family " + std::to_string(family) + " number " + std::to_string(number));
      ++cases;
      failures += solution.converged ? 0 : 1;
      ASSERT_TRUE(std::isfinite(solution.longitudinal_force));
      ASSERT_TRUE(std::isfinite(solution.spin_moment));
      ASSERT_TRUE(std::isfinite(residuals.natural));
      EXPECT_LE(residuals.excess, 1e-6);
      if (solution.converged) {
        // The last cut to the bound changes what the iteration left, and single precision rounds.
        EXPECT_LE(residuals.natural, 3.0 * problem.tolerance);
      }
    }
  }
  EXPECT_EQ(failures, 0) << "of " << cases;
}

} // namespace
} // namespace wrc::test::rolling_contact_random_test
