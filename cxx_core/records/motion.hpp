/// How a wheelset moves, and what forces depend on.
///
/// Units mm, s, N, rad. Thread rule: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/by_motion.hpp"
#include "geometry/frames.hpp"
#include "geometry/rail_surface.hpp"

namespace wrc {

/// Velocities of the wheelset, track frame.
struct Motion {
  double speed = 0.0; ///< V along the track, mm/s; backwards below 0
  std::optional<double>
      pitch{};           ///< rad/s, > 0 rolls forward; not set: speed over the nominal radius
  double lateral = 0.0;  ///< mm/s
  double vertical = 0.0; ///< mm/s
  /// Otherwise wheels follow surfaces that vary (creep/kinematics.hpp).
  bool vertical_is_given = false;
  double roll = 0.0;      ///< rad/s
  double yaw = 0.0;       ///< rad/s
  double curvature = 0.0; ///< kappa, 1/mm
  /// V_0, mm/s, > 0 (creep/kinematics.hpp). At 1 m/s the default changes creepages by 5e-7.
  double standstill_speed = 1.0;
  /// Rates of the velocities: along the track, lateral, vertical, roll, pitch, yaw; mm/s^2,
  /// rad/s^2. Forces do not depend on them, but how these change along the path does.
  std::array<double, 6> acceleration{};
};

/// A wheelset that moves: what is the same for all patches of a wheel.
struct WheelsetMotion {
  Motion motion;
  Pose pose;
  double height = 0.0;         ///< of the wheelset's centre
  double nominal_radius = 0.0; ///< makes the pitch rate if that is not set
  RailDisplacement rail_velocity;
  double rail_origin_y = 0.0; ///< of the rail's profile, about which it rolls
  double rail_origin_z = 0.0;
  /// Whether the wheel's vertical velocity is that at which contact neither closes nor opens
  /// (creep/kinematics.hpp).
  bool follows_surface = false;
  /// Change of the rail's displacement along the track, 1 and rad/mm: irregularities.
  RailDisplacement rail_slope{};

  [[nodiscard]] double pitch_rate() const {
    return motion.pitch.value_or(motion.speed / nominal_radius);
  }
};

/// Velocity at the point of the creepages, and turning, of the wheel's material against the rail's
/// over the speed of slip, each along a patch's longitudinal, lateral and normal axes; turning in
/// 1/mm.
constexpr std::size_t twist_count = 6; // not a tuning constant
using Twist = std::array<double, twist_count>;

/// Force and moment about the point of the velocities, as Twist: their product with it is power.
using Wrench = std::array<double, twist_count>;

/// What forces depend on: positions of the wheelset and its velocities, mm, s, rad.
enum class StateVariable : std::size_t {
  lateral,
  vertical,
  roll,
  yaw,
  speed,
  lateral_velocity,
  vertical_velocity,
  roll_rate,
  pitch_rate,
  yaw_rate
};
constexpr std::size_t position_count = motion_count; // the first four
constexpr std::size_t state_count = 10;              // not a tuning constant
/// Derivatives of all contact forces of a wheel (derivatives/force_jacobian.hpp): rows Fx, Fy, Fz,
/// Mx, My, Mz; columns as StateVariable.
using ForceJacobian = std::array<std::array<double, state_count>, 6>;

} // namespace wrc
