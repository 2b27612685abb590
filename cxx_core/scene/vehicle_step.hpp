/// One evaluation of a vehicle simulation: positions and velocities of a wheelset in, forces and
/// Jacobians out, as plain arrays.
///
/// Numbers are in the scene's convention (keys/convention.hpp). Thread rule: pure functions except
/// for the result, one thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "creep/elastic_history.hpp"
#include "derivatives/rail_jacobian.hpp"
#include "scene/constants.hpp"
#include "scene/solve_scene.hpp"

namespace wrc {

using SixNumbers = std::array<double, 6>;

/// What a scene is solved at.
struct VehicleState {
  /// x, y, z, roll, pitch angle, yaw of the wheelset. x and the pitch angle count only where a rail
  /// or a wheel varies.
  SixNumbers position{};
  /// Their rates; that of the pitch angle is positive when the axle rolls forward, in any frame.
  /// Not set: as in the scene.
  std::optional<SixNumbers> velocity;
  /// Displacement of the left rail and of the right one: lateral, vertical, roll each. Not set: as
  /// in the scene.
  std::optional<SixNumbers> rails;
  std::optional<SixNumbers> rail_velocities;     ///< likewise: their rates
  std::optional<double> curvature;               ///< of the track; likewise
  std::optional<std::array<double, 2>> friction; ///< of the left and the right wheel; likewise
  bool derivatives = false;                      ///< whether Jacobians are wanted
  /// That a step of time starts from; none: steady rolling.
  std::shared_ptr<const ContactHistory> history;
  double time_step = 0.0; ///< s, with a history; else 0
};

/// Forces of one wheel; zeros without contact.
struct WheelForces {
  SixNumbers force{}; ///< on the wheel, and its moment about the wheelset's centre
  /// Derivatives of the six by each position and each velocity: by x, by y, ...
  std::array<SixNumbers, 6> by_position{};
  std::array<SixNumbers, 6> by_velocity{};
  /// By lateral, vertical and roll displacement of the wheel's own rail, and by their rates.
  std::array<SixNumbers, 3> by_rail{};
  std::array<SixNumbers, 3> by_rail_velocity{};
  int state = 0; ///< flags of results/wheel_state.hpp
};

/// Creep forces of a patch at creepages of the caller's own.
struct PatchCreep {
  std::array<double, 3> forces{};      ///< longitudinal, lateral, and the spin moment
  std::array<double, 9> by_creepage{}; ///< row by row: by the longitudinal, lateral, spin creepage
};

/// The scene at this state. Throws Error(invalid_argument) that names the key whose range a number
/// is out of, or one that has no forces, or with derivatives no derivatives.
Scene scene_at(const Scene& scene, const VehicleState& state);
/// State that the next time step starts from.
std::shared_ptr<const ContactHistory> history_after(const SceneResult& result);
/// From inside, with derivatives where they are given.
WheelForces forces_to_caller(const WheelForce& total, const ForceJacobian* jacobian,
                             const RailJacobian* by_rail, const Convention& convention);
/// Left and right.
std::array<WheelForces, 2> wheel_forces(SceneResult& result, const Convention& convention,
                                        bool derivatives);

/// Of a scene at a prescribed position in which a rail or a wheel varies: fills in the derivatives
/// by the position along the track and by the pitch, by central differences of two more solutions
/// each.
void add_varying_columns(const Scene& posed, SceneSolver& solver,
                         std::array<WheelForces, 2>& forces);
/// Creep forces of a patch in the order of ordered_patches (scene/patch_summary.hpp), with
/// friction, accuracy and model of the scene. Throws Error(invalid_argument).
PatchCreep creep_of(const Scene& scene, const SceneResult& result, std::size_t index,
                    const std::array<double, 3>& creepages, bool derivatives, SceneSolver& solver);

} // namespace wrc
