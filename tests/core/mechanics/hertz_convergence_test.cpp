/// Order of convergence of peak pressure and approach against Hertz in closed form.
///
/// The error of one grid depends on where the rim of the ellipse cuts the elements; the mean over
/// shifts of the grid by fractions of an element shows the law beneath.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "models/hertz.hpp"
#include "pressure/pressure_field.hpp"
#include "support/patch_problem.hpp"

namespace wrc::test::hertz_convergence_test {
namespace {

/// Band of the least-squares order. Below 2 on coarse grids, where the approach still gains on its
/// law (0.08 at n = 8 to 0.16 at n = 64, times 1/n^2).
constexpr double least_order = 1.7;
constexpr double largest_order = 2.4;
/// Expected errors 0.15/n^2 (peak) and 0.08/n^2 (approach), with a factor for the range of n, axis
/// ratio and the mean over only five shifts.
constexpr double peak_law = 0.15;
constexpr double approach_law = 0.08;
constexpr double slack = 2.5;
/// Algebraic error far below the discretisation error of 64 elements, 2e-5.
constexpr double solver_tolerance = 1e-8;
constexpr double load = 80000.0;

struct Errors {
  double peak = 0.0;
  double approach = 0.0;
};

Errors mean_errors(double longitudinal_curvature, double lateral_curvature, std::size_t across) {
  const HertzContact exact =
      solve_hertz(longitudinal_curvature, lateral_curvature, steel_modulus, load);
  const auto count = static_cast<std::size_t>(1.25 * static_cast<double>(across)) + 2;
  const double step_y = 2.0 * exact.semi_axis_lateral / static_cast<double>(across);
  const double step_x = 2.0 * exact.semi_axis_longitudinal / static_cast<double>(across);
  constexpr int shifts = 5;
  Errors mean;
  for (int shift = 0; shift < shifts; ++shift) {
    Grid grid = centred_grid(count, count, step_y, step_x);
    grid.longitudinal_first += step_x * (0.2 * shift - 0.5);
    grid.lateral_first += step_y * (std::fmod(0.4 * shift, 1.0) - 0.5);
    const std::vector<double> distance = hertz_gap(grid, longitudinal_curvature, lateral_curvature);
    const PatchSolution solution =
        solve_with_polonsky_keer(with_load(grid, distance, load, solver_tolerance));
    EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met);
    EXPECT_FALSE(summarise_pressure(grid, solution.pressure).touches_edge.any());
    mean.peak += (peak_pressure(grid, solution.pressure) / exact.peak_pressure - 1.0) / shifts;
    mean.approach += (solution.approach / exact.approach - 1.0) / shifts;
  }
  return mean;
}

/// Curvature ratio of an ellipse with this axis ratio, from the inverse by bisection.
double curvature_ratio_of(double axis_ratio) {
  double low = 0.0;
  double high = 12.0;
  for (int halving = 0; halving < 80; ++halving) {
    const double middle = 0.5 * (low + high);
    (hertz_axis_ratio(std::exp(middle)) * axis_ratio > 1.0 ? low : high) = middle;
  }
  return std::exp(low);
}

class HertzConvergence : public testing::TestWithParam<double> {};

TEST_P(HertzConvergence, PeakAndApproachAreOfOrderTwo) {
  const double smaller = 1.0 / 460.0;
  const double greater = smaller * curvature_ratio_of(GetParam());
  constexpr std::array<std::size_t, 4> across{8, 16, 32, 64};
  // Least squares of ln(error) over ln(n) for the grids from 16 on.
  double sum_x = 0.0;
  double sum_xx = 0.0;
  Errors sum_y;
  Errors sum_xy;
  int points = 0;
  for (const std::size_t count : across) {
    const Errors errors = mean_errors(smaller, greater, count);
    const double n = static_cast<double>(count);
    EXPECT_LE(std::abs(errors.peak), slack * peak_law / (n * n)) << count;
    EXPECT_LE(std::abs(errors.approach), slack * approach_law / (n * n)) << count;
    if (count < 16) {
      continue;
    }
    const double x = std::log(n);
    sum_x += x;
    sum_xx += x * x;
    sum_y.peak += std::log(std::abs(errors.peak));
    sum_xy.peak += x * std::log(std::abs(errors.peak));
    sum_y.approach += std::log(std::abs(errors.approach));
    sum_xy.approach += x * std::log(std::abs(errors.approach));
    ++points;
  }
  const auto order = [&](double y, double xy) {
    return -(points * xy - sum_x * y) / (points * sum_xx - sum_x * sum_x);
  };
  const double peak_order = order(sum_y.peak, sum_xy.peak);
  const double approach_order = order(sum_y.approach, sum_xy.approach);
  RecordProperty("peak_order", std::to_string(peak_order));
  RecordProperty("approach_order", std::to_string(approach_order));
  EXPECT_GE(peak_order, least_order);
  EXPECT_LE(peak_order, largest_order);
  EXPECT_GE(approach_order, least_order);
  EXPECT_LE(approach_order, largest_order);
}

INSTANTIATE_TEST_SUITE_P(AxisRatios, HertzConvergence, testing::Values(1.0, 2.0, 5.0, 10.0, 20.0));

} // namespace
} // namespace wrc::test::hertz_convergence_test
