/// Smoothing splines with a wavelength in mm at which the amplitude is halved.
///
/// Minimises  sum w_i (z_i - f(u_i))^2 + lambda int f''^2 du  (Reinsch, Smoothing by spline
/// functions, Numerische Mathematik 10, 1967), with w_i the length of the neighbourhood of point i,
/// so that the sum stands for an integral whatever the spacing. A wave of length L is then passed
/// by 1 / (1 + lambda (2 pi / L)^4); lambda = (wavelength / 2 pi)^4 halves the wavelength requested
/// for. Solved by the banded Cholesky factorisation of LAPACK.
///
/// Units mm. Natural end conditions: within a wavelength of the ends curvature is pulled to zero.
/// Does not know: outliers, kinks. Thread rule: no state.
#pragma once

#include <span>
#include <vector>

#include "profile/segments.hpp"

namespace wrc {

/// Values of the smoothing spline at the abscissae, which must ascend strictly. Throws
/// Error(invalid_argument); Error(internal) if the wavelength is so long against the closest
/// points that the system is not positive definite in double precision.
std::vector<double> smooth_values(std::span<const double> abscissa, std::span<const double> value,
                                  double wavelength);

/// Points with both coordinates smoothed over chord length, which serves steep flanks too. The
/// first pass finds the length along the smoothed line, since noise lengthens the chords; the
/// second smooths over it.
std::vector<Position> smooth_points(std::span<const Position> points, double wavelength);

} // namespace wrc
