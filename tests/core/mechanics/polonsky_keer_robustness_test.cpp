/// Cases that broke trials of such solvers: single elements, split, sharp and rough contacts,
/// extreme elements, loads and sizes.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "half_space/influence_coefficients.hpp"
#include "pressure/pressure_field.hpp"
#include "support/patch_problem.hpp"

namespace wrc::test::polonsky_keer_robustness_test {
namespace {

constexpr double tolerance = 1e-8;
/// A few roundings of a single product.
constexpr double rounding = 1e-13;
/// Largest pressure error relative to the peak, in units of the tolerance: gaps of the shortest
/// wavelength stand for pressures larger by up to the number of elements across the contact, here
/// 41 at the most; 7.5 is the largest seen.
constexpr double pressure_amplification = 15.0;

std::size_t contact_count(const PatchSolution& solution) {
  return static_cast<std::size_t>(std::count_if(solution.pressure.begin(), solution.pressure.end(),
                                                [](double p) { return p > 0.0; }));
}

/// The solution, which is expected to meet the problem's tolerance.
PatchSolution solved(const PatchProblem& problem, const std::string& name) {
  PatchSolution solution = solve_with_polonsky_keer(problem);
  EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met) << name;
  const Residuals residuals = compute_residuals(problem, solution.pressure, solution.approach);
  EXPECT_LE(residuals.complementarity, problem.tolerance) << name;
  EXPECT_GE(residuals.least_gap, -problem.tolerance) << name;
  EXPECT_LE(residuals.load_balance, 1e-12) << name;
  return solution;
}

TEST(PolonskyKeer, OneByOneGrid) {
  const Grid grid{1, 1, 0.5, 2.0, 0.0, 0.0};
  const std::vector<double> distance{0.125};
  const double coefficient = influence_coefficient(0.0, 0.0, 2.0, 0.5, steel_modulus);
  const PatchSolution loaded = solved(with_load(grid, distance, 10.0, 1e-12), "load");
  EXPECT_NEAR(loaded.pressure[0], 10.0, 10.0 * rounding);
  EXPECT_NEAR(loaded.approach, 0.125 + 10.0 * coefficient, rounding);
  const PatchSolution pressed = solved(with_approach(grid, distance, 0.135, 1e-12), "approach");
  EXPECT_NEAR(pressed.pressure[0] * coefficient, 0.01, rounding);
}

TEST(PolonskyKeer, OneElementInContact) {
  const Grid grid = centred_grid(15, 13, 0.1, 0.1);
  std::vector<double> distance = hertz_gap(grid, 1.0, 1.0);
  distance[5 * 13 + 4] = -0.01;
  const PatchSolution solution = solved(with_load(grid, distance, 1.0, 1e-12), "single element");
  EXPECT_EQ(contact_count(solution), 1U);
  EXPECT_NEAR(solution.pressure[5 * 13 + 4], 100.0, 100.0 * rounding);
}

TEST(PolonskyKeer, AllCasesAtAllLoadsAndElementShapes) {
  for (const double aspect : {1.0 / 200.0, 1.0, 100.0}) {
    for (const ContactCase& example : contact_cases(41, 37, aspect)) {
      for (const double factor : {1e-9, 1e-4, 1.0, 100.0}) {
        const std::string name = example.name + ", aspect " + std::to_string(aspect) + ", load x " +
                                 std::to_string(factor);
        const PatchSolution loaded = solved(
            with_load(example.grid, example.distance, case_load * aspect * factor, tolerance),
            name);
        // Rounding of an approach of 1e-3 mm is no longer small against displacements of 1e-13.
        if (factor > 1e-6) {
          const PatchSolution pressed =
              solved(with_approach(example.grid, example.distance, loaded.approach, tolerance),
                     name + ", approach");
          EXPECT_NEAR(pressed.normal_force / loaded.normal_force, 1.0, 1e-5) << name;
        }
      }
    }
  }
}

TEST(PolonskyKeer, WholeGridInContact) {
  const Grid grid = centred_grid(20, 31, 0.2, 0.2);
  const std::vector<double> flat(grid.element_count(), 0.0);
  const PatchSolution punch = solved(with_load(grid, flat, 5e4, 1e-11), "punch");
  EXPECT_EQ(contact_count(punch), grid.element_count());
  // A punch is loaded most at its corners, least in its middle.
  EXPECT_EQ(*std::max_element(punch.pressure.begin(), punch.pressure.end()),
            std::max({punch.pressure[0], punch.pressure[30], punch.pressure[19 * 31],
                      punch.pressure[19 * 31 + 30]}));
  const std::vector<double> round = hertz_gap(grid, 1e-3, 1e-3);
  const PatchSolution pressed = solved(with_load(grid, round, 1e6, 1e-11), "round");
  EXPECT_EQ(contact_count(pressed), grid.element_count());
}

TEST(PolonskyKeer, ReachesTwelveDigits) {
  for (const ContactCase& example : contact_cases(53, 47, 1.0)) {
    solved(with_load(example.grid, example.distance, case_load, 1e-12), example.name);
  }
}

TEST(PolonskyKeer, EveryToleranceIsKept) {
  // Four tolerances a decade: with the update alone some of these stop up to twice too early, and
  // with the gaps alone pressures are off by more.
  for (const double aspect : {1.0, 6.0}) {
    for (const ContactCase& example : contact_cases(41, 37, aspect)) {
      const PatchSolution exact = solve_with_polonsky_keer(
          with_load(example.grid, example.distance, case_load * aspect, 1e-11));
      const double largest = *std::max_element(exact.pressure.begin(), exact.pressure.end());
      for (double asked = 0.1; asked > 1e-9; asked /= std::sqrt(std::sqrt(10.0))) {
        const std::string name = example.name + " " + std::to_string(std::log10(asked));
        const PatchSolution loaded =
            solved(with_load(example.grid, example.distance, case_load * aspect, asked), name);
        double worst = 0.0;
        for (std::size_t index = 0; index < exact.pressure.size(); ++index) {
          worst = std::max(worst, std::abs(loaded.pressure[index] - exact.pressure[index]));
        }
        EXPECT_LE(worst / largest, pressure_amplification * asked) << name;
        solved(with_approach(example.grid, example.distance, exact.approach, asked),
               name + ", approach");
      }
    }
  }
}

TEST(PolonskyKeer, AbsentMaterialDoesNotCount) {
  // Far elements at 1e3 mm give the same bits of physics as a body that goes on out of reach.
  const Grid grid = centred_grid(30, 20, 0.2, 0.2);
  std::vector<double> distance = hertz_gap(grid, 1.0 / 100.0, 1.0 / 100.0);
  const PatchSolution whole = solve_with_polonsky_keer(with_load(grid, distance, 500.0, tolerance));
  std::size_t removed = 0;
  for (double& value : distance) {
    if (value > 2.0 * whole.approach) {
      value = 1e3;
      ++removed;
    }
  }
  ASSERT_GT(removed, 100U);
  const PatchSolution cut = solved(with_load(grid, distance, 500.0, tolerance), "cut");
  EXPECT_NEAR(cut.approach / whole.approach, 1.0, 10.0 * tolerance);
  EXPECT_NEAR(peak_pressure(grid, cut.pressure) / peak_pressure(grid, whole.pressure), 1.0,
              1e3 * tolerance);
}

} // namespace
} // namespace wrc::test::polonsky_keer_robustness_test
