/// The polynomial 3 t^2 - 2 t^3, which rises from 0 to 1 with slopes of 0 at both ends.
///
/// For plain numbers and numbers with rates. Thread rule: pure functions. Beyond 0 to 1 it falls
/// back: callers outside that range use `smoothstep`.
#pragma once

#include <algorithm>

namespace wrc {

/// `t` in 0 to 1.
template <class Real> Real smooth_rise(const Real& t) {
  return t * t * (3.0 - 2.0 * t);
}

/// 0 below 0, 1 above 1.
template <class Real> Real smoothstep(const Real& t) {
  return smooth_rise<Real>(std::clamp(t, Real(0.0), Real(1.0)));
}

} // namespace wrc
