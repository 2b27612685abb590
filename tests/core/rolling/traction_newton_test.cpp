// Newton's method on one grid: the conditions of friction by plain sums over the table.
#include "rolling/traction_newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "half_space/influence_cache.hpp"

namespace wrc::test::traction_newton_test {
namespace {

constexpr std::size_t rows = 16; ///< along
constexpr std::size_t columns = 14;
constexpr double aspect = 1.1;
constexpr double poisson = 0.28;
/// A shift: no derivative.
constexpr SlipDifferenceWeights displacement{{0.0, 1.0, 0.0, 0.0}, 0.0, 0.0};
constexpr double tolerance = 1e-6;

/// A shift of a semi-ellipsoid of bounds by (x, y).
class ShiftedContact {
public:
  ShiftedContact(double x, double y)
      : newton_({{rows, columns}, 2.0 / (aspect * columns)}, poisson, displacement,
                traction_table(aspect, columns, rows + difference_reach), plans_) {
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const double u = (2.0 * static_cast<double>(i) - 15.0) / 14.0;
        const double v = (2.0 * static_cast<double>(j) - 13.0) / 12.0;
        const std::size_t place = i * newton_.pitch() + j;
        newton_.bound()[place] = std::sqrt(std::max(0.0, 1.0 - u * u - v * v));
        newton_.rigid_slip()[place] = x;
        newton_.rigid_slip()[newton_.size() + place] = y;
      }
    }
  }

  NewtonOutcome solve() { return newton_.solve({tolerance, 50}); }
  TractionNewton<double>& newton() { return newton_; }
  [[nodiscard]] double at(const double* field, std::size_t component, std::size_t i,
                          std::size_t j) const {
    return field[component * newton_.size() + i * newton_.pitch() + j];
  }
  [[nodiscard]] double sum(const double* field, std::size_t component) const {
    double total = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        total += at(field, component, i, j);
      }
    }
    return total;
  }

private:
  LinePlans plans_;
  TractionNewton<double> newton_;
};

TEST(TractionNewton, MeetsTheConditionsOfFriction) {
  ShiftedContact contact(8.0, 3.0);
  const NewtonOutcome outcome = contact.solve();
  ASSERT_TRUE(outcome.converged);
  EXPECT_LE(outcome.residual, tolerance);
  TractionNewton<double>& newton = contact.newton();
  // Slips of the tractions as they are after the last cut.
  std::vector<double> slip(2 * newton.size());
  newton.convolve(newton.traction(), slip.data());
  std::size_t sticking = 0;
  std::size_t sliding = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double g = contact.at(newton.bound(), 0, i, j);
      const double qx = contact.at(newton.traction(), 0, i, j);
      const double qy = contact.at(newton.traction(), 1, i, j);
      const double sx = contact.at(slip.data(), 0, i, j) + 8.0;
      const double sy = contact.at(slip.data(), 1, i, j) + 3.0;
      const double speed = std::hypot(sx, sy);
      EXPECT_LE(std::hypot(qx, qy), g * (1.0 + 1e-12));
      if (g == 0.0) {
        continue;
      }
      if (std::hypot(qx, qy) < g * (1.0 - 1e-9)) {
        ++sticking;
        EXPECT_NEAR(speed, 0.0, 1e-3) << i << ' ' << j;
      } else {
        ++sliding;
        EXPECT_NEAR(qx * sx + qy * sy, -g * speed, 1e-3) << i << ' ' << j;
      }
    }
  }
  EXPECT_GT(sticking, 10U);
  EXPECT_GT(sliding, 10U);
}

/// u of tractions, x by x and across, straight from the table (Cerruti).
TEST(TractionNewton, ConvolvesWithCerrutisCoefficients) {
  ShiftedContact contact(0.0, 0.0);
  TractionNewton<double>& newton = contact.newton();
  std::vector<double> in(2 * newton.size(), 0.0);
  std::vector<double> out(2 * newton.size());
  const std::size_t source = 5 * newton.pitch() + 4;
  in[source] = 1.0;
  newton.convolve(in.data(), out.data());
  const TractionTable table = traction_table(aspect, columns, rows);
  const double self = contact.at(out.data(), 0, 5, 4);
  ASSERT_GT(self, 0.0);
  const auto coefficient = [&](std::size_t across, std::size_t along) {
    return table.longitudinal(across)[along] + (1.0 - poisson) * table.lateral(across)[along];
  };
  for (const auto& [i, j] : {std::array<std::size_t, 2>{5, 4}, {9, 4}, {5, 11}, {12, 10}}) {
    const std::size_t along = i > 5 ? i - 5 : 5 - i;
    const std::size_t across = j > 4 ? j - 4 : 4 - j;
    EXPECT_NEAR(contact.at(out.data(), 0, i, j) / self,
                coefficient(across, along) / coefficient(0, 0), 1e-10);
  }
}

TEST(TractionNewton, FullSlidingIsTheBoundAgainstTheShift) {
  ShiftedContact contact(3000.0, -4000.0);
  ASSERT_TRUE(contact.solve().converged);
  TractionNewton<double>& newton = contact.newton();
  const double whole = contact.sum(newton.bound(), 0);
  EXPECT_NEAR(contact.sum(newton.traction(), 0), -0.6 * whole, 1e-2 * whole);
  EXPECT_NEAR(contact.sum(newton.traction(), 1), 0.8 * whole, 1e-2 * whole);
}

/// The linearised equations at the solution give the rate that differences show.
TEST(TractionNewton, RatesAreThoseOfDifferences) {
  constexpr double step = 1e-3;
  ShiftedContact before(8.0 - step, 3.0);
  ShiftedContact after(8.0 + step, 3.0);
  ShiftedContact here(8.0, 3.0);
  ASSERT_TRUE(before.solve().converged && after.solve().converged && here.solve().converged);
  TractionNewton<double>& newton = here.newton();
  std::vector<double> slip_rate(2 * newton.size(), 0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      slip_rate[i * newton.pitch() + j] = 1.0;
    }
  }
  const double rate = here.sum(newton.solve_rate(slip_rate.data(), 1e-8), 0);
  const double difference =
      (after.sum(after.newton().traction(), 0) - before.sum(before.newton().traction(), 0)) /
      (2.0 * step);
  EXPECT_LT(rate, 0.0);
  EXPECT_NEAR(rate / difference, 1.0, 0.02);
}

TEST(TractionNewton, StopsAtTheLimitOfIterations) {
  ShiftedContact contact(8.0, 3.0);
  const NewtonOutcome outcome = contact.newton().solve({1e-12, 1});
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1);
}

} // namespace
} // namespace wrc::test::traction_newton_test
