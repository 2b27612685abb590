/// Creepages of a patch from the motion of the wheelset.
///
/// The wheel's material at the patch's reference, r from the wheelset's centre, moves over the
/// rail, which is at rest, with
///
///   v = (V (1 - kappa y), v_y, v_z) + omega x r
///   omega = (yaw rate + kappa V) e_z + (roll rate) e_x' + (pitch rate) e_axle
///
/// e_x' the track's x turned by the yaw, e_axle the axle pointing left, kappa the curvature of the
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
/// Not known here: that slip varies with the patch's curvature.
#pragma once

#include <optional>

#include "geometry/frames.hpp"
#include "patches/contact_frame.hpp"
#include "rolling/rolling_contact.hpp"

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

/// The motion seen in the mirror y -> -y.
Motion mirrored(const Motion& motion);

struct RigidSlip {
  Creepages creepages;
  double reference_speed = 0.0; ///< V_ref, mm/s; below 0 the wheel rolls backwards
  double slip_speed = 0.0; ///< what creepages are multiplied with to give velocities, mm/s, > 0
};

/// `height`: of the wheelset's centre; `nominal_radius` makes the pitch rate if that is not set.
RigidSlip rigid_slip(const Motion& motion, const Pose& pose, double height, double nominal_radius,
                     const ContactFrame& frame, double approach);

} // namespace wrc
