/// Kalker's coefficients: what an ellipse transmits in steady rolling without slip.
///
///   Fx = -G c^2 C11 xi,  Fy = -G c^2 (C22 eta + c C23 phi),  Mz = G c^3 (C23 eta - c C33 phi)
/// with c = sqrt(a b), a the semi-axis along the rolling direction, G and nu of both bodies
/// together; frame and signs of rolling_contact.hpp (Kalker 1967, On the Rolling Contact of Two
/// Elastic Bodies in the Presence of Dry Friction, Delft; 1990, app. E).
/// Computed with this library's own full solver, not taken from a table: steady rolling without
/// slip on grids of 32 x 32 to 512 x 128 elements, extrapolated to elements of no size, and
/// expanded in Chebyshev's polynomials of ln(a/b) and nu. fit_kalker_coefficients computes them.
/// Standard errors: 3e-4 for a/b from 0.02 to 2 (C33: 1e-3), 1e-3 to 10 (C33: 3e-3 in itself), 2e-3
/// to 50 (C33, a small difference there: 0.03 in itself). Beyond, they tend to Kalker's asymptotes
/// without a jump or a kink (C33 for a/b above 50, where no asymptote is known that stays positive,
/// is continued with its slope). C11 = C22 exactly for nu = 0. Thread rule: a pure function.
#pragma once

namespace wrc {

struct KalkerCoefficients {
  double c11 = 0.0;
  double c22 = 0.0;
  double c23 = 0.0;
  double c33 = 0.0;
};

/// `a_over_b` > 0, `poisson` from 0 to 0.5: throws Error(invalid_argument) otherwise.
KalkerCoefficients kalker_coefficients(double a_over_b, double poisson);

} // namespace wrc
