/// Stresses below a rectangular element under constant pressure and tractions, in closed form.
///
/// With V the integral over the element of 1/rho, T that of ln(rho + z), T1 that of
/// z ln(rho + z) - rho, which are harmonic and derivatives of each other by z (T = dT1/dz,
/// V = dT/dz), the potentials of Boussinesq and Cerruti (Johnson, Contact Mechanics, 1985, eqs. 3.1
/// to 3.8) give, times 1/(2 pi) and with subscripts for derivatives,
///   under p:   xx = -(1-2nu) T_xx - z V_xx + 2nu V_z,   zz = V_z - z V_zz,   xz = -z V_xz,
///              xy = -(1-2nu) T_xy - z V_xy
///   under q_x: xx = 2(1+nu) V_x + 2nu T1_xxx - z T_xxx,  yy = 2nu (V_x + T1_xyy) - z T_xyy,
///              zz = -z V_xz,  xy = V_y + 2nu T1_xxy - z T_xxy,  xz = V_z - z V_xx,  yz = -z V_xy
/// and the rest by exchange of x and y. Each derivative is a sum over the element's four corners of
/// logarithms, arc tangents and roots (Love, Phil. Trans. R. Soc. A 228, 1929; Ahmadi, Keer & Mura,
/// Int. J. Solids Structures 19, 1983; Kalker, Three-Dimensional Elastic Bodies in Rolling Contact,
/// 1990, app. C).
///
/// Frame: z into the body, x and y along its surface; p >= 0 presses, q act on the body. Tension is
/// positive. Units mm, MPa. Thread rule: pure functions.
///
/// Not known here: layers, edges, plastic flow; the body is a half-space.
#pragma once

#include <array>
#include <cstddef>

namespace wrc {

/// A symmetric tensor in MPa; components in the order of stress_names.
using Stress = std::array<double, 6>;
enum StressComponent : std::size_t { xx, yy, zz, xy, xz, yz };

/// Root of half the sum of squares of the differences of principal stresses (von Mises).
double von_mises(const Stress& stress);
/// Principal stresses, greatest first.
std::array<double, 3> principal_stresses(const Stress& stress);
/// Half the difference of the outer two.
double greatest_shear(const Stress& stress);

/// Different functions of the offset that the stresses under p, q_x and q_y are made of; some serve
/// twice.
inline constexpr std::size_t stress_kernels = 15; // not a tuning constant
/// Which one serves a component under a load (p, q_x, q_y).
extern const std::array<std::array<std::size_t, 6>, 3> kernel_of;

/// Their corner sums at x_first + i step, i < count, for one distance y of corner and point and one
/// depth z > 0, in any unit of length: kernel k at values[k * pitch + i]; without tractions the
/// first six only.
void stress_corners(double x_first, double step, std::size_t count, double y, double z,
                    double poisson, bool tractions, double* values, std::size_t pitch);
void stress_corners(float x_first, float step, std::size_t count, float y, float z, float poisson,
                    bool tractions, float* values, std::size_t pitch);

} // namespace wrc
