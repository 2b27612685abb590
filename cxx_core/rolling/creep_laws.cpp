#include "rolling/creep_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "rolling/constants.hpp"

namespace wrc {

namespace {

double polach_spin_share(const RollingEllipse& ellipse) {
  return 1.0 + polach_spin_growth *
                   (1.0 - std::exp(-ellipse.longitudinal_semi_axis / ellipse.lateral_semi_axis));
}

/// Polach's K for a gradient eS of the tangential stress.
double polach_spin_reduction(double gradient) {
  const double rest = 2.0 / (1.0 + gradient * gradient); // 1 - d
  const double root = gradient * rest;                   // sqrt(1 - d^2)
  // d^3/3 - d^2/2 + 1/6 in powers of 1 - d: nothing cancels where all slips.
  return root * root * root / 3.0 - gradient * rest * rest * (0.5 - rest / 3.0);
}

} // namespace

void check_ellipse(const RollingEllipse& ellipse) {
  for (const auto& [name, value] :
       {std::pair{"longitudinal_semi_axis", ellipse.longitudinal_semi_axis},
        std::pair{"lateral_semi_axis", ellipse.lateral_semi_axis},
        std::pair{"shear_modulus", ellipse.shear_modulus}}) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw_invalid_argument(name, value, "must be finite and greater than 0");
    }
  }
  for (const auto& [name, value] :
       {std::pair{"load", ellipse.load}, std::pair{"friction", ellipse.friction}}) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
      throw_invalid_argument(name, value, "must be finite and not negative");
    }
  }
  if (!(ellipse.poisson >= 0.0 && ellipse.poisson <= 0.5)) {
    throw_invalid_argument("poisson", ellipse.poisson, "must be between 0 and 0.5");
  }
}

KalkerCoefficients kalker_coefficients(const RollingEllipse& ellipse) {
  check_ellipse(ellipse);
  return kalker_coefficients(ellipse.longitudinal_semi_axis / ellipse.lateral_semi_axis,
                             ellipse.poisson);
}

CreepForces linear_forces(const RollingEllipse& ellipse, const KalkerCoefficients& coefficients,
                          const Creepages& creepages) {
  const double square = ellipse.longitudinal_semi_axis * ellipse.lateral_semi_axis;
  const double c = std::sqrt(square);
  const double stiffness = ellipse.shear_modulus * square;
  const double spin = c * creepages.spin;
  return {-stiffness * coefficients.c11 * creepages.longitudinal,
          -stiffness * (coefficients.c22 * creepages.lateral + coefficients.c23 * spin),
          stiffness * c * (coefficients.c23 * creepages.lateral - coefficients.c33 * spin)};
}

CreepForces shen_hedrick_elkins_forces(const RollingEllipse& ellipse,
                                       const KalkerCoefficients& coefficients,
                                       const Creepages& creepages) {
  const double whole = ellipse.friction * ellipse.load;
  if (!(whole > 0.0)) {
    return {};
  }
  const CreepForces linear = linear_forces(ellipse, coefficients, creepages);
  const double t = std::hypot(linear.longitudinal, linear.lateral) / whole;
  // The cubic over t: no division by a vanishing force.
  const double factor = t < full_slip_ratio ? 1.0 - t / 3.0 + t * t / 27.0 : 1.0 / t;
  return {factor * linear.longitudinal, factor * linear.lateral, factor * linear.spin_moment};
}

CreepForces polach_forces(const RollingEllipse& ellipse, const KalkerCoefficients& coefficients,
                          const Creepages& creepages, const PolachReduction& reduction) {
  const double whole = ellipse.friction * ellipse.load;
  const double a = ellipse.longitudinal_semi_axis;
  const double b = ellipse.lateral_semi_axis;
  const double with_spin = creepages.lateral + a * creepages.spin;
  const double lateral =
      std::abs(with_spin) > std::abs(creepages.lateral) ? with_spin : creepages.lateral;
  const double corrected = std::hypot(creepages.longitudinal, lateral);
  if (!(whole > 0.0 && corrected > 0.0)) {
    return {};
  }
  const double slip = std::hypot(creepages.longitudinal, creepages.lateral);
  CreepForces forces;
  if (slip > 0.0) {
    const double stiffness = std::hypot(coefficients.c11 * creepages.longitudinal,
                                        coefficients.c22 * creepages.lateral) /
                             slip;
    const double gradient =
        ellipse.shear_modulus * std::numbers::pi * a * b * stiffness * corrected / (4.0 * whole);
    const double adhering = reduction.adhesion * gradient;
    const double force =
        2.0 * whole / std::numbers::pi *
        (adhering / (1.0 + adhering * adhering) + std::atan(reduction.slip * gradient));
    forces.longitudinal = -force * creepages.longitudinal / corrected;
    forces.lateral = -force * creepages.lateral / corrected;
  }
  const double share = polach_spin_share(ellipse);
  const double spin_gradient = 8.0 / 3.0 * ellipse.shear_modulus * b * std::sqrt(a * b) *
                               coefficients.c23 * std::abs(lateral) / (whole * share);
  forces.lateral -= 9.0 / 16.0 * a * whole * polach_spin_reduction(spin_gradient) * share *
                    creepages.spin / corrected;
  return forces;
}

} // namespace wrc
