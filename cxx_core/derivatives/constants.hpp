/// Constants of behaviour of this room: derivatives by the wheelset's motion.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

namespace wrc {

/// Less is not aimed at: the residual that the iteration carries along would go on falling, the
/// true one would not.
/// origin: derived: some fifty roundings of double precision.
inline constexpr double min_stiffness_tolerance = 1e-14;

/// The part of an answer that is new is not kept below this fraction of its energy: it would
/// consist of rounding.
/// origin: derived: the square of 1e-10, what cancellation leaves of a sum of thousands.
inline constexpr double min_new_energy = 1e-20;

/// Tolerance of the linear solutions of sensitivities.
/// origin: measured: the rates neglect more (wheel_rates.hpp).
inline constexpr double sensitivity_tolerance = 1e-4;

/// Error of steady creep forces over mu N, by the change of F/(mu N) over a contact length, and its
/// greatest value.
/// origin: measured (tests/core/scene/steady_forces_test.cpp, long): covers the largest error of 92
/// % of random sequences of transient rolling or more.
inline constexpr double steady_error_by_rate = 0.7;
inline constexpr double most_steady_error = 0.12;
/// Greatest difference of two creep forces, over mu N. origin: derived: each is mu N at most.
inline constexpr double most_difference = 2.0;

} // namespace wrc
