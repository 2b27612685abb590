/// The complete elliptic integrals of contact mechanics.
///
///   K = int_0^(pi/2) 1 / sqrt(1 - e^2 sin^2) dt,  D = int sin^2 / sqrt(1 - e^2 sin^2) dt,
///   C = K - D,  in terms of k = sqrt(1 - e^2)
/// by the arithmetic-geometric mean (Abramowitz & Stegun, 1964, 17.6): taken from e, as the
/// standard library does, slender ellipses lose digits in 1 - k^2 and round ones in K - E.
/// Thread rule: a pure function.
#pragma once

namespace wrc {

struct EllipticIntegrals {
  double k;
  double c;
  double d; ///< (K - E)/e^2
};

/// For 0 < ratio <= 1: the complementary modulus, of an ellipse b/a.
EllipticIntegrals elliptic_integrals(double ratio);

} // namespace wrc
