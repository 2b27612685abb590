/// Creepages of a patch from the motion of the wheelset.
///
/// The wheel's material at the patch's reference, r from the wheelset's centre, moves over that of
/// the rail with
///
///   v = (V (1 - kappa y), v_y, v_z) + omega x r - v_rail
///   omega = (yaw rate + kappa V) e_z + (roll rate) e_x' + (pitch rate) e_axle - omega_rail
///
/// v_rail the velocity of the rail there, 0 unless it is given, omega_rail that of its roll, e_x'
/// the track's x turned by the yaw, e_axle the axle pointing left, kappa the curvature of the
/// track, positive in left-hand curves, and y the centre's lateral position. The reference is on
/// the wheel's undeformed surface, one approach below the rail's, at y_r. With the mean of the
/// speeds of travel and of rolling there (CONTACT, Vollebregt),
///
///   V_ref = (V (1 - kappa y_r) - pitch rate (e_axle x r)_x)/2,
///
/// creepages are v along the patch's axes and omega along its normal, over |V_ref|. Near standstill
/// they are over (V_ref^2 + V_0^2)^(1/2) instead, so that they go to 0 with the velocities.
///
/// Left-hand frame of the side. Units mm, s, rad. Thread rule: pure functions.
///
/// Not known here: the slip of each element (wheel/rigid_slip.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/value_with_rates.hpp"
#include "geometry/frames.hpp"
#include "geometry/rail_surface.hpp"
#include "patches/contact_frame.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// Velocities of the wheelset, track frame.
struct Motion {
  double speed = 0.0; ///< V along the track, mm/s; backwards below 0
  std::optional<double>
      pitch{};            ///< rad/s, > 0 rolls forward; not set: speed over the nominal radius
  double lateral = 0.0;   ///< mm/s
  double vertical = 0.0;  ///< mm/s
  double roll = 0.0;      ///< rad/s
  double yaw = 0.0;       ///< rad/s
  double curvature = 0.0; ///< kappa, 1/mm
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

  [[nodiscard]] double pitch_rate() const {
    return motion.pitch.value_or(motion.speed / nominal_radius);
  }
};

/// Velocity at the place of the creepages, and turning, of the wheel's material against the rail's
/// over the speed of slip, each along a patch's longitudinal, lateral and normal axes; turning in
/// 1/mm.
constexpr std::size_t twist_count = 6; // not a tuning constant
using Twist = std::array<double, twist_count>;

struct RigidSlip {
  Creepages creepages;
  Twist twist{};
  double reference_speed = 0.0; ///< V_ref, mm/s; below 0 the wheel rolls backwards
  double slip_speed = 0.0; ///< what creepages are multiplied with to give velocities, mm/s, > 0
};

RigidSlip rigid_slip(const WheelsetMotion& wheelset, const ContactFrame& frame, double approach);

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
constexpr std::size_t position_count = 4; // not a tuning constant
constexpr std::size_t state_count = 10;   // not a tuning constant
/// A number with its derivatives by all of them.
using RatedByState = WithRates<state_count>;
/// Of all contact forces of a wheel (wheel/force_jacobian.hpp): rows Fx, Fy, Fz, Mx, My, Mz;
/// columns as StateVariable.
using ForceJacobian = std::array<std::array<double, state_count>, 6>;

/// A patch's frame and its place on the wheel, with their derivatives by the positions.
struct MovingFrame {
  VectorOf<RatedByState> longitudinal, lateral, normal;
  VectorOf<RatedByState> place;  ///< on the wheel's undeformed surface
  VectorOf<RatedByState> centre; ///< of the wheelset
  RatedByState reference_y;      ///< of the patch's reference
  RatedByState s_wheel;          ///< of it, on the wheel's profile
};

/// Of a patch, with the derivatives.
struct RatedSlip {
  std::array<RatedByState, twist_count> twist;
  RatedByState slip_speed; ///< as RigidSlip
};

RatedSlip rated_slip(const WheelsetMotion& wheelset, const MovingFrame& frame);

} // namespace wrc
