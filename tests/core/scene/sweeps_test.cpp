// Sweeps of load and lateral position: nothing fails, nothing jumps.
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "half_space/material.hpp"
#include "mechanics/normal_solver.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::sweeps_test {
namespace {

constexpr double force_tolerance = 1e-6;

Scene two_lobes(const std::string& rail, bool solve_roll) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = rail;
  scene.lateral = 5.0;
  scene.side = SideChoice::left;
  if (!solve_roll) {
    scene.roll = 0.0;
  }
  return scene;
}

/// What a small relative change of the load may change, as multiples of it; the steepest that were
/// measured with steps of 1 %, while patches join: 2.3, 0.23, 0.05 and, where a patch that has just
/// been born takes over, 1.6. Beyond that the accuracy counts.
constexpr double depth_rate = 2.5;
constexpr double lateral_force_rate = 0.3;
constexpr double normal_force_rate = 0.08;
constexpr double pressure_rate = 1.8;

/// Goes through the loads from the first to the last.
void sweep_load(Scene scene, double first, double last, double step, double jumps_in_accuracies) {
  SceneSolver solver;
  std::optional<SceneWheel> before;
  const double change = std::log1p(step);
  const double jump = jumps_in_accuracies * scene.accuracy;
  double load_before = 0.0;
  for (double load = first; load <= last; load *= 1.0 + step) {
    SCOPED_TRACE(load);
    scene.left.load = scene.right.load = load;
    SceneResult result = solver.solve(scene);
    const WheelResult& side = *result.left;
    EXPECT_NEAR(side.force.z, load, force_tolerance * load);
    EXPECT_EQ(side.stop_reason, StopReason::tolerance_met);
    if (before) {
      if (depth_rate * change > jump) {
        EXPECT_GT(side.depth, before->depth);
      }
      EXPECT_NEAR(std::log(side.depth / before->depth), 0.0, depth_rate * change + jump);
      EXPECT_NEAR(std::log(side.pmax / before->pmax), 0.0, pressure_rate * change + jump);
      EXPECT_NEAR(side.normal_force / load, before->normal_force / load_before,
                  normal_force_rate * change + jump);
      EXPECT_NEAR(side.force.y / load, before->force.y / load_before,
                  lateral_force_rate * change + jump);
    }
    before = std::move(*result.left);
    load_before = load;
  }
}

class LoadSweep : public testing::TestWithParam<std::tuple<std::string, bool>> {};

TEST_P(LoadSweep, MeetsTheForceAndGoesOnSteadily) {
  const auto [rail, solve_roll] = GetParam();
  Scene scene = two_lobes(rail, solve_roll);
  scene.accuracy = 3e-3;
  sweep_load(scene, 500.0, 160e3, 0.04, 2.0);
}

TEST_P(LoadSweep, MeetsTheForceAndGoesOnSteadilyOnAGivenGrid) {
  const auto [rail, solve_roll] = GetParam();
  Scene scene = two_lobes(rail, solve_roll);
  scene.grid = {{64, 32}};
  scene.accuracy = 1e-2; // what this grid gives
  sweep_load(scene, 500.0, 160e3, 0.04, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Rails, LoadSweep,
                         testing::Combine(testing::Values(std::string("UIC60-Manchester"),
                                                          std::string("60E1")),
                                          testing::Bool()));

TEST(LoadSweeps, PatchesFormAndJoinWithoutAJump) {
  Scene scene = two_lobes("UIC60-Manchester", true);
  sweep_load(scene, 8480.0, 8510.0, 5e-4, 2.0);   // born at 8490 N
  sweep_load(scene, 25230.0, 25310.0, 5e-4, 2.0); // joined at 25270 N
}

Scene scene_of(const std::string& wheel, const std::string& rail) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = wheel;
  scene.left.rail.name = scene.right.rail.name = rail;
  if (wheel == "LMA") {
    scene.back_to_back = 1353.0;
    scene.left.radius = scene.right.radius = 430.0;
    scene.track.gauge_height = 16.0;
  }
  return scene;
}

/// Where a second lobe of penetration appears or vanishes: steps of 0.1 um of S1002.
struct Birth {
  std::string rail;
  double lateral;
};

// Element sizes follow the penetration, whose samples changed with each lobe: the lateral force
// stepped by 1.9, 5.5, 6 and 30 N.
TEST(LateralSweep, ForcesDoNotStepWhereALobeAppears) {
  for (const Birth& birth : {Birth{"60E1", 0.2605}, Birth{"54E2", 3.2378}, Birth{"54E2", -1.9954},
                             Birth{"50E6", 2.3490}}) {
    Scene scene = two_lobes(birth.rail, true);
    scene.accuracy = 1e-2;
    scene.accuracy_of = AccuracyOf::forces;
    SceneSolver solver;
    std::array<double, 3> forces{};
    for (int i = 0; i < 60; ++i) {
      scene.lateral = birth.lateral + 1e-4 * (i - 30);
      forces = {forces[1], forces[2], solver.solve(scene).left->force.y};
      if (i >= 2) {
        EXPECT_NEAR(forces[0] - 2.0 * forces[1] + forces[2], 0.0, 4e-6 * scene.left.load)
            << birth.rail << ' ' << scene.lateral;
      }
    }
  }
}

