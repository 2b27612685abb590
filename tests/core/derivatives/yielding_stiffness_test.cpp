/// The stiffness of contact whose steel yields, against differences of solutions.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "derivatives/contact_stiffness.hpp"
#include "mechanics/normal_solver.hpp"
#include "support/contact_cases.hpp"

namespace wrc::test::yielding_stiffness_test {
namespace {

/// Two steels, of which one has just begun to yield and the other is far beyond; rows have scales.
TEST(YieldingStiffness, IsThatOfDifferences) {
  const Grid grid = centred_grid(24, 20, 0.8, 1.0);
  const std::vector<double> distance = hertz_gap(grid, 1.0 / 400.0, 1.0 / 300.0);
  std::vector<double> scales;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    scales.push_back(1.0 - 0.005 * static_cast<double>(row));
  }
  const std::array<YieldingBody, 2> bodies{YieldingBody{300.0, 0.4}, YieldingBody{500.0, 0.6}};
  PatchGap gap{grid, distance};
  gap.row_scales = scales;
  NormalProblem problem;
  problem.patches = {&gap, 1};
  problem.combined_modulus = steel_modulus;
  problem.tolerance = 1e-11;
  problem.yielding = bodies;
  const auto pressure_at = [&](double approach) {
    problem.approach = approach;
    return NormalSolver().solve_yielding(problem).patches[0].pressure;
  };
  constexpr double approach = 0.11;
  constexpr double step = 1e-6; // so small that the contact stays
  const std::vector<double> here = pressure_at(approach);
  const std::vector<double> before = pressure_at(approach - step);
  const std::vector<double> after = pressure_at(approach + step);

  InfluenceCache cache;
  ContactStiffness stiffness(cache);
  std::vector<double> own = here; // that the bodies have
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i] *= scales[i / grid.longitudinal_count];
  }
  const SolvedPatch solved{grid, own, Elements::constant, {}, scales};
  stiffness.set_contact({&solved, 1}, steel_modulus, nullptr, bodies);
  const std::vector<double> ones(own.size(), 1.0);
  const std::span<const double> displacement(ones);
  std::vector<std::vector<double>> rate;
  EXPECT_EQ(stiffness.solve({&displacement, 1}, rate, 1e-10).stop_reason,
            StopReason::tolerance_met);
  const double largest = *std::max_element(rate[0].begin(), rate[0].end());
  double beyond = 0.0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    ASSERT_EQ(before[i] > 0.0, after[i] > 0.0);
    EXPECT_NEAR(rate[0][i], (after[i] - before[i]) / (2.0 * step), 1e-4 * largest) << i;
    beyond = std::max(beyond, own[i] / 300.0);
  }
  EXPECT_GT(beyond, 2.0);
}

} // namespace
} // namespace wrc::test::yielding_stiffness_test
