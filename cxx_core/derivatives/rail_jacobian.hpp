/// How all contact forces of a wheel change with the position and velocity of its rail.
///
/// Nothing but the place of the wheelset against the rail matters, so a rail that moves one way is
/// a wheelset that moves the other way: with J the wheelset's Jacobian (force_jacobian.hpp), y the
/// rail's lateral displacement, z its height and d its roll about its profile's origin O, C the
/// wheelset's centre,
///   dF/dy = -J_lateral,   dF/dz = -J_vertical,
///   dF/dd = e_x x F + J q',   q' the wheelset's motion by a turn of -1 about O:
///   lateral C_z - O_z, vertical O_y - C_y, roll -cos(yaw), yaw -sin(yaw) tan(roll),
/// with the velocities against the rail turned likewise; moments as forces. The rates of y, z and d
/// enter as the wheelset's do, with the opposite sign. In a curve of curvature kappa the speed of
/// the wheelset's centre, V (1 - kappa y), stays.
/// Units N, N mm by mm, rad, mm/s, rad/s. Track frame. Thread rule: pure functions.
///
/// Not known here: the turn of the yaw rate with the rail's roll, of the order of the curvature
/// times the wheel's radius; and what the rail's roll rate would change in the speed that
/// creepages are divided by if it were a pitch rate, of the order of the yaw angle squared.
#pragma once

#include <array>

#include "records/motion.hpp"

namespace wrc {

struct WheelDetails;
struct WheelResult;

constexpr std::size_t rail_state_count = 6; // not a tuning constant
/// Rows Fx, Fy, Fz, Mx, My, Mz; columns lateral displacement, height, roll, and their rates.
using RailJacobian = std::array<std::array<double, rail_state_count>, 6>;

/// The wheelset's rates of positions and velocities that do what unit rates of the rail's lateral
/// displacement, height and roll, and of their rates, do; left-hand frame of the side.
std::array<std::array<double, state_count>, rail_state_count>
opposite_motions(const WheelDetails& details);

/// From the Jacobian of the wheel (SceneWheel::jacobian).
RailJacobian rail_jacobian_of(const WheelResult& wheel, const ForceJacobian& jacobian);

} // namespace wrc
