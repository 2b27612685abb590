/// Creep forces of a patch, and how they change.
///
/// In the track frame, both sides alike, unless a member says otherwise: x forward, y to the left
/// along the patch's plane; forces on the wheel, moments about the contact reference.
/// Units mm, N, MPa, rad. Thread rule: plain values.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/grid.hpp"
#include "base/heap_optional.hpp"
#include "records/motion.hpp"
#include "records/slip_geometry.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// Derivatives of Fx, Fy (N) and Mz (N mm) about the contact reference, each with the other
/// variables fixed: derivatives by creepages leave out that friction falls with slip and that slip
/// beyond the creepages changes.
struct CreepDerivatives {
  std::array<double, 9> by_creepage{}; ///< by xi, eta, phi (1/mm), row by row
  /// As if the contact stayed similar (Hertz), lengths as N^(1/3): T/N then depends on xi/N^(1/3),
  /// eta/N^(1/3) and phi alone.
  std::array<double, 3> by_load{};
  /// F is homogeneous in mu and slips: mu dF/dmu = F - xi dF/dxi - eta dF/deta - phi dF/dphi, less
  /// the derivative by a common factor of the slip beyond them; of unlike bodies without what their
  /// pressures add.
  std::array<double, 3> by_friction{};
  /// By lateral position, height, roll and yaw, as the patch's pressures and its reference change
  /// with them (creep/creep_rates.hpp), row by row; left-hand frame of the side. None where these
  /// are not known.
  std::optional<std::array<double, 12>> by_position;
  /// Derivatives of Fx, Fy, Mz and the force along the normal in CreepResult::beyond_creepages (N),
  /// left-hand frame: by a common factor of the slip beyond creepages, and ...
  std::array<double, 4> by_slip{};
  /// ... by a velocity along the normal, over that of slip, through the slip that it adds. Other
  /// velocities are left out: they act through the creepages, and a thousand times less through
  /// this.
  std::array<double, 4> by_normal_velocity{};
  /// By the share of rolling (rolling_problem.hpp), in a step of time and along a curve only. In a
  /// step all of these are at fixed velocities of slip instead of fixed creepages.
  std::optional<std::array<double, 4>> by_rolling_share;
  /// Derivatives of that force along the normal, left-hand frame.
  std::array<double, 3> normal_by_creepage{};
  std::array<double, position_count> normal_by_position{};
  /// How SlipGeometry::creepages_by_twist changes with the same positions; left-hand frame.
  std::optional<std::array<CreepagesByTwist, position_count>> slip_by_position;
};

/// The tangential contact of one patch.
struct CreepResult {
  /// From a motion the best fit to the slip of its elements, of all parts together; of planar slip
  /// the mean of the parts by load, each on its own rolling radius, carried to the reference.
  Creepages creepages;
  double slip_variation = 0.0; ///< root mean square of the slip beyond them (rigid_slip.hpp)
  double friction = 0.0;       ///< coefficient; of parts the mean by load
  double slip_speed = 0.0;     ///< what creepages are multiplied with to give velocities, mm/s
  double longitudinal_force = 0.0;
  double lateral_force = 0.0;
  double spin_moment = 0.0;
  double slip_area = 0.0;
  double adhesion_area = 0.0;
  double largest_traction = 0.0; ///< not-a-number where an end of a body cuts the patch
  /// Power that friction dissipates over the speed, N: -F.w (of a patch with parts, the sum of
  /// theirs), plus that of the slip beyond creepages, plus `power_of_pressures`.
  double power_per_speed = 0.0;
  /// In the slip that pressures cause, of unlike bodies or along a curve.
  double power_of_pressures = 0.0;
  double friction_power = 0.0; ///< N mm/s
  double numerical_loss = 0.0; ///< fraction of it lost by discretisation
  /// error of forces over mu N; of the full theory only
  std::optional<double> error_estimate;
  /// Likewise, of steady rolling where forces change along the path (derivatives/steady_error.hpp);
  /// none if their rates are not known.
  std::optional<double> steady_error;
  /// What tractions change in the pressures, mean over mean; of unlike bodies.
  double pressure_change = 0.0;
  /// What the slip beyond creepages adds to force and moment, N and N mm, left-hand frame:
  /// tractions act where each element slips (total_force.hpp).
  Wrench beyond_creepages{};
  double residual = 0.0;
  int convolutions = 0;
  double elements_wanted = 0.0;               ///< for the accuracy, of all parts
  HeapOptional<CreepDerivatives> derivatives; ///< on request
  Grid grid;                      ///< of the fields, left-hand frame of the side; none with parts
  std::vector<double> pressure;   ///< on it
  std::vector<double> traction_x; ///< left-hand frame of the side, as all fields
  std::vector<double> traction_y;
  std::vector<double> slip_x; ///< over the speed
  std::vector<double> slip_y;
  std::vector<double> displacement_x; ///< after a step of time (RollingSolution), mm; else empty
  std::vector<double> displacement_y;
};

} // namespace wrc
