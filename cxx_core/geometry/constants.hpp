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

/// A surface seen from the ray at a flatter angle than this (its cosine) no longer faces it.
/// origin: bound: 1 degree.
inline constexpr double min_facing_cosine = 0.02;

} // namespace wrc
