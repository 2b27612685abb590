#include "wheel/solve_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "half_space/displacement_operator.hpp"
#include "half_space/material.hpp"
#include "models/hertz.hpp"
#include "remesh/row_scales.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::solve_wheel_test {
namespace {

const double modulus = combined_modulus({210000.0, 0.3}, {210000.0, 0.3});

/// With a normal solver of its own.
WheelSolution solve_alone(const WheelSurface& wheel, const RailSurface& rail,
                          const SideEquilibrium& equilibrium, const WheelRequest& request) {
  NormalSolver solver;
  return solve_wheel(wheel, rail, equilibrium, request, solver);
}

struct Fixture {
  WheelSurface wheel;
  RailSurface rail;
  SideEquilibrium equilibrium;
};

Fixture fixture(const Profile& wheel, const Profile& rail, double lateral, double yaw,
                double cant) {
  Fixture made{
      WheelSurface(wheel, {1360.0, 70.0, 460.0}), RailSurface(rail, {1435.0, 14.0, cant}), {}};
  EquilibriumRequest request;
  request.lateral = lateral;
  request.yaw = yaw;
  request.roll = 0.0;
  request.right = false;
  made.equilibrium =
      *find_equilibrium({made.wheel, made.rail}, {made.wheel, made.rail}, request).left;
  return made;
}

Fixture s1002(double lateral, double yaw = 0.0) {
  return fixture(standard_profile("S1002"), standard_profile("60E1"), lateral, yaw,
                 std::atan(0.025));
}

TEST(WheelSolution, SmoothBodiesGiveHertzsSolution) {
  const Fixture made = fixture(cylindrical_wheel(), circular_rail(300.0), 0.0, 0.0, 0.0);
  // Circles differ from Hertz's parabolas by about (a / R)^2 / 4: below 1e-4 for these loads.
  constexpr double tolerance = 2e-3;
  for (const double load : {1e-3, 1.0, 1e3, 2e4}) {
    WheelRequest request;
    request.combined_modulus = modulus;
    request.normal_load = load;
    const WheelSolution solution = solve_alone(made.wheel, made.rail, made.equilibrium, request);
    const HertzContact hertz = solve_hertz(1.0 / 460.0, 1.0 / 300.0, modulus, load);
    EXPECT_NEAR(solution.peak_pressure, hertz.peak_pressure, tolerance * hertz.peak_pressure);
    EXPECT_NEAR(solution.patches.at(0).approach, hertz.approach, tolerance * hertz.approach);
    ASSERT_EQ(solution.patches.size(), 1u);
    EXPECT_NEAR(solution.patches[0].contact.semi_axis_lateral, hertz.semi_axis_lateral,
                0.01 * hertz.semi_axis_lateral);
    EXPECT_NEAR(solution.patches[0].contact.semi_axis_longitudinal, hertz.semi_axis_longitudinal,
                0.01 * hertz.semi_axis_longitudinal);
    ASSERT_TRUE(solution.discretisation_error);
    EXPECT_LE(std::abs(solution.peak_pressure / hertz.peak_pressure - 1.0),
              *solution.discretisation_error + 2e-4);
    EXPECT_TRUE(solution.warnings.empty()) << load << ": " << solution.warnings.front().text;
  }
}

TEST(WheelSolution, SignorinisConditionsHoldOnTheFinalGrid) {
  for (const double lateral : {-3.0, 0.0, 5.0, 5.6}) {
    const Fixture made = s1002(lateral, 0.01);
    WheelRequest request;
    request.combined_modulus = modulus;
    request.vertical_load = 80000.0;
    request.grid = {{160, 100}};
    request.tolerance = 1e-6;
    const WheelSolution solution = solve_alone(made.wheel, made.rail, made.equilibrium, request);
    double force = 0.0;
    for (const Patch& patch : solution.patches) {
      std::vector<double> displacement(patch.grid.element_count());
      DisplacementOperator(patch.grid, modulus, request.elements)
          .apply(over_scales(patch.grid, patch.row_scales, patch.pressure), displacement);
      displacement = over_scales(patch.grid, patch.row_scales, displacement);
      const double largest = *std::max_element(displacement.begin(), displacement.end());
      // Gaps hold to the tolerance of the iteration, 1e-6 of the largest displacement.
      const double gap_tolerance = 1e-6 * largest;
      for (std::size_t i = 0; i < patch.grid.element_count(); ++i) {
        const double pressure = patch.pressure[i];
        const double gap = patch.undeformed_distance[i] + displacement[i];
        EXPECT_GE(pressure, 0.0);
        EXPECT_GE(gap, -1.01 * gap_tolerance - 1e-4 * largest * (pressure == 0.0));
        if (pressure > 0.0) {
          EXPECT_LE(std::abs(gap), 1.01 * gap_tolerance);
        }
      }
      force += patch.contact_force.force.z;
      EXPECT_FALSE(summarise_pressure(patch.grid, patch.pressure).touches_edge.any());
    }
    EXPECT_NEAR(force, 80000.0, 1e-6 * 80000.0);
  }
}

// Under yaw the edge of the chamfer crosses the rows, and the penetration is wider than the
// tread's.
TEST(WheelSolution, ContactAtARidgeStaysClearOfTheGridEdges) {
  const Fixture made =
      fixture(standard_profile("S1002"), standard_profile("60E1"), -48.0, 0.08, std::atan(0.08));
  WheelRequest request;
  request.combined_modulus = modulus;
  request.vertical_load = 80000.0;
  request.accuracy = 1e-3;
  request.accuracy_of = AccuracyOf::forces;
  const WheelSolution solution = solve_alone(made.wheel, made.rail, made.equilibrium, request);
  const Patch& main = solution.patches.front();
  EXPECT_GT(main.penetration.deepest_s, 50.0);
  EXPECT_FALSE(main.contact.touches_edge.any());
}

double vertical_force_of(const WheelSolution& solution) {
  double force = 0.0;
  for (const Patch& patch : solution.patches) {
    force += patch.contact_force.force.z;
  }
  return force;
}

TEST(WheelSolution, ThePositionOfALoadGivesTheLoad) {
  for (const double lateral : {-3.0, 2.0, 5.6}) {
    const Fixture made = s1002(lateral);
    WheelRequest request;
    request.combined_modulus = modulus;
    request.vertical_load = 60000.0;
    request.grid = {{160, 100}};
    const WheelSolution loaded = solve_alone(made.wheel, made.rail, made.equilibrium, request);
    const double sunk = loaded.depth;
    WheelRequest position;
    position.combined_modulus = modulus;
    position.vertical = made.equilibrium.vertical - sunk;
    position.grid = request.grid;
    const WheelSolution placed = solve_alone(made.wheel, made.rail, made.equilibrium, position);
    // Plane and grid follow from a slightly different depth.
    EXPECT_NEAR(vertical_force_of(placed), 60000.0, 2e-3 * 60000.0);
    EXPECT_NEAR(placed.depth, sunk, 1e-12);
  }
}

TEST(WheelSolution, AWheelAboveTheRailCarriesNothing) {
  const Fixture made = s1002(0.0);
  WheelRequest request;
  request.combined_modulus = modulus;
  request.vertical = made.equilibrium.vertical + 0.01;
  const WheelSolution solution = solve_alone(made.wheel, made.rail, made.equilibrium, request);
  EXPECT_FALSE(solution.in_contact);
  ASSERT_EQ(solution.warnings.size(), 1u);
  EXPECT_EQ(solution.warnings[0].text, "no contact at this height");
}

TEST(WheelSolution, NoLoadIsAResult) {
  const Fixture made = s1002(0.0);
  WheelRequest request;
  request.combined_modulus = modulus;
  request.vertical_load = 0.0;
  const WheelSolution solution = solve_alone(made.wheel, made.rail, made.equilibrium, request);
  EXPECT_FALSE(solution.in_contact);
  EXPECT_EQ(solution.peak_pressure, 0.0);
}

TEST(WheelSolution, TwoLobesUnderNearlyTheSameAngleArePartsOfOnePatch) {
  const Fixture made = s1002(5.0);
  WheelRequest request;
  request.combined_modulus = modulus;
  request.vertical_load = 80000.0;
  const WheelSolution solution = solve_alone(made.wheel, made.rail, made.equilibrium, request);
  ASSERT_EQ(solution.patches.size(), 1u);
  const Patch& patch = solution.patches[0];
  EXPECT_EQ(pressure_regions(patch.grid, patch.pressure).size(), 2u);
}

/// Place across the track and force.
std::vector<std::pair<double, double>> lobes_of(const WheelSolution& solution) {
  std::vector<std::pair<double, double>> lobes;
  for (const Patch& patch : solution.patches) {
    for (const PressureRegion& region : pressure_regions(patch.grid, patch.pressure)) {
      lobes.emplace_back(patch.frame.to_track(0.0, region.centroid_lateral, 0.0).y,
                         region.normal_force);
    }
  }
  return lobes;
}

TEST(WheelSolution, ANewLobeIsFoundOrNegligible) {
  // At y = 4.76 the second lobe has just begun, far from the first one.
  const Fixture made = s1002(4.76);
  WheelRequest request;
  request.combined_modulus = modulus;
  request.vertical_load = 80000.0;
  request.accuracy = 1e-3;
  const WheelSolution fine = solve_alone(made.wheel, made.rail, made.equilibrium, request);
  const auto lobes = lobes_of(fine);
  ASSERT_EQ(lobes.size(), 2u);
  EXPECT_LT(lobes[1].second, 0.01 * lobes[0].second);
  EXPECT_NEAR(lobes[1].first - lobes[0].first, -10.0, 2.0);
  // Rows at this accuracy are wider than the lobe.
  request.accuracy = 3e-3;
  const WheelSolution coarse = solve_alone(made.wheel, made.rail, made.equilibrium, request);
  EXPECT_NEAR(coarse.peak_pressure, fine.peak_pressure, request.accuracy * fine.peak_pressure);
  EXPECT_NEAR(coarse.depth, fine.depth, request.accuracy * fine.depth);
}

TEST(WheelSolution, ErrorEstimateBoundsTheErrorAgainstAFinerGrid) {
  // Truth: a grid four times finer than the finest that the accuracy chose.
  int bounded = 0;
  int total = 0;
  for (const double lateral : {-4.0, -2.0, 0.5, 2.0, 3.5}) {
    const Fixture made = s1002(lateral);
    WheelRequest request;
    request.combined_modulus = modulus;
    request.vertical_load = 80000.0;
    request.accuracy = 1e-2;
    const WheelSolution asked = solve_alone(made.wheel, made.rail, made.equilibrium, request);
    WheelRequest fine = request;
    fine.grid = {
        {4 * asked.patches[0].grid.lateral_count, 4 * asked.patches[0].grid.longitudinal_count}};
    fine.tolerance = 1e-8;
    const WheelSolution truth = solve_alone(made.wheel, made.rail, made.equilibrium, fine);
    const double error = std::max(std::abs(asked.peak_pressure / truth.peak_pressure - 1.0),
                                  std::abs(asked.depth / truth.depth - 1.0));
    EXPECT_LE(error, request.accuracy) << lateral;
    ASSERT_TRUE(asked.discretisation_error);
    bounded += error <= *asked.discretisation_error ? 1 : 0;
    ++total;
  }
  EXPECT_GE(bounded, total - 1);
}

} // namespace
} // namespace wrc::test::solve_wheel_test
