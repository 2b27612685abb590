#include <cmath>

#include <gtest/gtest.h>

#include "table/small_table.hpp"
#include "table/table_nodes.hpp"
#include "table/table_work.hpp"

namespace wrc::test {
namespace {

/// Where it is fitted: without, slopes are 7 to 13 % off there.
TEST(TableFit, SlopesOfCreepForcesAreThoseOfTheFullTheory) {
  ContactTable table = small_table();
  const double lateral = -0.5;
  const double depth = 0.5;
  TensorSpline<3, 2>::Values touch;
  table.touch.evaluate({lateral, 0.0, 0.0}, touch);
  const TablePose pose =
      pose_of_taping_point(table, from_aligned(table, lateral, 0.0, 0.0),
                           touch.value[0] - depth * std::exp(touch.value[1]), 0.0);
  TableState state;
  state.position = {0.0, pose.lateral, pose.vertical, 0.0, 0.0, 0.0};
  state.velocity = {2e4, 0.0, 0.0, 0.0, 2e4 / 460.0, 0.0};
  const TableContact found = contact_in_table(table, state, true);
  TableNodes nodes(scene_of_small_table(), SceneSolver(), table);
  const ForceJacobian* exact = nodes.solve_exactly(state, true, 1e-3).jacobian();
  ASSERT_NE(exact, nullptr);
  EXPECT_NEAR(found.rates[0][4] / (*exact)[0][4], 1.0, 0.02); // Fx by speed
  EXPECT_NEAR(found.rates[1][5] / (*exact)[1][5], 1.0, 0.02); // Fy by lateral velocity
}

} // namespace
} // namespace wrc::test
