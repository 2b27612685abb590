#include "damage/element_stress.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>

#include "half_space/vector_log.hpp"

namespace wrc {
namespace {

/// Arc tangent without branches (Moshier, Cephes library, 1989: atan.c and atanf.c).
template <class Real> WRC_VECTOR_BODY Real vector_atan(Real value) {
  const Real t = std::abs(value);
  const bool steep = t > Real(2.414213562373095);
  const bool middle = !steep && t > Real(std::is_same_v<Real, float> ? 0.4142135623730950 : 0.66);
  const Real numerator = steep ? Real(-1) : (middle ? t - Real(1) : t);
  const Real denominator = steep ? t : (middle ? t + Real(1) : Real(1));
  const Real x = numerator / denominator;
  const Real s = x * x;
  Real rest; // of (atan x)/x - 1
  if constexpr (std::is_same_v<Real, float>) {
    rest = (((8.05374449538e-2F * s - 1.38776856032e-1F) * s + 1.99777106478e-1F) * s -
            3.33329491539e-1F) *
           s;
  } else {
    const Real p = (((-8.750608600031904122785e-1 * s - 1.615753718733365076637e1) * s -
                     7.500855792314704667340e1) *
                        s -
                    1.228866684490136173410e2) *
                       s -
                   6.485021904942025371773e1;
    const Real q = ((((s + 2.485846490142306297962e1) * s + 1.650270098316988542046e2) * s +
                     4.328810604912902668951e2) *
                        s +
                    4.853903996359136964868e2) *
                       s +
                   1.945506571482613964425e2;
    rest = s * p / q;
  }
  const Real start =
      std::numbers::pi_v<Real> * (steep ? Real(0.5) : (middle ? Real(0.25) : Real(0)));
  return std::copysign(start + (x + x * rest), value);
}

WRC_VECTOR_BODY double natural_log(double x) {
  return vector_log(x);
}

/// As vector_log, in single precision: the series stops at s^9, which leaves 1e-9.
WRC_VECTOR_BODY float natural_log(float x) {
  constexpr std::uint32_t root_of_half = 0x3f35'04f3;
  const std::uint32_t shifted = std::bit_cast<std::uint32_t>(x) + (0x3f80'0000 - root_of_half);
  const auto k = static_cast<float>(static_cast<std::int32_t>(shifted >> 23U) - 127);
  const float m = std::bit_cast<float>((shifted & 0x007f'ffffU) + root_of_half);
  const float s = (m - 1.0F) / (m + 1.0F);
  const float z = s * s;
  const float series = (((2.0F / 9.0F * z + 2.0F / 7.0F) * z + 2.0F / 5.0F) * z + 2.0F / 3.0F) * z;
  return k * std::numbers::ln2_v<float> + s * (2.0F + series);
}

/// ln((r + |a|)/rest), rest^2 = r^2 - a^2, with the sign of a.
template <class Real> WRC_VECTOR_BODY Real signed_log(Real r, Real a, Real rest_squared) {
  const Real sum = r + std::abs(a);
  return std::copysign(Real(0.5) * natural_log(sum * sum / rest_squared), a);
}

template <bool tractions, class Real>
WRC_VECTOR_BODY void corners_of(Real x_first, Real step, std::size_t count, Real y, Real z, Real nu,
                                Real* at, std::size_t pitch) {
  constexpr Real scale = Real(0.5) * std::numbers::inv_pi_v<Real>;
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const Real x = x_first + static_cast<Real>(static_cast<std::int32_t>(i)) * step;
    const Real xz2 = x * x + z * z;
    const Real yz2 = y * y + z * z;
    const Real r = std::sqrt(x * x + yz2);
    const Real over_r = Real(1) / r;
    const Real below = Real(1) / (r + z);
    // Derivatives of V; parts that depend on x or y alone cancel in the sum over the corners.
    const Real v_x = signed_log(r, y, xz2);
    const Real v_y = signed_log(r, x, yz2);
    const Real v_z = -vector_atan(x * y * over_r / z);
    const Real v_xx = -x * y * over_r / xz2;
    const Real v_yy = -x * y * over_r / yz2;
    const Real v_xz = -z * y * over_r / xz2;
    const Real v_yz = -z * x * over_r / yz2;
    // Second derivatives of T and T1; T_xx + T_yy = -V_z.
    const Real t_xx =
        vector_atan(x * y * (r - z) / (x * x * r + y * y * z + std::numeric_limits<Real>::min()));
    const Real t_yy = -v_z - t_xx;
    const Real t_xy = natural_log(r + z);
    const Real t_xxy = x * over_r * below;
    const Real t_xyy = y * over_r * below;
    const Real t_xxx = -t_xyy - v_xz;
    const Real t_yyy = -t_xxy - v_yz;
    const Real t1_xxy = -x * below;
    const Real t1_xyy = -y * below;
    const Real t1_xxx = -t1_xyy - v_x;
    const Real t1_yyy = -t1_xxy - v_y;
    const Real two_nu = Real(2) * nu;
    const Real rest = Real(1) - two_nu;
    at[i] = scale * (-rest * t_xx - z * v_xx + two_nu * v_z);
    at[pitch + i] = scale * (-rest * t_yy - z * v_yy + two_nu * v_z);
    at[2 * pitch + i] = scale * (v_z + z * (v_xx + v_yy));
    at[3 * pitch + i] = scale * (-rest * t_xy - z * over_r);
    at[4 * pitch + i] = -scale * z * v_xz;
    at[5 * pitch + i] = -scale * z * v_yz;
    if constexpr (!tractions) {
      continue;
    }
    at[6 * pitch + i] = scale * ((Real(2) + two_nu) * v_x + two_nu * t1_xxx - z * t_xxx);
    at[7 * pitch + i] = scale * (two_nu * (v_x + t1_xyy) - z * t_xyy);
    at[8 * pitch + i] = scale * (v_y + two_nu * t1_xxy - z * t_xxy);
    at[9 * pitch + i] = scale * (v_z - z * v_xx);
    at[10 * pitch + i] = -scale * z * over_r;
    at[11 * pitch + i] = scale * (two_nu * (v_y + t1_xxy) - z * t_xxy);
    at[12 * pitch + i] = scale * ((Real(2) + two_nu) * v_y + two_nu * t1_yyy - z * t_yyy);
    at[13 * pitch + i] = scale * (v_x + two_nu * t1_xyy - z * t_xyy);
    at[14 * pitch + i] = scale * (v_z - z * v_yy);
  }
}

template <class Real>
WRC_VECTOR_BODY void corners_body(Real x_first, Real step, std::size_t count, Real y, Real z,
                                  Real nu, bool tractions, Real* at, std::size_t pitch) {
  if (tractions) {
    corners_of<true>(x_first, step, count, y, z, nu, at, pitch);
  } else {
    corners_of<false>(x_first, step, count, y, z, nu, at, pitch);
  }
}

} // namespace

const std::array<std::array<std::size_t, 6>, 3> kernel_of{
    {{0, 1, 2, 3, 4, 5}, {6, 7, 4, 8, 9, 10}, {11, 12, 5, 13, 10, 14}}};

WRC_VECTOR_CLONES void stress_corners(double x_first, double step, std::size_t count, double y,
                                      double z, double poisson, bool tractions, double* values,
                                      std::size_t pitch) {
  corners_body(x_first, step, count, y, z, poisson, tractions, values, pitch);
}
WRC_VECTOR_CLONES void stress_corners(float x_first, float step, std::size_t count, float y,
                                      float z, float poisson, bool tractions, float* values,
                                      std::size_t pitch) {
  corners_body(x_first, step, count, y, z, poisson, tractions, values, pitch);
}

double von_mises(const Stress& s) {
  const auto squared = [](double value) { return value * value; };
  return std::sqrt(0.5 *
                       (squared(s[xx] - s[yy]) + squared(s[yy] - s[zz]) + squared(s[zz] - s[xx])) +
                   3.0 * (squared(s[xy]) + squared(s[xz]) + squared(s[yz])));
}

std::array<double, 3> principal_stresses(const Stress& s) {
  const double mean = (s[xx] + s[yy] + s[zz]) / 3.0;
  const double size = 2.0 / 3.0 * von_mises(s);
  if (!(size > 0.0)) {
    return {mean, mean, mean};
  }
  const double a = s[xx] - mean;
  const double b = s[yy] - mean;
  const double c = s[zz] - mean;
  const double third_invariant = a * (b * c - s[yz] * s[yz]) - s[xy] * (s[xy] * c - s[yz] * s[xz]) +
                                 s[xz] * (s[xy] * s[yz] - b * s[xz]);
  const double cosine = std::clamp(4.0 * third_invariant / (size * size * size), -1.0, 1.0);
  const double lode = std::acos(cosine) / 3.0;
  const double turn = 2.0 / 3.0 * std::numbers::pi;
  return {mean + size * std::cos(lode), mean + size * std::cos(lode - turn),
          mean + size * std::cos(lode + turn)};
}

double greatest_shear(const Stress& stress) {
  const auto principal = principal_stresses(stress);
  return 0.5 * (principal[0] - principal[2]);
}

} // namespace wrc
