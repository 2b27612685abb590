#include "half_space/material.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace wrc {

namespace {

/// (1 - nu^2)/E, 1/MPa.
double compliance(const Material& material, const std::string& body) {
  if (!(material.youngs_modulus > 0.0) || !std::isfinite(material.youngs_modulus)) {
    throw_invalid_argument(body + ".youngs_modulus", material.youngs_modulus,
                           "must be finite and greater than 0");
  }
  if (!(material.poisson >= 0.0 && material.poisson <= 0.5)) {
    throw_invalid_argument(body + ".poisson", material.poisson, "must lie in 0 to 0.5");
  }
  return (1.0 - material.poisson * material.poisson) / material.youngs_modulus;
}

} // namespace

double combined_modulus(const Material& wheel, const Material& rail) {
  return 1.0 / (compliance(wheel, "wheel") + compliance(rail, "rail"));
}

} // namespace wrc
