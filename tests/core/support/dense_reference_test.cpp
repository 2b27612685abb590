/// Polonsky & Keer against the dense reference: same contact set, same pressures.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/dense_reference.hpp"

namespace wrc::test::dense_reference_test {
namespace {

/// The solver runs at 1e-11 of the largest u; the worst-conditioned pressures amplify it by the
/// number of elements across, some tens.
constexpr double solver_tolerance = 1e-11;
constexpr double pressure_tolerance = 1e-8;

void expect_same(const PatchProblem& problem, const std::string& name) {
  const DenseSolution expected = solve_densely(problem);
  const PatchSolution found = solve_with_polonsky_keer(problem);
  EXPECT_EQ(found.stop_reason, StopReason::tolerance_met) << name;
  const double largest = *std::max_element(expected.pressure.begin(), expected.pressure.end());
  std::size_t different_elements = 0;
  double worst = 0.0;
  for (std::size_t index = 0; index < expected.pressure.size(); ++index) {
    different_elements += (expected.pressure[index] > 0.0) != (found.pressure[index] > 0.0) ? 1 : 0;
    worst = std::max(worst, std::abs(expected.pressure[index] - found.pressure[index]));
  }
  EXPECT_EQ(different_elements, 0U) << name;
  EXPECT_LE(worst / largest, pressure_tolerance) << name;
  EXPECT_NEAR(found.approach / expected.approach, 1.0, pressure_tolerance) << name;
}

class DenseComparison : public testing::TestWithParam<double> {};

TEST_P(DenseComparison, PrescribedLoad) {
  for (const ContactCase& example : contact_cases(19, 17, GetParam())) {
    expect_same(with_load(example.grid, example.distance, case_load * GetParam(), solver_tolerance),
                example.name);
  }
}

TEST_P(DenseComparison, PrescribedApproach) {
  for (const ContactCase& example : contact_cases(17, 19, GetParam())) {
    const double least = *std::min_element(example.distance.begin(), example.distance.end());
    for (const double depth : {0.002, 0.02}) {
      expect_same(with_approach(example.grid, example.distance, least + depth, solver_tolerance),
                  example.name);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AspectRatios, DenseComparison, testing::Values(0.05, 1.0, 6.0));

} // namespace
} // namespace wrc::test::dense_reference_test
