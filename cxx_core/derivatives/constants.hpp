/// Constants of behaviour of this room: derivatives by the wheelset's motion.
///
/// Each with its origin: published (with author) or derived, bound, measured (with what measures
/// it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

namespace wrc {

/// Less is not aimed at: the residual that the iteration carries along would go on falling, the
/// true one would not.
/// origin: derived: some fifty roundings of double precision.
inline constexpr double min_stiffness_tolerance = 1e-14;

/// What an answer adds to those kept is not worth keeping below this share of its energy: it
/// would consist of rounding.
/// origin: derived: the square of 1e-10, what cancellation leaves of a sum of thousands.
inline constexpr double min_new_energy = 1e-20;

/// Of the linear solutions of sensitivities.
/// origin: measured: what the rates neglect is more (wheel_sensitivities.hpp).
inline constexpr double sensitivity_tolerance = 1e-4;

} // namespace wrc
