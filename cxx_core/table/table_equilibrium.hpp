/// Height and roll at which a wheelset carries given loads, by a table.
///
/// As scene/static_equilibrium.hpp, which has the conditions: Newton's method, first to the depths
/// that wheels of these loads have after Hertz, which may start from anywhere, then to the loads.
/// Thread rule: pure functions.
#pragma once

#include "scene/static_equilibrium.hpp"
#include "table/table_step.hpp"

namespace wrc {

struct TableEquilibrium {
  double vertical = 0.0; ///< the table's convention
  double roll = 0.0;
  bool converged = false;
};

/// Position: lateral and yaw are used. Throws Error(invalid_argument) for loads that are not
/// permitted or that the table does not reach.
TableEquilibrium find_table_equilibrium(const ContactTable& table, const VehicleState& state,
                                        const StaticLoads& loads);

} // namespace wrc
