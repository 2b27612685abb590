/// Constants of behaviour of this room used by several of its files.
///
/// Each with its origin, as `scripts/list_constants.sh` prints them.
#pragma once

namespace wrc {

/// To which contact points are found along a profile, least distances agree, and tables of heights
/// follow their curve, mm.
/// origin: derived: ten times the rounding of positions of 500 mm, 1e-13.
inline constexpr double position_tolerance = 1e-12;

/// Steps of Newton's method on one ray.
/// origin: bound: free_newton_steps suffice on smooth profiles, halvings beyond a kink.
inline constexpr int max_newton_steps = 50;

/// To which single rays are traced, mm.
/// origin: derived: a tenth of a thousandth of the smallest approach of interest, 1e-8 mm.
inline constexpr double ray_tolerance = 1e-12;

/// At a step of a profile, as the rounding of a standard's coefficients leaves it, Newton's method
/// finds no root: a point this near, mm, is accepted.
/// origin: reasoned: standards state coefficients whose pieces meet to about 1e-3 mm.
inline constexpr double step_tolerance = 2e-3;

/// First limit of a step of Newton's method, mm.
/// origin: reasoned: less than the shortest arc of a standard profile.
inline constexpr double first_ray_step = 4.0;

/// At a kink or a step Newton's method may alternate: after this many steps it closes in.
/// origin: reasoned: more than it needs on smooth profiles.
inline constexpr int free_newton_steps = 10;

/// Slope along the track, and around wheels, up to which contact is searched: on a slope e it is r
/// e ahead of the axle. origin: reasoned: ramps of noses and flats of wheels have slopes below 1:5.
inline constexpr double steepest_along = 0.2;

/// Depth to which a wheel sinks, mm.
/// origin: reasoned: under 80 kN.
inline constexpr double typical_depth = 0.1;

/// Depth to which a wheel sinks under any load, mm.
/// origin: measured: the wheel of Table 1 sinks by 0.31 mm under 700 kN (wrc_case --json
/// --set load.left=7e5 --set solve.side=left, left.depth), ten times its load.
inline constexpr double greatest_depth = 3.0 * typical_depth;

/// A surface seen from the ray at a flatter angle than this (its cosine) no longer faces it.
/// origin: bound: 1 degree.
inline constexpr double min_facing_cosine = 0.02;

} // namespace wrc
