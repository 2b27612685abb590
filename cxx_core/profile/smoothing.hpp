/// Smoothing splines with a wavelength in mm at which the amplitude is halved.
///
/// The spline of reinsch_spline.hpp.
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
