/// Constants of behaviour of this room: rays from the contact plane to the surfaces.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

#include "geometry/constants.hpp"

namespace wrc {

/// Steps of Newton's method on a row of rays at once; rays that need more are traced one by one.
/// origin: bound: Newton's method doubles the digits.
inline constexpr int max_ray_steps = 5;

/// Greatest estimated error of a ray that counts as met, mm.
/// origin: derived: three roundings of a wheel's radius of 460 mm.
inline constexpr double ray_error = 3e-13;

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

/// Rows over a penetration that show what contact it leads to (accuracy/expected_contact.hpp), and
/// points of the curve of a patch (mean_curve.hpp).
/// origin: measured (smoothness): with 33 forces leave the line of the stiffness by 2.2e-5 instead
/// of 8e-7 where two lobes part.
inline constexpr std::size_t penetration_rows = 65;

/// Difference of a gap along the rail from its parabola, root mean square over its depth, above
/// which it counts as bent in full.
/// origin: measured (20 wheels on flats and 20 on a crossing, creep forces at 1e-2): with 0.015 to
/// 0.06 the same 3 of 40 miss it; with 0.06 twice the number of wheels is warned of. Flats have
/// 0.03 to 0.15, a crossing between its ends 0.001.
inline constexpr double whole_bend = 0.03;

} // namespace wrc
