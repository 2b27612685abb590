/// Elastic constants of wheel and rail, and the one modulus the normal problem needs.
///
///   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2     (Johnson, Contact Mechanics, 1985, eq. 4.24)
/// and those of tangential contact (Kalker, Three-Dimensional Elastic Bodies in Rolling Contact,
/// 1990, eq. 1.44):
///   1/G = (1/G1 + 1/G2)/2,  nu/G = (nu1/G1 + nu2/G2)/2,  K/G = ((1-2 nu1)/G1 - (1-2 nu2)/G2)/4
/// Units: moduli in MPa, Poisson's ratio without unit. Does not include plastic flow.
#pragma once

namespace wrc {

struct Material {
  double youngs_modulus; ///< E, MPa, > 0
  double poisson;        ///< nu, 0 to 0.5
  bool operator==(const Material&) const = default;
};

/// E* in MPa. Throws Error(invalid_argument) for constants outside their range.
double combined_modulus(const Material& wheel, const Material& rail);

/// Constants of wheel (1) and rail (2) together in tangential contact.
struct ShearConstants {
  double modulus = 0.0; ///< G, MPa
  double poisson = 0.0; ///< nu
  /// K, Kalker's difference parameter: 0 where pressures and tractions do not affect each other.
  double difference_parameter = 0.0;
};

ShearConstants shear_constants(const Material& wheel, const Material& rail);

/// K where it has an effect, else 0. With friction mu it changes forces by about K/mu of mu N, and
/// pressures by mu K of themselves: where both are far below the accuracy bodies are alike.
double effective_difference(double difference, double friction, double accuracy);

} // namespace wrc
