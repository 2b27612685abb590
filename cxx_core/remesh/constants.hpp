/// Constants of behaviour of this room: rays from the contact plane to the surfaces.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Steps of Newton's method on a row of rays at once; rays that need more are traced one by one.
/// origin: bound: Newton's method doubles the digits.
inline constexpr int max_ray_steps = 5;

/// Greatest estimated error of a ray that counts as met, mm.
/// origin: derived: three roundings of a wheel's radius of 460 mm.
inline constexpr double ray_error = 3e-13;

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

/// Larger than any distance at which bodies could meet, mm.
/// origin: derived: twice the radius of a wheel.
inline constexpr double no_material_distance = 1e3;

/// Sine of the angle between both tangents above which a contact is at a kink.
/// origin: reasoned: above the rounding of tangents, below any kink that a profile has on
/// purpose.
inline constexpr double kink_sine = 1e-6;

/// Power of the cosine of a row's inclination in its scale.
/// origin: derived: see row_scales.hpp.
inline constexpr double scale_by_inclination = 0.75;

/// Points of the curve of a patch (mean_curve.hpp).
/// origin: reasoned: the number of rows that expected_contact.hpp takes, more than a solution has.
inline constexpr std::size_t curve_nodes = 65;

} // namespace wrc
