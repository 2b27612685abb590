/// How the undeformed distance of each element changes when the wheel moves as a rigid body.
///
/// The grid and its plane stay fixed in the track, and so does the rail. A point r of the wheel's
/// surface moves by d(r) = translation + rotation x (r - r_c), r_c the wheelset's centre. The ray
/// of an element runs along the plane's normal n and meets the wheel where its surface's normal is
/// n_w; there the distance changes by
///   dh = (d . n_w) / (n . n_w),
/// which is the condition that the moved surface holds the new end of the ray. n_w is the gradient
/// of the wheel's surface (geometry/wheel_line.hpp), of one profile (X, -rho w', Z) with its slope
/// w'; nothing is differentiated numerically.
/// Motions are those of the pose R = Rz(yaw) Rx(roll): a growing roll turns the wheelset about
/// Rz(yaw) e_x, since the yaw comes first; a growing yaw about the track's z.
/// Units mm and rad (rates per mm or per rad); track frame, left-hand side (geometry/frames.hpp).
/// Thread rule: pure functions.
/// Not known here: that the plane would turn with the motion, and second derivatives: at a kink of
/// the profile the rate is that of the side on which the ray meets it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/by_motion.hpp"
#include "base/grid.hpp"
#include "patches/contact_frame.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

/// Velocity of the wheelset: of its centre, and of its turning about the centre. Track frame.
struct RigidMotion {
  Vector3 translation;
  Vector3 rotation;
};

/// Motion of a wheelset whose lateral position, height, roll or yaw grows.
RigidMotion lateral_motion();
RigidMotion vertical_motion();
RigidMotion roll_motion(double yaw);
RigidMotion yaw_motion();
/// These four, in the order of ByMotion.
std::array<RigidMotion, motion_count> all_motions(double yaw);

/// One vector a motion, with one rate per element of the grid, in the grid's order. Only elements
/// with `wanted` > 0 are computed, such as those under pressure (all of them, if it is empty); the
/// others, and those whose ray meets no wheel, get 0.
void compute_gap_rates(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                       std::span<const double> wanted, std::span<const RigidMotion> motions,
                       std::vector<std::vector<double>>& rates);

} // namespace wrc
