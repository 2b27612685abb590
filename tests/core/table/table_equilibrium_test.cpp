#include "table/table_equilibrium.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"
#include "table/small_table.hpp"

namespace wrc::test {
namespace {

/// Away from the centre, on rails that are displaced.
VehicleState state_of_test() {
  VehicleState state;
  state.position = {0.0, 0.3, 0.0, 0.0, 0.0, 0.002};
  state.velocity = SixNumbers{2e4, 10.0, 0.0, 0.0, 43.5, 0.0};
  state.rails = SixNumbers{0.1, 0.2, 0.0, -0.1, -0.4, 0.0};
  return state;
}

TEST(TableEquilibrium, WheelsCarryTheirLoads) {
  VehicleState state = state_of_test();
  const TableEquilibrium found =
      find_table_equilibrium(small_table(), state, {LoadsOf::wheels, {40e3, 70e3}});
  ASSERT_TRUE(found.converged);
  state.position[2] = found.vertical;
  state.position[3] = found.roll;
  const TableStep step = step_in_table(small_table(), state, nullptr);
  EXPECT_NEAR(step.wheels[0].force[2], 40e3, 0.1);
  EXPECT_NEAR(step.wheels[1].force[2], 70e3, 0.1);
}

/// Where the solver finds it, within what the loads may be off.
TEST(TableEquilibrium, IsWhereTheSolverHasIt) {
  const VehicleState state = state_of_test();
  const StaticLoads loads{LoadsOf::axle, {110e3, 5e6}};
  const TableEquilibrium found = find_table_equilibrium(small_table(), state, loads);
  ASSERT_TRUE(found.converged);
  SceneSolver solver;
  const StaticEquilibrium exact =
      find_static_equilibrium(scene_of_small_table(), state, loads, solver);
  EXPECT_NEAR(found.vertical, exact.vertical, 2e-3);
  EXPECT_NEAR(found.roll, exact.roll, 3e-6);
}

TEST(TableEquilibrium, RefusesLoadsBeyondTheTableAndSaysThatThereIsNone) {
  VehicleState state = state_of_test();
  expect_error(
      ErrorCode::invalid_argument,
      [&] {
        (void)find_table_equilibrium(small_table(), state, {LoadsOf::wheels, {40e3, 130e3}});
      },
      "load of a wheel = 130000", "at most 120000 N");
  state.position[1] = 5.0;
  EXPECT_FALSE(
      find_table_equilibrium(small_table(), state, {LoadsOf::wheels, {40e3, 70e3}}).converged);
}

} // namespace
} // namespace wrc::test
