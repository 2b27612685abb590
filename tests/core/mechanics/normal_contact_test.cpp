/// Invariance of units, honest residuals, and refusal of bad input. Symmetries:
/// normal_solver_properties_test.cpp.
#include "mechanics/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/patch_problem.hpp"

namespace wrc::test::normal_contact_test {
namespace {

constexpr double tolerance = 1e-10;
/// Sums of some thousand terms.
constexpr double rounding = 1e-12;
/// Two runs whose roundings differ agree to the tolerance times the amplification of residuals in
/// pressures, which is the number of elements across times some factor.
constexpr double same_pressure = 1e4 * tolerance;

double largest_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Largest difference of two fields relative to the largest value.
double difference(const std::vector<double>& left, const std::vector<double>& right,
                  double factor = 1.0) {
  double worst = 0.0;
  for (std::size_t index = 0; index < left.size(); ++index) {
    worst = std::max(worst, std::abs(left[index] * factor - right[index]));
  }
  return worst / largest_of(right);
}

TEST(NormalContact, UnitsAndSizesDoNotMatter) {
  const Grid grid = centred_grid(30, 21, 0.3, 0.2);
  const std::vector<double> distance = hertz_gap(grid, 1.0 / 300.0, 1.0 / 150.0);
  const PatchSolution expected =
      solve_with_polonsky_keer(with_load(grid, distance, 2000.0, tolerance));
  for (const double length : {1e-12, 1e-3, 7.0, 1e12}) {
    for (const double stress : {1e-12, 1e6, 1e12}) {
      Grid scaled_grid = grid;
      scaled_grid.lateral_step *= length;
      scaled_grid.longitudinal_step *= length;
      std::vector<double> scaled_distance = distance;
      for (double& value : scaled_distance) {
        value *= length;
      }
      PatchProblem problem =
          with_load(scaled_grid, scaled_distance, 2000.0 * stress * length * length, tolerance);
      problem.combined_modulus *= stress;
      const PatchSolution found = solve_with_polonsky_keer(problem);
      EXPECT_EQ(found.stop_reason, StopReason::tolerance_met);
      EXPECT_LE(difference(found.pressure, expected.pressure, 1.0 / stress), same_pressure);
      EXPECT_NEAR(found.approach / (expected.approach * length), 1.0, same_pressure);
      problem.load.reset();
      problem.approach = expected.approach * length;
      const PatchSolution pressed = solve_with_polonsky_keer(problem);
      EXPECT_LE(difference(pressed.pressure, expected.pressure, 1.0 / stress), same_pressure);
    }
  }
}

TEST(NormalContact, SameInputSameBits) {
  for (const ContactCase& example : contact_cases(23, 37, 2.0)) {
    const PatchProblem problem = with_load(example.grid, example.distance, case_load, 1e-6);
    const PatchSolution first = solve_with_polonsky_keer(problem);
    const PatchSolution second = solve_with_polonsky_keer(problem);
    EXPECT_EQ(first.pressure, second.pressure);
    EXPECT_EQ(first.approach, second.approach);
    EXPECT_EQ(first.iterations, second.iterations);
  }
}

TEST(NormalContact, ResidualsRevealErrors) {
  const Grid grid = centred_grid(25, 25, 0.3, 0.3);
  const std::vector<double> distance = hertz_gap(grid, 1.0 / 300.0, 1.0 / 300.0);
  const PatchProblem problem = with_load(grid, distance, 4000.0, tolerance);
  const PatchSolution solution = solve_with_polonsky_keer(problem);
  const Residuals clean = compute_residuals(problem, solution.pressure, solution.approach);
  EXPECT_LE(clean.complementarity, tolerance);
  EXPECT_GE(clean.least_gap, -tolerance);

  // One per mille more at the centre element lifts its own gap by about that share of K(0) p.
  std::vector<double> perturbed = solution.pressure;
  perturbed[12 * 25 + 12] *= 1.001;
  Residuals residuals = compute_residuals(problem, perturbed, solution.approach);
  EXPECT_GT(residuals.complementarity, 1e-5);
  EXPECT_GT(residuals.load_balance, 1e-6);
  // An element of the contact left out: the bodies overlap there.
  perturbed = solution.pressure;
  perturbed[12 * 25 + 12] = 0.0;
  residuals = compute_residuals(problem, perturbed, solution.approach);
  EXPECT_LT(residuals.least_gap, -1e-3);
  // A wrong approach.
  residuals = compute_residuals(problem, solution.pressure, 1.01 * solution.approach);
  EXPECT_NEAR(residuals.complementarity, 0.01, 1e-3);
  // Load for nothing.
  const PatchProblem unloaded = with_load(grid, distance, 0.0, tolerance);
  EXPECT_EQ(compute_residuals(unloaded, solution.pressure, solution.approach).load_balance,
            std::numeric_limits<double>::infinity());
}

TEST(NormalContact, ATiltedPatchIsALevelOneAlongItsNormal) {
  const Grid grid = centred_grid(25, 25, 0.3, 0.3);
  const std::vector<double> distance = hertz_gap(grid, 1.0 / 300.0, 1.0 / 300.0);
  PatchProblem problem = with_load(grid, distance, 4000.0, tolerance);
  const PatchSolution level = solve_with_polonsky_keer(problem);
  problem.patch.approach_cosine = 0.5; // exact in binary
  problem.load = 2000.0;
  const PatchSolution tilted = solve_with_polonsky_keer(problem);
  EXPECT_EQ(tilted.pressure, level.pressure);
  EXPECT_EQ(tilted.approach, 2.0 * level.approach);
  const Residuals residuals = compute_residuals(problem, tilted.pressure, tilted.approach);
  EXPECT_LE(residuals.complementarity, tolerance);
  EXPECT_LE(residuals.load_balance, rounding);
}

TEST(NormalContact, StopReasonsAreNamed) {
  const Grid grid = centred_grid(40, 40, 0.2, 0.2);
  const std::vector<double> distance = hertz_gap(grid, 1.0 / 300.0, 1.0 / 300.0);
  PatchProblem problem = with_load(grid, distance, 4000.0, 1e-8);
  problem.maximum_iterations = 3;
  const PatchSolution early = solve_with_polonsky_keer(problem);
  EXPECT_EQ(early.stop_reason, StopReason::iteration_limit);
  EXPECT_EQ(early.iterations, 3);
  Residuals residuals = compute_residuals(problem, early.pressure, early.approach);
  EXPECT_GT(residuals.complementarity, 1e-8);
  EXPECT_LE(residuals.load_balance, rounding);
  problem.maximum_iterations = 5000;
  problem.tolerance = 1e-17;
  const PatchSolution floor = solve_with_polonsky_keer(problem);
  EXPECT_EQ(floor.stop_reason, StopReason::stagnation);
  residuals = compute_residuals(problem, floor.pressure, floor.approach);
  EXPECT_LE(residuals.complementarity, 1e-12);
  EXPECT_EQ(name_of(StopReason::tolerance_met), "tolerance_met");
  EXPECT_EQ(name_of(StopReason::iteration_limit), "iteration_limit");
  EXPECT_EQ(name_of(StopReason::stagnation), "stagnation");
}

/// The error of a call, or an empty text when it does not fail as invalid argument.
std::string refusal_of(const NormalProblem& problem) {
  try {
    solve_with_polonsky_keer(problem);
  } catch (const Error& error) {
    return error.code() == ErrorCode::invalid_argument ? error.what() : "";
  }
  return "";
}

TEST(NormalContact, RefusesBadInput) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double no_number = std::nan("");
  const std::vector<double> distance(6, 0.0);
  const Grid grid = centred_grid(2, 3, 1.0, 1.0);
  const PatchProblem good = with_load(grid, distance, 1.0, 1e-6);
  ASSERT_NO_THROW(solve_with_polonsky_keer(good));
  const auto expect_refused = [&](const std::string& argument, const auto& change) {
    PatchProblem problem = good;
    change(problem);
    EXPECT_EQ(refusal_of(problem).rfind(argument, 0), 0U)
        << argument << " against " << refusal_of(problem);
  };
  const auto huge = (std::size_t{1} << 26) + 1;
  expect_refused("grid.lateral_count = 0", [](auto& p) { p.patch.grid.lateral_count = 0; });
  expect_refused("grid.lateral_count", [=](auto& p) { p.patch.grid.lateral_count = huge; });
  expect_refused("grid.longitudinal_count = 0",
                 [](auto& p) { p.patch.grid.longitudinal_count = 0; });
  expect_refused("grid.longitudinal_count",
                 [=](auto& p) { p.patch.grid.longitudinal_count = huge / 2 + 1; });
  expect_refused("grid.longitudinal_count", [](auto& p) {
    p.patch.grid.longitudinal_count = std::numeric_limits<std::size_t>::max() / 2 + 2;
  });
  expect_refused("undeformed_distance.size = 6",
                 [](auto& p) { p.patch.grid.longitudinal_count = 4; });
  for (const double bad : {0.0, -1.0, infinity, no_number}) {
    expect_refused("grid.lateral_step", [=](auto& p) { p.patch.grid.lateral_step = bad; });
    expect_refused("grid.longitudinal_step",
                   [=](auto& p) { p.patch.grid.longitudinal_step = bad; });
    expect_refused("combined_modulus", [=](auto& p) { p.combined_modulus = bad; });
  }
  for (const double bad : {-1.0, infinity, no_number}) {
    expect_refused("load", [=](auto& p) { p.load = bad; });
  }
  for (const double bad : {infinity, -infinity, no_number, -1e61}) {
    std::vector<double> spoilt = distance;
    spoilt[4] = bad;
    expect_refused("undeformed_distance[4]",
                   [&](auto& p) { p.patch.undeformed_distance = spoilt; });
    expect_refused("approach", [=](auto& p) {
      p.load.reset();
      p.approach = bad;
    });
  }
  expect_refused("load and approach = both set", [](auto& p) { p.approach = 0.1; });
  expect_refused("load and approach = none set", [](auto& p) { p.load.reset(); });
  for (const double bad : {0.0, -1e-6, 0.11, infinity, no_number}) {
    expect_refused("tolerance", [=](auto& p) { p.tolerance = bad; });
  }
  const std::vector<PatchGap> two(2, good.patch);
  expect_refused("patches.size = 2", [&](auto& p) { p.patches = two; });
  expect_refused("maximum_iterations = 0", [](auto& p) { p.maximum_iterations = 0; });
  const std::vector<double> five(5, 0.0);
  EXPECT_THROW(compute_residuals(good, five, 0.0), Error);
  EXPECT_THROW(compute_residuals(good, five, distance, 0.0), Error);
  EXPECT_THROW(compute_residuals(good, distance, five, 0.0), Error);
}

} // namespace
} // namespace wrc::test::normal_contact_test
