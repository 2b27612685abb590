/// Elliptical contact of two smooth bodies in closed form.
///
///   gap h = (c_x x^2 + c_y y^2)/2,  p = p0 sqrt(1 - (x/a_x)^2 - (y/a_y)^2)
/// with, for the semi-axes a >= b = k a, the smaller curvature c along a, and the complete elliptic
/// integrals K and D = (K - E)/e^2 of the modulus e = sqrt(1 - k^2),
///   a^3 = 3 Q D/(pi E* c),  p0 = 3 Q/(2 pi a b),  approach = p0 b K/E*
/// (Hertz, 1882; Johnson, Contact Mechanics, 1985, eqs. 4.26 to 4.32, with c = 2 A for Johnson's
/// A). Units mm, N, MPa; curvatures are relative (both bodies together) in 1/mm, positive where the
/// bodies curve away from each other; x longitudinal, y lateral, from the centre of the patch.
/// Does not handle curvature that changes within the patch, of slopes or of edges.
#pragma once

namespace wrc {

struct HertzContact {
  double semi_axis_longitudinal = 0.0; ///< mm
  double semi_axis_lateral = 0.0;      ///< mm
  double peak_pressure = 0.0;          ///< MPa
  double approach = 0.0;               ///< mm
  double normal_force = 0.0;           ///< N
};

/// For a prescribed load >= 0. Curvatures and modulus > 0; throws Error(invalid_argument).
HertzContact solve_hertz(double longitudinal_curvature, double lateral_curvature,
                         double combined_modulus, double normal_load);

/// For a prescribed approach; one at or below 0 gives no force.
HertzContact solve_hertz_for_approach(double longitudinal_curvature, double lateral_curvature,
                                      double combined_modulus, double approach);

/// The smooth bodies that touch in a given ellipse under a given load: gap = A x^2 + B y^2.
struct HertzBodies {
  double longitudinal_coefficient = 0.0; ///< A, 1/mm; half the relative longitudinal curvature
  double lateral_coefficient = 0.0;      ///< B, 1/mm; half the relative lateral curvature
  double longitudinal_radius = 0.0;      ///< R_x = 1/(2 A), mm
  double lateral_radius = 0.0;           ///< R_y = 1/(2 B), mm
};

/// The inverse of solve_hertz, in closed form. With C = K - D, for the semi-axes a >= b = k a,
///   c along a = 3 Q D/(pi E* a^3),  c along b = 3 Q C/(pi E* a b^2)
/// (Johnson, 1985, eqs. 4.25 to 4.28; A and B stay with x and y whichever axis is longer). For
/// codes that ask for the curvatures of an equivalent Hertzian contact. All arguments > 0; throws
/// Error(invalid_argument).
HertzBodies equivalent_hertz_bodies(double semi_axis_longitudinal, double semi_axis_lateral,
                                    double combined_modulus, double normal_load);

/// Pressure at a point, MPa; 0 outside the ellipse.
double hertz_pressure(const HertzContact& contact, double longitudinal, double lateral);

/// Ratio k = b/a <= 1 of the semi-axes for the ratio >= 1 of the greater to the smaller curvature.
double hertz_axis_ratio(double curvature_ratio);

} // namespace wrc
