// The smoothing spline meets the condition of its minimum at each knot, and passes through values
// without smoothing.
#include "profile/reinsch_spline.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::reinsch_spline_test {
namespace {

const std::vector<double> knots{0.0, 0.7, 1.1, 2.0, 2.4, 3.5, 4.1};

/// The minimum: w_i (y_i - f_i) = lambda times the jump of f''' at knot i.
double worst_residual(const std::vector<double>& values, double length, bool is_periodic) {
  const ReinschSpline::Fit fit = ReinschSpline(knots, length, is_periodic).fit(values);
  const double lambda = std::pow(length / (2.0 * std::numbers::pi), 4);
  const std::size_t intervals = knots.size() - 1;
  const auto step = [](std::size_t i) { return knots[i + 1] - knots[i]; };
  const auto third = [&](std::size_t i) { return (fit.second[i + 1] - fit.second[i]) / step(i); };
  double worst = 0.0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const bool closes = is_periodic && (i == 0 || i == intervals);
    const bool has_before = i > 0 || closes;
    const bool has_after = i < intervals || closes;
    const std::size_t before = i > 0 ? i - 1 : intervals - 1;
    const std::size_t after = i < intervals ? i : 0;
    const double weight =
        0.5 * ((has_before ? step(before) : 0.0) + (has_after ? step(after) : 0.0));
    const double jump = (has_after ? third(after) : 0.0) - (has_before ? third(before) : 0.0);
    worst = std::max(worst, std::abs(weight * (values[i] - fit.value[i]) - lambda * jump));
  }
  return worst;
}

TEST(ReinschSpline, MeetsTheConditionOfItsMinimum) {
  const std::vector<double> values{1.0, -0.4, 0.3, 2.0, -1.0, 0.2, 1.0}; // closes
  for (const double length : {0.5, 2.0, 10.0}) {
    EXPECT_LT(worst_residual(values, length, false), 1e-12) << length;
    EXPECT_LT(worst_residual(values, length, true), 1e-12) << length;
  }
}

TEST(ReinschSpline, PassesThroughItsValuesWithoutSmoothing) {
  const std::vector<double> values{1.0, -0.4, 0.3, 2.0, -1.0, 0.2, 1.0};
  for (const bool is_periodic : {false, true}) {
    EXPECT_EQ(ReinschSpline(knots, 0.0, is_periodic).fit(values).value, values);
  }
}

} // namespace
} // namespace wrc::test::reinsch_spline_test
