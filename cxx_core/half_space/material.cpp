#include "half_space/material.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "half_space/constants.hpp"

namespace wrc {

namespace {

/// (1 - nu^2)/E, 1/MPa.
double compliance(const Material& material, const std::string& body) {
  if (!(material.youngs_modulus > 0.0) || !std::isfinite(material.youngs_modulus)) {
    throw_invalid_argument(body + ".youngs_modulus", material.youngs_modulus,
                           "must be finite and greater than 0");
  }
  if (!(material.poisson >= 0.0 && material.poisson <= 0.5)) {
    throw_invalid_argument(body + ".poisson", material.poisson, "must be between 0 and 0.5");
  }
  return (1.0 - material.poisson * material.poisson) / material.youngs_modulus;
}

} // namespace

double combined_modulus(const Material& wheel, const Material& rail) {
  return 1.0 / (compliance(wheel, "wheel") + compliance(rail, "rail"));
}

ShearConstants shear_constants(const Material& wheel, const Material& rail) {
  (void)combined_modulus(wheel, rail); // checks
  const auto compliance_of = [](const Material& material) {
    return 2.0 * (1.0 + material.poisson) / material.youngs_modulus;
  };
  const double of_wheel = compliance_of(wheel);
  const double of_rail = compliance_of(rail);
  ShearConstants constants;
  constants.modulus = 2.0 / (of_wheel + of_rail);
  constants.poisson = 0.5 * constants.modulus * (wheel.poisson * of_wheel + rail.poisson * of_rail);
  constants.difference_parameter =
      0.25 * constants.modulus *
      ((1.0 - 2.0 * wheel.poisson) * of_wheel - (1.0 - 2.0 * rail.poisson) * of_rail);
  return constants;
}

double effective_difference(double difference, double friction, double accuracy) {
  const double negligible =
      negligible_material_effect * accuracy * std::min(friction, 1.0 / friction);
  return std::abs(difference) > std::max(negligible, rounding_of_material_difference) ? difference
                                                                                      : 0.0;
}

} // namespace wrc
