/// Height and roll at which a wheelset carries given loads.
///
/// With F and M the force and moment about the wheelset's centre of the rails on each wheel (creep
/// forces included where the scene has them), two conditions for height z and roll phi:
/// * loads of wheels: F_z,left = Q_left and F_z,right = Q_right;
/// * load of the axle: F_z,left + F_z,right = W, and M_x,left + M_x,right = -M, with W the vertical
///   force that the vehicle presses down with and M the moment about x of its forces on the
///   wheelset.
/// Lateral position and yaw are given. In a canted curve W is the component across the track plane.
/// Newton's method with the wheels' Jacobians (derivatives/force_jacobian.hpp), from the heights
/// at which the wheels alone carry about their loads; a step that does not lessen the residual is
/// halved. Loads are met within a hundredth of the accuracy.
/// Numbers outside are in the scene's convention. Thread rule: pure functions except for the
/// solver.
///
/// Not known here: lateral equilibrium, and several equilibria, of which the start decides.
#pragma once

#include <array>

#include "scene/vehicle_step.hpp"

namespace wrc {

enum class LoadsOf { wheels, axle };

struct StaticLoads {
  LoadsOf of = LoadsOf::wheels;
  /// N: left and right, each > 0; or the axle's vertical force, > 0, and its moment about x.
  std::array<double, 2> values{};
};

/// N and N mm, checked; of an axle the moment that the wheels have to bear. Throws
/// Error(invalid_argument).
std::array<double, 2> checked_loads(const StaticLoads& loads, const Convention& convention);
/// Newton's change of height and roll that brings what is missing; `slope` by rows.
std::array<double, 2> newton_change(const std::array<std::array<double, 2>, 2>& slope,
                                    const std::array<double, 2>& missing);
/// About what each wheel carries.
std::array<double, 2> loads_of_wheels(LoadsOf of, const std::array<double, 2>& loads);

struct StaticEquilibrium {
  Scene scene;             ///< in its place
  SceneResult result;      ///< there
  double vertical = 0.0;   ///< the scene's convention
  double roll = 0.0;       ///< rad
  double unbalanced = 0.0; ///< what is missing of both loads, each over its size (norm)
  bool converged = false;  ///< all loads are met
  int solutions = 0;       ///< that it took
};

/// Position: lateral and yaw are used. Throws Error(invalid_argument) for loads that are not
/// permitted, and the errors of solutions, no_contact where the wheels are beside the rails.
StaticEquilibrium find_static_equilibrium(const Scene& scene, const VehicleState& state,
                                          const StaticLoads& loads, SceneSolver& solver);

} // namespace wrc
