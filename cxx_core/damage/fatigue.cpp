#include "damage/fatigue.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "damage/constants.hpp"

namespace wrc {
namespace {

/// Stresses over p0 at x/a and z/a > 0 below p = p0 sqrt(1 - x^2/a^2).
struct PlaneStress {
  double xx, zz, xz;
};

/// With (x + i z)-plane variables m and n: m^2 = ((1 - x^2 + z^2)^2 + 4 x^2 z^2)^(1/2)/2 + (1 - x^2
/// + z^2)/2 and n^2 with the second sign changed (Johnson 1985, eqs. 4.49 and 4.50).
PlaneStress line_contact(double x, double z, double friction) {
  const double sum = 1.0 - x * x + z * z;
  const double root = std::sqrt(sum * sum + 4.0 * x * x * z * z);
  const double m = std::sqrt(0.5 * (root + sum));
  const double n = std::copysign(std::sqrt(std::max(0.5 * (root - sum), 0.0)), x);
  const double square = m * m + n * n;
  const double spread = (z * z + n * n) / square;
  const double p_xx = -(m * (1.0 + spread) - 2.0 * z);
  const double p_zz = -m * (1.0 - spread);
  const double p_xz = -n * (m * m - z * z) / square;
  // Under q = f p: zz as p's xz, xz as p's xx, with the sign of q in x.
  const double q_xx = n * (2.0 - (z * z - m * m) / square) - 2.0 * x;
  return {p_xx + friction * q_xx, p_zz + friction * p_xz, p_xz + friction * p_xx};
}

} // namespace

ShakedownLimits shakedown_limits(double friction) {
  if (!(friction >= 0.0 && friction <= map_friction)) {
    throw_invalid_argument("friction", friction, "must be between 0 and 2");
  }
  double invariant = 0.0;
  double shear = friction; // on the surface
  const int columns = static_cast<int>(2.0 * map_reach / map_step);
  const int rows = static_cast<int>(map_reach / map_step);
  for (int i = 0; i <= rows; ++i) {
    const double depth = std::max(i * map_step, least_depth);
    for (int j = 0; j <= columns; ++j) {
      const double x = j * map_step - map_reach;
      const PlaneStress s = line_contact(x, depth, friction);
      const double yy = map_poisson * (s.xx + s.zz);
      const double a = s.xx - yy;
      const double b = yy - s.zz;
      const double c = s.zz - s.xx;
      invariant = std::max(invariant, (a * a + b * b + c * c) / 6.0 + s.xz * s.xz);
      shear = std::max(shear, std::abs(s.xz));
    }
  }
  return {1.0 / std::sqrt(invariant), 1.0 / shear};
}

double surface_fatigue_index(double friction, double peak_pressure, double shear_yield) {
  return peak_pressure > 0.0 ? friction - shear_yield / peak_pressure : 0.0;
}

double rail_damage(double tgamma) {
  if (tgamma <= rail_damage_first) {
    return 0.0;
  }
  return rail_damage_greatest *
         std::min((tgamma - rail_damage_first) / (rail_damage_peak - rail_damage_first),
                  (rail_damage_last - tgamma) / (rail_damage_last - rail_damage_peak));
}

} // namespace wrc