class LateralSweep : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(LateralSweep, FailsNowhere) {
  constexpr int half_count = 100;
  constexpr double step = 0.1;
  Scene scene = scene_of(GetParam().first, GetParam().second);
  scene.accuracy = 1e-2;
  SceneSolver solver;
  int not_reached = 0;
  int solutions = 0;
  for (int i = -half_count; i <= half_count; ++i) {
    scene.lateral = step * i;
    SCOPED_TRACE(scene.lateral);
    SceneResult result = solver.solve(scene);
    for (const auto side : {&SceneResult::left, &SceneResult::right}) {
      const WheelResult& here = *(result.*side);
      EXPECT_NEAR(here.force.z, scene.left.load, force_tolerance * scene.left.load);
      EXPECT_EQ(here.stop_reason, StopReason::tolerance_met);
      solutions += here.solutions;
      not_reached += here.discretisation_error.value_or(1.0) > scene.accuracy ? 1 : 0;
    }
  }
  // Four ridges that a curvature jump of the profiles presses into the rail; the others are
  // contacts that end on a sharper arc, which leaves moments uncertain by up to 1.2 times the
  // accuracy.
  EXPECT_LE(not_reached, 18);
  // A coarse one and the final one, more on steep contacts and where errors were underestimated.
  EXPECT_LE(solutions, 2.5 * 2 * (2 * half_count + 1));
}

/// A coarse one and the final one, also where wheels slide along their planes.
TEST(Sweeps, AForceNeedsTwoSolutions) {
  Scene scene = scene_of("S1002", "60E1");
  scene.accuracy_of = AccuracyOf::forces;
  for (const double lateral : {4.5, 5.2, 5.4, 5.8}) {
    scene.lateral = lateral;
    const SceneResult result = solve_scene(scene);
    EXPECT_EQ(result.left->solutions, 2) << lateral;
    EXPECT_EQ(result.right->solutions, 2) << lateral;
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, LateralSweep,
                         testing::Values(std::pair<std::string, std::string>("S1002", "60E1"),
                                         std::pair<std::string, std::string>("S1002",
                                                                             "UIC60-Manchester"),
                                         std::pair<std::string, std::string>("LMA", "CHN60")));

TEST(Costs, TwoPatchesCostLittleMoreThanOneOfTheSameElements) {
  // Hertzian bodies, the contact filling the same share of each grid.
  const double modulus = combined_modulus({210000.0, 0.3}, {210000.0, 0.3});
  const auto paraboloid = [](std::size_t rows, std::size_t columns, double radius) {
    const double step = 12.0 / static_cast<double>(columns);
    const Grid grid{rows,
                    columns,
                    step,
                    step,
                    -0.5 * step * static_cast<double>(rows - 1),
                    -0.5 * step * static_cast<double>(columns - 1)};
    std::vector<double> distance(grid.element_count());
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const double y = grid.lateral(i);
        const double x = grid.longitudinal(j);
        distance[i * columns + j] = 0.5 * (x * x + y * y) / radius;
      }
    }
    return std::pair(grid, distance);
  };
  const auto solve = [&](std::span<const PatchGap> patches, double load) {
    NormalProblem problem;
    problem.patches = patches;
    problem.combined_modulus = modulus;
    problem.load = load;
    problem.tolerance = 1e-5;
    return NormalSolver().solve(problem);
  };
  const auto [small_grid, small] = paraboloid(128, 128, 300.0);
  const auto [large_grid, large] = paraboloid(180, 180, 300.0);
  const std::array one{PatchGap{large_grid, large}};
  const std::array two{PatchGap{small_grid, small, 1.0}, PatchGap{small_grid, small, 0.95}};
  const NormalSolution single = solve(one, 30e3);
  const NormalSolution both = solve(two, 60e3);
  // A convolution goes over all boxes: as many elements in both.
  EXPECT_LE(both.convolutions, 1.3 * single.convolutions);
}

TEST(Costs, AGivenGridTakesAFewSolutions) {
  // A coarse solution finds the depth, the final grid is solved there; both once more where planes
  // and interactions of the two lobes follow from the depth.
  int solutions = 0;
  int count = 0;
  Scene scene = two_lobes("60E1", false);
  scene.grid = {{64, 32}};
  for (double load = 500.0; load < 160e3; load *= 1.04) {
    scene.left.load = load;
    const SceneResult result = solve_scene(scene);
    EXPECT_LE(result.left->solutions, 7) << load;
    solutions += result.left->solutions;
    ++count;
  }
  EXPECT_LE(solutions, 3.5 * count);
}

} // namespace
} // namespace wrc::test::sweeps_test
