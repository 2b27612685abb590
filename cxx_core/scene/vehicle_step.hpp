/// One evaluation of a vehicle simulation: positions and velocities of a wheelset in, forces,
/// Jacobians and patches out, as plain arrays.
///
/// Numbers are in the scene's convention (scene/convention.hpp). Thread rule: pure functions but
/// for the result, one thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "scene/solve_scene.hpp"

namespace wrc {

using SixNumbers = std::array<double, 6>;

/// What a scene is solved at.
struct VehicleState {
  /// x, y, z, roll, pitch angle, yaw of the wheelset. Nothing depends on x and the pitch angle.
  SixNumbers position{};
  /// Their rates; that of the pitch angle is positive when the axle rolls forward, in any frame.
  SixNumbers velocity{};
  /// Displacement of the left rail and of the right one: lateral, vertical, roll each. Not set: as
  /// in the scene.
  std::optional<SixNumbers> rails;
  bool derivatives = false; ///< whether Jacobians are wanted
};

/// Of one wheel; zeros without contact.
struct WheelForces {
  SixNumbers force{}; ///< on the wheel, and its moment about the wheelset's centre
  /// Derivatives of the six by each position and each velocity: by x, by y, ...
  std::array<SixNumbers, 6> by_position{};
  std::array<SixNumbers, 6> by_velocity{};
  int state = 0; ///< flags of wheel/wheel_state.hpp
};

/// A contact patch as vehicle codes know it. The layout is that of wrc_patch.
struct PatchSummary {
  double wheel = 0.0; ///< 0: left, 1: right
  double x = 0.0, y = 0.0, z = 0.0;
  double normal_x = 0.0, normal_y = 0.0, normal_z = 0.0; ///< from the rail to the wheel
  double contact_angle = 0.0;
  double rolling_radius = 0.0;
  double s_wheel = 0.0; ///< place on the wheel's profile
  double normal_force = 0.0;
  double longitudinal_creep_force = 0.0;
  double lateral_creep_force = 0.0;
  double spin_moment = 0.0;
  double longitudinal_creepage = 0.0;
  double lateral_creepage = 0.0;
  double spin_creepage = 0.0;
  double longitudinal_semi_axis = 0.0;
  double lateral_semi_axis = 0.0;
  double approach = 0.0;
  double largest_pressure = 0.0;
  double friction_power = 0.0;
  // The same under the names of results by name:
  double pmax = 0.0;
  double semi_axes_longitudinal = 0.0;
  double semi_axes_lateral = 0.0;
  double creep_force_longitudinal = 0.0;
  double creep_force_lateral = 0.0;
  double creepage_longitudinal = 0.0;
  double creepage_lateral = 0.0;
  double creepage_spin = 0.0;
  double angle = 0.0;
  // More of them:
  double longitudinal_force = 0.0; ///< by pressures and creep forces, track frame
  double lateral_force = 0.0;
  double vertical_force = 0.0;
  double pressure_force_x = 0.0;
  double pressure_force_y = 0.0;
  double pressure_force_z = 0.0;
  double coupling_weight = 0.0;
};

/// Creep forces of a patch at creepages of the caller's own.
struct PatchCreep {
  std::array<double, 3> forces{};      ///< longitudinal, lateral, and the spin moment
  std::array<double, 9> by_creepage{}; ///< row by row: by the longitudinal, lateral, spin creepage
};

/// The scene at this state. Throws Error(invalid_argument) that names the key whose range a number
/// is out of, or one that has no forces, or with derivatives no derivatives.
Scene scene_at(const Scene& scene, const VehicleState& state);
/// Left and right.
std::array<WheelForces, 2> wheel_forces(SceneResult& result, const Convention& convention,
                                        bool derivatives);
/// All patches, those of the left wheel first, each wheel's in the order of their places on it from
/// the flange on: they keep their order from step to step.
std::vector<PatchSummary> patch_summaries(const SceneResult& result, const Convention& convention);

/// Of a patch in the order of patch_summaries, with friction, accuracy and model of the scene.
/// Throws Error(invalid_argument).
PatchCreep creep_of(const Scene& scene, const SceneResult& result, std::size_t index,
                    const std::array<double, 3>& creepages, bool derivatives, SceneSolver& solver);

} // namespace wrc
