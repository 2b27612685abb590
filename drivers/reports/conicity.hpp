/// Equivalent conicity of a wheelset on a track.
///
/// The free wheelset rolls without slip: with the yaw angle psi and the lateral position y over the
/// way x,
///   y' = psi,   psi' = -dr(y) / (2 b r0),
/// where dr is the rolling radius of the left wheel minus that of the right one, b half the
/// distance of the contact points and r0 the nominal radius. A conical wheel of slope g has dr = 2
/// g y and moves in a sine of wavelength 2 pi sqrt(b r0 / g) (Klingel 1883). The equivalent
/// conicity of any dr at an amplitude is the slope of the conical wheel with the same wavelength L
/// there,
///   g = b r0 (2 pi / L)^2
/// (UIC 519:2004, EN 15302:2021, by integration of the equation of motion). b and r0 drop out. The
/// motion keeps psi^2/2 + U(y), U' = dr / (2 b r0), so that L is twice the integral of
/// dy / sqrt(2 (U(turn) - U(y))) between the turning points.
///
/// dr is taken linear between its samples, where the integral has a closed form: nothing is lost at
/// the turning points, where its integrand has poles. Jumps of dr are as steep as the samples are
/// close.
///
/// Differences below a tolerance are zero (constant in conicity.cpp): where that holds from turn to
/// turn, as on cylinders, nothing leads the wheelset back, the wave is infinitely long and the
/// conicity 0. It grows from there once the turning points lie beyond.
///
/// Units mm. Amplitude is half the distance of the turning points, as in both standards.
/// Independent of how dr was obtained: with roll solved, or without as EN 15302 has it.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace driver {

/// Lateral positions in ascending order and rolling radius differences there; NaN where there is
/// none.
struct RadiusDifference {
  std::vector<double> lateral;
  std::vector<double> difference;
};

struct EquivalentConicity {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string reason; ///< why there is no value; empty if there is one
};

/// The equivalent conicity at an amplitude, about the position of rest closest to the centre. There
/// is none if the samples do not reach the turning points (a sample without a difference ends
/// them), if nothing leads the wheelset back to a position of rest, or if no motion has this
/// amplitude since the wheelset runs away to another position of rest.
EquivalentConicity equivalent_conicity(const RadiusDifference& samples, double amplitude);

/// Half of the range in which the conicity lies in 95 of 100 cases: from the root mean square of
/// the differences that likely curves of the profiles make, and the largest that smoothed ones
/// make, added in squares. The largest, since all of them keep waves longer than 15 mm, on which
/// conicities depend more than pressures do. NaN if too few curves have a conicity.
double conicity_spread(const RadiusDifference& centre, const std::vector<RadiusDifference>& likely,
                       const std::vector<RadiusDifference>& smoothed, double amplitude);

} // namespace driver
