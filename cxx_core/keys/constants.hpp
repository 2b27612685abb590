/// Constants of behaviour of this room: limits of keys, and values beyond which their unit is
/// likely to be another.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Load of a wheel, N, below which it is warned of unless it is 0.
/// origin: reasoned: an empty wagon's wheel carries 20 kN, and 80 means kN.
inline constexpr double least_load = 1000.0;
/// Speed of standstill, over a speed of at least slow_speed, above which it is warned of.
/// origin: reasoned: creepages become smaller by 0.5 %, and 100 in m/s means 100 mm/s.
inline constexpr double greatest_standstill_share = 0.1;
/// Inclination of rails, rad, above which it is warned of.
/// origin: reasoned: rails are laid at 1:20 to 1:40, and 0.1 is the cant of a track of 150 mm.
inline constexpr double steepest_inclination = 1.0 / 15.0;

// Ranges and limits of keys.

/// Largest coefficient of friction.
/// origin: bound: ten times that of clean steel.
inline constexpr double max_friction = 10.0;

/// Positions on a wheel at which friction may be given, each two numbers.
/// origin: bound: more than one per millimetre.
inline constexpr std::size_t max_friction_places = 256;

/// Largest permitted creepage, and spin in 1/mm.
/// origin: bound: full sliding in every case.
inline constexpr double max_creepage = 10.0;

/// Waves of a wheel have no effect if the sum of their amplitudes, times the squares of their
/// orders, is below this length times the accuracy, mm. origin: derived: a thousandth of an overlap
/// of 1e-4 mm, that of some newtons on a wheel; the change of its curvature is less.
inline constexpr double negligible_waves = 1e-3 * 1e-4;

/// Largest solve.accuracy at which Kalker's coefficients of a patch are not warned of.
/// origin: measured (PatchCoefficients in scene_test): at most 3.8 % off at 1e-3, 15 % at 1e-2 on
/// ellipses, 40 % on wheels.
inline constexpr double coarsest_for_coefficients = 1e-3;

} // namespace wrc
