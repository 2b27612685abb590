#include "scene/solve_scene.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"

namespace wrc::test::solve_scene_test {
namespace {

Scene small_scene(double lateral, double yaw = 0.0) {
  Scene scene;
  scene.lateral = lateral;
  scene.yaw = yaw;
  scene.grid = {{60, 48}};
  return scene;
}

TEST(SolveScene, MirroredSceneSwapsTheSidesToTheLastBit) {
  const SceneResult one = solve_scene(small_scene(2.0, 0.01));
  const SceneResult other = solve_scene(small_scene(-2.0, -0.01));
  EXPECT_EQ(one.roll, -other.roll);
  EXPECT_EQ(one.vertical, other.vertical);
  EXPECT_EQ(one.left->pmax, other.right->pmax);
  EXPECT_EQ(one.left->force.y, -other.right->force.y);
  EXPECT_EQ(one.left->angle, -other.right->angle);
  EXPECT_EQ(one.left->patches.at(0).centroid.y, -other.right->patches.at(0).centroid.y);
  EXPECT_EQ(one.left->patches.at(0).pressure, other.right->patches.at(0).pressure);
}

TEST(SolveScene, CoarsePrescribedGridsStayWhereBodiesOverlap) {
  Scene scene = small_scene(-5.3, 0.026);
  const double depth = solve_scene(scene).left->depth;
  for (const auto& grid : {std::array<std::size_t, 2>{10, 2}, {2, 10}, {1, 1}, {2, 2}, {1, 40}}) {
    scene.grid = grid;
    const WheelResult side = *solve_scene(scene).left;
    EXPECT_NEAR(std::log2(side.depth / depth), 0.0, 1.0) << grid[0] << " x " << grid[1];
    EXPECT_NEAR(side.force.z, 80000.0, 1e-6 * 80000.0);
    EXPECT_FALSE(side.warnings.empty());
  }
}

/// Under yaw patches of a deep penetration overlap in y: one of them lies as a whole beyond the
/// boundary of both.
TEST(SolveScene, PatchesBeyondTheirBoundaryHaveAGrid) {
  Scene scene;
  scene.side = SideChoice::right;
  scene.right.wheel.name = "LM";
  scene.right.rail.name = "49E1";
  scene.lateral = -4.46664;
  scene.vertical = 455.52916334715877;
  scene.roll = 0.00578876;
  scene.yaw = -0.0686492;
  scene.interaction = Interaction::near;
  const WheelResult deep = *solve_scene(scene).right;
  EXPECT_GT(deep.patches.size(), 1u);
  EXPECT_GT(deep.force.z, 0.0);
  EXPECT_TRUE(std::isfinite(deep.force.z));
}

TEST(SolveScene, OscillatingDepthsStayBelowTheFirstTouch) {
  // Tread and flange change places from one trial to the next on this grid.
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "56E1";
  scene.back_to_back = 1353.1720530538023;
  scene.left.radius = scene.right.radius = 397.4857841615228;
  scene.track.gauge = 1433.289749586064;
  scene.track.gauge_height = 11.43363854782805;
  scene.track.inclination = std::atan(1.0 / 20.0);
  scene.grid = {{34, 25}};
  scene.tolerance = 2e-6;
  scene.accuracy = 0.0019965984507527676;
  constexpr double lateral = -8.158270605519743;
  constexpr double load = 104999.82864163654;
  scene.yaw = 0.010431835716998683;
  SceneSolver solver;
  solver.set_options({.precision = Precision::double_only});
  for (const auto& [share, shift] : {std::pair{0.97, 0.1}, {1.0, 0.0}}) {
    scene.lateral = share * lateral + shift;
    scene.load_of = LoadOf::normal;
    scene.right.load = (shift > 0.0 ? 0.9 : 1.0) * load;
    const WheelResult side = *solver.solve(scene).right;
    EXPECT_GT(side.depth, 0.05);
    EXPECT_LT(side.depth, 1.0);
  }
}

TEST(SolveScene, ThreadsDoNotChangeABit) {
  Scene scene = small_scene(4.0, 0.02);
  const SceneResult one = solve_scene(scene);
  scene.threads = 2;
  const SceneResult two = solve_scene(scene);
  EXPECT_EQ(one.left->patches.at(0).pressure, two.left->patches.at(0).pressure);
  EXPECT_EQ(one.right->patches.at(0).pressure, two.right->patches.at(0).pressure);
  EXPECT_EQ(one.right->approach, two.right->approach);
}

TEST(SolveScene, OneSideAloneGivesTheSameResult) {
  Scene scene = small_scene(3.0);
  const SceneResult both = solve_scene(scene);
  scene.side = SideChoice::right;
  const SceneResult right = solve_scene(scene);
  EXPECT_FALSE(right.left);
  EXPECT_EQ(both.roll, right.roll);
  EXPECT_EQ(both.right->patches.at(0).pressure, right.right->patches.at(0).pressure);
  EXPECT_FALSE(right.rolling_radius_difference);
}

TEST(SolveScene, ForcesAndPlacesAreConsistent) {
  const SceneResult result = solve_scene(small_scene(5.0));
  for (const auto& [side, sign] :
       {std::pair(&*result.left, 1.0), std::pair(&*result.right, -1.0)}) {
    EXPECT_NEAR(side->force.z, 80000.0, 1e-6 * 80000.0);
    EXPECT_NEAR(side->force.y, -side->normal_force * std::sin(side->angle),
                1e-9 * side->normal_force);
    double force = 0.0;
    for (const PatchResult& patch : side->patches) {
      force += norm(patch.force);
      EXPECT_GT(sign * patch.centroid.y, 700.0);
      EXPECT_LE(patch.pmax, side->pmax * (1.0 + 1e-12));
    }
    EXPECT_NEAR(force, side->normal_force, 1e-9 * force);
    // The wheel sinks by the vertical part of the approach.
    // Penetration is deepest where the surface is steeper or flatter than the plane.
    EXPECT_NEAR(side->approach, side->depth * std::cos(side->angle), 0.02 * side->depth);
    // Taping line, displacement and contact add up (no yaw, small roll).
    EXPECT_NEAR(sign * side->rigid_contact.y - sign * 5.0 - 750.0, side->rigid_contact.s_wheel,
                0.5);
  }
  EXPECT_LT(result.left->force.y, 0.0);
  EXPECT_GT(result.right->force.y, 0.0);
  EXPECT_GT(*result.rolling_radius_difference, 0.0); // displaced to the left, S1002
}

TEST(SolveScene, ValuesByNameAreComplete) {
  SceneResult result = solve_scene(small_scene(1.0));
  EXPECT_EQ(number_value(result, "left.pmax"), result.left->pmax);
  EXPECT_EQ(number_value(result, "right.patches.0.semi_axes.lateral"),
            result.right->patches[0].semi_axis_lateral);
  EXPECT_EQ(number_value(result, "roll"), result.roll);
  for (const std::string& name : number_names(result)) {
    EXPECT_TRUE(number_value(result, name)) << name;
  }
  for (const char* name : {"", "left", "left.", "left.nothing", "left.patches", "left.patches.9.x",
                           "left.patches.x.x", "left.patches.0", "left.residuals.", "top.pmax"}) {
    EXPECT_FALSE(number_value(result, name)) << name;
  }
  ASSERT_TRUE(field_values(result, "left.pressure"));
  EXPECT_EQ(field_values(result, "left.pressure")->size(), 60u * 48u);
  EXPECT_FALSE(field_values(result, "left.nothing"));
  EXPECT_FALSE(field_values(result, "left"));
  EXPECT_FALSE(field_values(result, "top.pressure"));
}

TEST(SceneSolver, GridsGivenAndChosenMayTakeTurns) {
  Scene scene = small_scene(3.0);
  scene.accuracy = 1e-2;
  const auto grid = scene.grid;
  SceneSolver solver;
  for (int round = 0; round < 3; ++round) {
    scene.grid = grid;
    const SceneResult given = solver.solve(scene);
    scene.grid.reset();
    for (int step = 0; step < 2; ++step) {
      const SceneResult chosen = solver.solve(scene);
      EXPECT_NEAR(chosen.left->pmax, given.left->pmax, scene.accuracy * given.left->pmax);
    }
  }
}

TEST(SolveSceneErrors, UnknownProfileListsTheKnownOnes) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "60E9";
  expect_error(
      ErrorCode::unknown_name, [&] { solve_scene(scene); }, "track.rail = \"60E9\"", "60E1");
}

TEST(SolveSceneErrors, BuiltInProfilesAreNotSmoothed) {
  Scene scene;
  scene.left.rail.options.smoothing = scene.right.rail.options.smoothing = 3.0;
  EXPECT_THROW(solve_scene(scene), Error);
}

/// Pressed 18 mm deep the rail's surface turns upright under the pressures, and they pull down:
/// that was a converged solution with a load balance of 0.
TEST(SolveScene, ARailThatPullsIsNotConverged) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "54E1";
  scene.lateral = -7.0;
  scene.right.load = 4e7;
  scene.accuracy = 1e-2;
  scene.side = SideChoice::right;
  SceneResult result = solve_scene(scene);
  SceneWheel& wheel = result.right.value();
  EXPECT_LT(wheel.force.z, 0.0);
  EXPECT_NE(wheel.stop_reason, StopReason::tolerance_met);
  EXPECT_GT(wheel.residuals().load_balance, 1.0);
}

} // namespace
} // namespace wrc::test::solve_scene_test
