// Strips against dense elimination and against plane strain.
#include "mechanics/strip_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/dense_reference.hpp"

namespace wrc::test::strip_contact_test {
namespace {

constexpr double modulus = 115000.0; // MPa
constexpr double length = 8.0;       // mm

/// As a problem of one column, for the reference.
PatchProblem column_of(const StripProblem& strips) {
  const Grid grid{strips.undeformed_distance.size(), 1, strips.step, strips.length, 0.0, 0.0};
  PatchProblem problem(grid, strips.undeformed_distance, strips.combined_modulus);
  problem.approach = strips.approach;
  return problem;
}

void expect_dense_pressures(const std::vector<double>& distance, double approach) {
  const StripProblem problem{0.05, length, modulus, approach, distance, 1e-9};
  const std::vector<double> found = solve_strips(problem, std::vector<double>(distance.size()));
  const std::vector<double> dense = solve_densely(column_of(problem)).pressure;
  const double largest = *std::max_element(dense.begin(), dense.end());
  ASSERT_GT(largest, 0.0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], dense[i], 1e-7 * largest) << i;
  }
}

std::vector<double> parabola(std::size_t count, double curvature) {
  std::vector<double> distance;
  for (std::size_t i = 0; i < count; ++i) {
    const double lateral = 0.05 * (static_cast<double>(i) - 0.5 * static_cast<double>(count - 1));
    distance.push_back(0.5 * curvature * lateral * lateral);
  }
  return distance;
}

TEST(StripContact, GivesThePressuresOfElimination) {
  expect_dense_pressures(parabola(80, 0.01), 0.005);
  expect_dense_pressures(parabola(81, 0.01), 0.05); // all strips in contact
}

TEST(StripContact, FindsSeveralContactsOfARoughProfile) {
  std::vector<double> distance = parabola(160, 0.004);
  std::mt19937_64 random(1);
  for (double& value : distance) {
    value += 0.002 * static_cast<double>(random() % 1000) / 1000.0;
  }
  expect_dense_pressures(distance, 0.006);
}

TEST(StripContact, AnyInitialPressuresGiveTheSameSolution) {
  const std::vector<double> distance = parabola(80, 0.01);
  const StripProblem problem{0.05, length, modulus, 0.005, distance, 1e-10};
  const std::vector<double> from_none = solve_strips(problem, std::vector<double>(80));
  const std::vector<double> from_everywhere = solve_strips(problem, std::vector<double>(80, 1e3));
  const double largest = *std::max_element(from_none.begin(), from_none.end());
  for (std::size_t i = 0; i < from_none.size(); ++i) {
    EXPECT_NEAR(from_none[i], from_everywhere[i], 1e-7 * largest) << i;
  }
}

TEST(StripContact, HasNoPressuresWithoutOverlap) {
  const std::vector<double> distance = parabola(20, 0.01);
  const StripProblem problem{0.05, length, modulus, -0.001, distance, 1e-6};
  for (const double pressure : solve_strips(problem, std::vector<double>(20, 100.0))) {
    EXPECT_EQ(pressure, 0.0);
  }
}

/// Waves of pressure p cos(k y) displace by 2 p/(E* k) in plane strain.
TEST(StripContact, DisplacesWavesAsPlaneStrain) {
  constexpr std::size_t count = 2001;
  constexpr double step = 0.01;
  const double wave_number = 2.0 * std::numbers::pi / (50.0 * step);
  std::vector<double> pressure;
  for (std::size_t i = 0; i < count; ++i) {
    pressure.push_back(std::cos(wave_number * step * (static_cast<double>(i) - 1000.0)));
  }
  const std::vector<double> displacement =
      displacements_of_strips(step, 100.0 * length, modulus, pressure);
  const double swing = 0.5 * (displacement[1000] - displacement[1025]);
  EXPECT_NEAR(swing, 2.0 / (modulus * wave_number), 2e-3 * swing); // strips: order of (k b)^2 / 24
}

} // namespace
} // namespace wrc::test::strip_contact_test
