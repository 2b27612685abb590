/// Elastic constants of wheel and rail, and the one modulus the normal problem needs.
///
///   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2     (Johnson, Contact Mechanics, 1985, eq. 4.24)
/// Units: moduli in MPa, Poisson's ratio without unit. Knows nothing of shear or of plastic flow:
/// bodies of different materials are coupled in the tangential direction, which is left out here.
#pragma once

namespace wrc {

struct Material {
  double youngs_modulus; ///< E, MPa, > 0
  double poisson;        ///< nu, 0 to 0.5
  bool operator==(const Material&) const = default;
};

/// E* in MPa. Throws Error(invalid_argument) for constants outside their range.
double combined_modulus(const Material& wheel, const Material& rail);

} // namespace wrc
