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
/// the wheel's undeformed surface, one approach below the rail's, at y_r. Creepages are v along the
/// patch's axes and omega along its normal, over |V_ref|, the mean of the speeds of travel and of
/// rolling there (CONTACT, Vollebregt):
///
///   V_ref = (V (1 - kappa y_r) (e_1x + e_1z^2/e_1x) - pitch rate (e_axle x r) e_1)/2
///
/// Here e_1 is the patch's longitudinal axis: the track's x, by the vertical convention that of the
/// wheelset, and (cos(e), 0, sin(e)) where the plane rises along the track with a slope e, along
/// which the patch travels V/cos(e). Near standstill creepages are over (V_ref^2 + V_0^2)^(1/2)
/// instead, so that they go to 0 with the velocities.
///
/// Where the rail or the wheel varies, a wheelset that does not move vertically would close or open
/// the contact: on a slope e with the speed V sin(e). Unless v_z is given, the wheel is taken to
/// follow the surface: v gets the vertical velocity at which travel and rolling together have no
/// component along the normal but that which they have under a round wheel on a prismatic rail:
/// with the patch where it then is (ContactPatch::ahead) and a normal across the track. Up a slope
/// creepage is then V/cos(e) less the speed of rolling.
///
/// Left-hand frame of the side. Units mm, s, rad. Thread rule: pure functions.
///
/// Not known here: the slip of each element (creep/rigid_slip.hpp).
#pragma once

#include <array>

#include "base/value_with_rates.hpp"
#include "patches/contact_frame.hpp"
#include "records/motion.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

struct RigidSlip {
  Creepages creepages;
  Twist twist{};
  double reference_speed = 0.0; ///< V_ref, mm/s; below 0 the wheel rolls backwards
  double slip_speed = 0.0; ///< what creepages are multiplied with to give velocities, mm/s, > 0
};

/// `ahead`: of the patch, ContactPatch.
RigidSlip rigid_slip(const WheelsetMotion& wheelset, const ContactFrame& frame, double approach,
                     double ahead);

/// A number with its derivatives by positions and velocities.
using RatedByState = WithRates<state_count>;

/// A patch's frame and its position on the wheel, with their derivatives by the positions.
struct MovingFrame {
  VectorOf<RatedByState> longitudinal, lateral, normal;
  VectorOf<RatedByState> place;  ///< on the wheel's undeformed surface
  VectorOf<RatedByState> centre; ///< of the wheelset
  RatedByState reference_y;      ///< of the patch's reference
  RatedByState s_wheel;          ///< of it, on the wheel's profile
  double ahead = 0.0; ///< of the place, as ContactPatch::ahead of the reference; taken to stay
};

/// Slip of a patch, with its derivatives.
struct RatedSlip {
  std::array<RatedByState, twist_count> twist;
  RatedByState reference_speed, slip_speed; ///< as RigidSlip
};

RatedSlip rated_slip(const WheelsetMotion& wheelset, const MovingFrame& frame);

} // namespace wrc
