// One step of a vehicle simulation: the scene at a state, and numbers of patches under both of
// their names in every convention.
#include "scene/vehicle_step.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "keys/scene.hpp"
#include "keys/scene_keys.hpp"
#include "scene/patch_summary.hpp"
#include "support/errors.hpp"

namespace wrc::test::vehicle_step_test {
namespace {

Scene rolling_scene() {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.motion.emplace();
  scene.motion->speed = 2e4;
  return scene;
}

VehicleState curving() {
  VehicleState state;
  state.position = {0.0, 5.0, 459.9, 1e-4, 0.0, 4e-3};
  state.velocity = {2e4, 10.0, -2.0, 1e-3, 43.6, 2e-3};
  return state;
}

TEST(VehicleStep, StatesGoIntoTheScene) {
  VehicleState state = curving();
  state.rails = SixNumbers{0.1, 0.2, 1e-3, -0.1, -0.2, -1e-3};
  state.rail_velocities = SixNumbers{1.0, 2.0, 3e-3, -1.0, -2.0, -3e-3};
  state.curvature = -1e-6;
  state.friction = {0.2, 0.4};
  const Scene scene = scene_at(rolling_scene(), state);
  EXPECT_EQ(scene.lateral, 5.0);
  EXPECT_EQ(scene.vertical, 459.9);
  EXPECT_EQ(scene.roll, 1e-4);
  EXPECT_EQ(scene.yaw, 4e-3);
  EXPECT_EQ(scene.motion->lateral, 10.0);
  EXPECT_EQ(scene.motion->pitch, 43.6);
  EXPECT_EQ(scene.left.displacement.height, 0.2);
  EXPECT_EQ(scene.right.displacement.lateral, -0.1);
  EXPECT_EQ(scene.left.velocity.height, 2.0);
  EXPECT_EQ(scene.right.velocity.roll, -3e-3);
  EXPECT_EQ(scene.motion->curvature, -1e-6);
  EXPECT_EQ(scene.left.friction.coefficient, 0.2);
  EXPECT_EQ(scene.right.friction.coefficient, 0.4);
}

TEST(VehicleStep, StepsWithoutForcesOrDerivativesAreRefused) {
  Scene scene = rolling_scene();
  scene.until = Module::remesh;
  expect_error(
      ErrorCode::invalid_argument, [&] { scene_at(scene, curving()); }, "solve.until");
  scene = rolling_scene();
  scene.model = ModelRequest::hertz;
  VehicleState state = curving();
  EXPECT_NO_THROW(scene_at(scene, state));
  state.derivatives = true;
  expect_error(
      ErrorCode::invalid_argument, [&] { scene_at(scene, state); }, "solve.model");
}

/// Summaries are put together beside the tables of numbers: both must agree, in signs and units.
TEST(VehicleStep, SummariesAgreeWithTheNumbersByName) {
  for (const Units units : {Units::mm, Units::si}) {
    for (const TrackFrame frame : {TrackFrame::left_up, TrackFrame::right_down}) {
      Scene scene = rolling_scene();
      scene.lateral = 6.0;
      scene.yaw = 2e-3;
      scene.motion->lateral = 20.0;
      scene.convention = {units, frame};
      SceneResult result = solve_scene(scene);
      const std::vector<PatchSummary> summaries = patch_summaries(result, scene.convention);
      ASSERT_GE(summaries.size(), 2U);
      std::size_t at = 0;
      for (const bool right : {false, true}) {
        WheelResult& wheel = right ? *result.right : *result.left;
        std::vector<std::size_t> order(wheel.patches.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
          order[i] = i;
        }
        std::sort(order.begin(), order.end(), [&wheel](std::size_t one, std::size_t other) {
          return wheel.patches[one].reference.s_wheel < wheel.patches[other].reference.s_wheel;
        });
        for (const std::size_t patch : order) {
          const PatchSummary& summary = summaries[at++];
          const auto number = [&](const std::string& name) {
            const std::string whole =
                (right ? "right.patches." : "left.patches.") + std::to_string(patch) + '.' + name;
            return number_value(result, *number_id(whole), scene.convention);
          };
          const auto member = [&summary](std::string_view name) {
            const auto* const found =
                std::find(patch_summary_names.begin(), patch_summary_names.end(), name);
            return summary.at(static_cast<std::size_t>(found - patch_summary_names.begin()));
          };
          EXPECT_EQ(summary.front(), right ? 1.0 : 0.0);
          for (std::size_t i = 0; i < summary.size(); ++i) {
            const std::string name(patch_summary_names[i]);
            if (name != "wheel" && !name.starts_with("normal.")) {
              EXPECT_EQ(summary[i], number(name)) << name;
            }
          }
          // The normal points from the rail to the wheel: along it the pressures push by their sum.
          double pushed = 0.0;
          double square = 0.0;
          for (const char axis : {'x', 'y', 'z'}) {
            const double force = member(std::string("pressure_force.") + axis);
            pushed += member(std::string("normal.") + axis) * force;
            square += force * force;
          }
          const double sum = wheel.patches[patch].normal_force;
          EXPECT_NEAR(pushed, sum, 1e-6 * sum);
          EXPECT_NEAR(member("normal_force"), std::sqrt(square), 1e-9 * sum);
        }
      }
      EXPECT_EQ(at, summaries.size());
    }
  }
}

/// Jacobians are those of differences of the forces themselves.
TEST(VehicleStep, JacobiansAreThoseOfDifferences) {
  Scene free = rolling_scene(); // a little below where the left wheel touches first
  free.lateral = 2.0;
  free.yaw = 1e-3;
  free.roll = 0.0;
  free.until = Module::geometry;
  VehicleState state;
  state.position = {0.0, 2.0, solve_scene(free).left->vertical - 0.08, 0.0, 0.0, 1e-3};
  state.velocity = {2e4, 10.0, 0.0, 0.0, 2e4 / 460.0, 0.0};
  Scene scene = rolling_scene();
  scene.accuracy = 1e-3;
  const auto forces_at = [&](const VehicleState& at) {
    SceneResult result = solve_scene(scene_at(scene, at));
    return wheel_forces(result, scene.convention, at.derivatives)[0];
  };
  state.derivatives = true;
  const WheelForces here = forces_at(state);
  ASSERT_GT(here.force[2], 1e4);
  const auto expect_column = [&](SixNumbers& (*numbers_of)(VehicleState&), std::size_t column,
                                 double step, const SixNumbers& by, double tolerance) {
    VehicleState before = state;
    VehicleState after = state;
    before.derivatives = after.derivatives = false;
    numbers_of(before)[column] -= step;
    numbers_of(after)[column] += step;
    const WheelForces low = forces_at(before);
    const WheelForces high = forces_at(after);
    for (const std::size_t row : {0U, 1U, 2U}) {
      const double difference = (high.force[row] - low.force[row]) / (2.0 * step);
      EXPECT_NEAR(by[row], difference, tolerance) << row << ' ' << column;
    }
  };
  const double stiffness = std::abs(here.by_position[2][2]);
  EXPECT_GT(stiffness, 1e5) << "some hundred kN per mm";
  expect_column([](VehicleState& at) -> SixNumbers& { return at.position; }, 2, 1e-3,
                here.by_position[2], 0.03 * stiffness);
  const double damping = std::abs(here.by_velocity[1][1]);
  expect_column([](VehicleState& at) -> SixNumbers& { return *at.velocity; }, 1, 1.0,
                here.by_velocity[1], 0.03 * damping);
}

TEST(VehicleStep, CreepForcesOfAPatchAreRefusedBeyondTheirRange) {
  Scene scene = rolling_scene();
  scene.side = SideChoice::left;
  SceneSolver solver;
  const SceneResult result = solver.solve(scene);
  const PatchCreep creep = creep_of(scene, result, 0, {1e-3, 0.0, 0.0}, true, solver);
  EXPECT_LT(creep.forces[0], 0.0) << "against the creepage";
  EXPECT_LT(creep.by_creepage[0], 0.0);
  expect_error(
      ErrorCode::invalid_argument, [&] { creep_of(scene, result, 9, {}, false, solver); }, "patch");
  expect_error(
      ErrorCode::invalid_argument,
      [&] {
        creep_of(scene, result, 0, {11.0, 0.0, 0.0}, false, solver);
      },
      "creepages[0]");
}

} // namespace
} // namespace wrc::test::vehicle_step_test
