/// Indices of rolling contact fatigue of one patch.
///
/// Working point on the shakedown map: utilised friction f = T/N against p0/k. For line contact
/// limits are those of this half-space: yield begins where the second invariant reaches k^2, and
/// shakedown ends where the greatest |tau_xz| reaches k, since residual stresses of rolling leave
/// tau_xz alone (Melan; Johnson, Contact Mechanics, 1985, 9.1 to 9.2): p0 = 4.00 k without
/// friction, 1/f on the surface above f = 0.367. Stresses below p = p0 sqrt(1 - x^2/a^2), q = f p
/// in closed form (McEwen 1949; Johnson 1985, eqs. 4.49; tau_xz is that of q by sigma_x).
/// Ponter, Hearle & Johnson, J. Mech. Phys. Solids 33, 1985: point contact shakes down up to 4.7 k
/// without friction, so the line's limit is on the safe side; the surface's limit is the same.
/// Surface fatigue index: f - k/p0 (Ekberg, Kabo & Andersson, Fatigue Fract. Eng. Mater. Struct.
/// 25, 2002), > 0: the surface ratchets. Whole life rail model: damage per wheel by T-gamma
/// (Burstow, RSSB T355, 2004; R220 rail), 1: a crack has begun; < 0: wear removes it.
///
/// Units N, MPa. Thread rule: pure functions. Not known here: hardening, temperature, water.
#pragma once

namespace wrc {

struct ShakedownLimits {
  double elastic = 0.0;   ///< p0/k at which yield begins (von Mises), plane strain with nu = 0.3
  double shakedown = 0.0; ///< p0/k up to which rolling shakes down
};

/// Limits of line contact at a utilised friction of 0 to 2. Throws Error(invalid_argument) beyond.
ShakedownLimits shakedown_limits(double friction);

double surface_fatigue_index(double friction, double peak_pressure, double shear_yield);

/// Per wheel that passes, from T-gamma in N, >= 0.
double rail_damage(double tgamma);

} // namespace wrc
