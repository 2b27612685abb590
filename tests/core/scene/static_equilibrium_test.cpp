/// Height and roll of a wheelset under given loads: the loads are carried there, from tread to
/// flange, in curves and with creep forces.
#include "scene/static_equilibrium.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace wrc::test::static_equilibrium_test {
namespace {

Scene scene_for_forces() {
  Scene scene;
  scene.accuracy = 1e-3;
  scene.accuracy_of = AccuracyOf::forces;
  return scene;
}

VehicleState at(double lateral, double yaw = 0.0) {
  VehicleState state;
  state.position = {0.0, lateral, 0.0, 0.0, 0.0, yaw};
  return state;
}

class LateralPositions : public testing::TestWithParam<double> {};

TEST_P(LateralPositions, WheelsCarryTheirLoads) {
  const Scene scene = scene_for_forces();
  SceneSolver solver;
  const StaticEquilibrium found =
      find_static_equilibrium(scene, at(GetParam(), 2e-3), {LoadsOf::wheels, {9e4, 4e4}}, solver);
  EXPECT_TRUE(found.converged);
  EXPECT_LE(found.unbalanced, 1e-5);
  // By itself: the position that was found, solved again.
  Scene posed = scene;
  posed.lateral = GetParam();
  posed.yaw = 2e-3;
  posed.vertical = found.vertical;
  posed.roll = found.roll;
  const SceneResult result = solve_scene(posed);
  EXPECT_NEAR(result.left->total->force.z, 9e4, 2.0);
  EXPECT_NEAR(result.right->total->force.z, 4e4, 2.0);
}

INSTANTIATE_TEST_SUITE_P(StaticEquilibria, LateralPositions,
                         testing::Values(-6.5, -3.0, 0.0, 4.8, 6.0, 7.0));

/// An axle in a canted curve: its load is not centred, and creep forces carry a part.
TEST(StaticEquilibrium, AnAxleBalancesItsMomentWithCreepForces) {
  Scene scene = scene_for_forces();
  SceneSolver solver;
  VehicleState state = at(-5.0, 6e-3);
  state.velocity = SixNumbers{2e4, 0.0, 0.0, 0.0, 2e4 / 460.0, 0.0};
  state.curvature = 1.0 / 5e5;
  const StaticEquilibrium found =
      find_static_equilibrium(scene, state, {LoadsOf::axle, {1.3e5, -1.5e7}}, solver);
  ASSERT_TRUE(found.converged);
  const WheelForce& left = *found.result.left->total;
  const WheelForce& right = *found.result.right->total;
  EXPECT_NEAR(left.force.z + right.force.z, 1.3e5, 2.0);
  EXPECT_NEAR(left.moment.x + right.moment.x, 1.5e7, 2e3);
  EXPECT_NE(left.force.x, 0.0);
}

TEST(StaticEquilibrium, EqualLoadsOfACentredWheelsetNeedNoRoll) {
  SceneSolver solver;
  const StaticEquilibrium found =
      find_static_equilibrium(scene_for_forces(), at(0.0), {LoadsOf::wheels, {6e4, 6e4}}, solver);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.roll, 0.0, 1e-9);
}

/// Each load counts by itself: 10 N beside 80 kN were 20.
TEST(StaticEquilibrium, ALightWheelBesideAHeavyOneCarriesItsLoad) {
  Scene scene = scene_for_forces();
  scene.side = SideChoice::left;
  SceneSolver solver;
  const StaticEquilibrium found =
      find_static_equilibrium(scene, at(1.0), {LoadsOf::wheels, {8e4, 10.0}}, solver);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.result.right->total->force.z, 10.0, 1e-3);
  EXPECT_EQ(found.scene.side, SideChoice::left) << "a key that it does not set";
}

/// They count as none, as under a load (no_load): the wheels touch.
TEST(StaticEquilibrium, LoadsThatAreTooSmallLeaveWheelsThatTouch) {
  const Scene scene = scene_for_forces();
  SceneSolver solver;
  const SceneResult touch = [&] {
    Scene unloaded = scene;
    unloaded.lateral = 1.0;
    unloaded.left.load = unloaded.right.load = 0.0;
    return solver.solve(unloaded);
  }();
  for (const StaticLoads& loads :
       {StaticLoads{LoadsOf::wheels, {1e-30, 1e-30}}, StaticLoads{LoadsOf::axle, {1e-30, 0.0}}}) {
    const StaticEquilibrium found = find_static_equilibrium(scene, at(1.0), loads, solver);
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.roll, touch.roll, 1e-12);
    EXPECT_NEAR(found.vertical, touch.vertical, 1e-9);
  }
}

TEST(StaticEquilibrium, UsesTheConventionOfTheScene) {
  Scene scene = scene_for_forces();
  SceneSolver solver;
  const StaticEquilibrium inside =
      find_static_equilibrium(scene, at(3.0), {LoadsOf::axle, {1e5, 1e6}}, solver);
  scene.convention = {Units::si, TrackFrame::right_down};
  const StaticEquilibrium outside =
      find_static_equilibrium(scene, at(-3e-3), {LoadsOf::axle, {1e5, 1e3}}, solver);
  EXPECT_NEAR(outside.vertical, -1e-3 * inside.vertical, 1e-12);
  EXPECT_NEAR(outside.roll, inside.roll, 1e-12);
}

/// A big wheel at the edge of contact stands nowhere so: once 41 solutions, of 0.1 s each.
TEST(StaticEquilibrium, EndsSoonWhereNoPositionBalancesTheLoads) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "CHN60";
  scene.left.radius = scene.right.radius = 3479.2114367892482;
  SceneSolver solver;
  const StaticEquilibrium found =
      find_static_equilibrium(scene, at(-7.9560149149391677, -0.0095034105454016166),
                              {LoadsOf::axle, {142.66428428835016, -71874.923330939375}}, solver);
  EXPECT_FALSE(found.converged);
  EXPECT_LE(found.solutions, 20);
}

TEST(StaticEquilibrium, RefusesLoadsThatNoWheelsetCarries) {
  SceneSolver solver;
  const auto find = [&solver](LoadsOf of, double first, double second) {
    return [&solver, of, first, second] {
      find_static_equilibrium(scene_for_forces(), at(0.0), {of, {first, second}}, solver);
    };
  };
  expect_error(ErrorCode::invalid_argument, find(LoadsOf::wheels, 0.0, 1e4), "left wheel");
  expect_error(ErrorCode::invalid_argument, find(LoadsOf::wheels, 1e4, NAN), "right wheel");
  expect_error(ErrorCode::invalid_argument, find(LoadsOf::axle, 1e4, 8e6), "750 mm");
  expect_error(ErrorCode::invalid_argument, find(LoadsOf::axle, -1.0, 0.0), "axle");
}

} // namespace
} // namespace wrc::test::static_equilibrium_test
