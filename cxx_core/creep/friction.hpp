/// The coefficient of friction of a wheel: by position on it, and by the speed at which it slips.
///
/// Between given positions on the wheel's profile it is linear in s, beyond them constant. With the
/// speed w of slip it falls from its value at rest to a fraction A of it (Polach, "Creep forces in
/// simulations of traction vehicles running on adhesion limit", Wear 258, 2005, eq. 15):
///
///   mu(s, w) = mu(s) ((1 - A) exp(-B w) + A)
///
/// One value for a patch: that at its reference, with w = V_ref |(xi, eta)|. Units mm, s.
/// Thread rule: plain values, pure functions.
///
/// Not known here: that the speed of slip varies within a patch; temperature.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "records/friction_law.hpp"

namespace wrc {

/// Linear between the positions, of which there is one at least.
template <class Real> Real friction_at(const std::vector<FrictionAtPlace>& places, const Real& s) {
  const auto after = std::find_if(places.begin(), places.end(),
                                  [&s](const FrictionAtPlace& place) { return s < Real(place.s); });
  if (after == places.begin()) {
    return Real(after->coefficient);
  }
  const FrictionAtPlace& before = *(after - 1);
  if (after == places.end()) {
    return Real(before.coefficient);
  }
  return Real(before.coefficient) +
         (s - Real(before.s)) *
             Real((after->coefficient - before.coefficient) / (after->s - before.s));
}

/// mu(s, w), of numbers or of numbers with rates.
template <class Real> Real friction_of(const FrictionLaw& law, const Real& s, const Real& slip) {
  using std::exp;
  const Real at_rest = law.places.empty() ? Real(law.coefficient) : friction_at(law.places, s);
  const Real share = Real(1.0 - law.limit_ratio) * exp(Real(-law.decay) * slip);
  return law.falls() ? at_rest * (share + Real(law.limit_ratio)) : at_rest;
}

/// Smallest friction at any position and speed of slip.
inline double smallest_friction(const FrictionLaw& law) {
  double smallest = law.coefficient;
  if (!law.places.empty()) {
    smallest = std::ranges::min(law.places, {}, &FrictionAtPlace::coefficient).coefficient;
  }
  return law.falls() ? law.limit_ratio * smallest : smallest;
}

/// Largest friction at rest, at any position.
inline double greatest_friction(const FrictionLaw& law) {
  double greatest = law.places.empty() ? law.coefficient : 0.0;
  for (const FrictionAtPlace& place : law.places) {
    greatest = std::max(greatest, place.coefficient);
  }
  return greatest;
}

} // namespace wrc
