#include "models/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "models/elliptic_integrals.hpp"

namespace wrc {

namespace {

void check_positive(const std::string& argument, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw_invalid_argument(argument, value, "must be finite and greater than 0");
  }
}

/// What does not depend on the load.
struct Shape {
  bool longer_is_longitudinal;
  double smaller_curvature;
  double ratio;
  EllipticIntegrals integrals;
};

Shape shape_of(double longitudinal_curvature, double lateral_curvature, double combined_modulus) {
  check_positive("longitudinal_curvature", longitudinal_curvature);
  check_positive("lateral_curvature", lateral_curvature);
  check_positive("combined_modulus", combined_modulus);
  const auto [smaller, greater] = std::minmax(longitudinal_curvature, lateral_curvature);
  const double ratio = hertz_axis_ratio(greater / smaller);
  return {longitudinal_curvature <= lateral_curvature, smaller, ratio, elliptic_integrals(ratio)};
}

HertzContact contact_of(const Shape& shape, double longer, double load, double modulus) {
  const double shorter = shape.ratio * longer;
  HertzContact contact;
  contact.semi_axis_longitudinal = shape.longer_is_longitudinal ? longer : shorter;
  contact.semi_axis_lateral = shape.longer_is_longitudinal ? shorter : longer;
  contact.normal_force = load;
  if (load > 0.0) {
    contact.peak_pressure = 1.5 * load / (std::numbers::pi * longer * shorter);
    contact.approach = contact.peak_pressure * shorter * shape.integrals.k / modulus;
  }
  return contact;
}

} // namespace

double hertz_axis_ratio(double curvature_ratio) {
  if (!(curvature_ratio >= 1.0) || !std::isfinite(curvature_ratio)) {
    throw_invalid_argument("curvature_ratio", curvature_ratio, "must be finite and at least 1");
  }
  // k^2 = C(k)/(D(k) ratio). The right side's root changes by at most a quarter of a relative
  // change of k, so the plain iteration gains more than a decimal digit every two steps.
  double ratio = std::pow(curvature_ratio, -2.0 / 3.0);
  for (int step = 0; step < 100; ++step) {
    const EllipticIntegrals integrals = elliptic_integrals(ratio);
    const double next = std::min(1.0, std::sqrt(integrals.c / integrals.d / curvature_ratio));
    const double change = std::abs(next - ratio);
    ratio = next;
    if (change <= 0.5 * std::numeric_limits<double>::epsilon() * ratio) {
      break;
    }
  }
  return ratio;
}

HertzContact solve_hertz(double longitudinal_curvature, double lateral_curvature,
                         double combined_modulus, double normal_load) {
  const Shape shape = shape_of(longitudinal_curvature, lateral_curvature, combined_modulus);
  if (!(normal_load >= 0.0) || !std::isfinite(normal_load)) {
    throw_invalid_argument("normal_load", normal_load, "must be finite and at least 0");
  }
  const double longer = std::cbrt(3.0 * normal_load * shape.integrals.d /
                                  (std::numbers::pi * combined_modulus * shape.smaller_curvature));
  return contact_of(shape, longer, normal_load, combined_modulus);
}

HertzContact solve_hertz_for_approach(double longitudinal_curvature, double lateral_curvature,
                                      double combined_modulus, double approach) {
  const Shape shape = shape_of(longitudinal_curvature, lateral_curvature, combined_modulus);
  if (!std::isfinite(approach)) {
    throw_invalid_argument("approach", approach, "must be finite");
  }
  // Load and peak pressure eliminated: approach = c a^2 K/(2 D).
  const double longer = std::sqrt(2.0 * std::max(0.0, approach) * shape.integrals.d /
                                  (shape.smaller_curvature * shape.integrals.k));
  const double load = std::numbers::pi * combined_modulus * shape.smaller_curvature * longer *
                      longer * longer / (3.0 * shape.integrals.d);
  HertzContact contact = contact_of(shape, longer, load, combined_modulus);
  contact.approach = approach;
  return contact;
}

HertzBodies equivalent_hertz_bodies(double semi_axis_longitudinal, double semi_axis_lateral,
                                    double combined_modulus, double normal_load) {
  check_positive("semi_axis_longitudinal", semi_axis_longitudinal);
  check_positive("semi_axis_lateral", semi_axis_lateral);
  check_positive("combined_modulus", combined_modulus);
  check_positive("normal_load", normal_load);
  const auto [shorter, longer] = std::minmax({semi_axis_longitudinal, semi_axis_lateral});
  const double ratio = shorter / longer;
  const EllipticIntegrals integrals = elliptic_integrals(ratio);
  const double factor = 1.5 * normal_load / (std::numbers::pi * combined_modulus) / longer / longer;
  const double along_longer = factor * integrals.d / longer;
  const double along_shorter = factor * integrals.c / (ratio * shorter);
  HertzBodies bodies;
  const bool longer_is_longitudinal = semi_axis_longitudinal >= semi_axis_lateral;
  bodies.longitudinal_coefficient = longer_is_longitudinal ? along_longer : along_shorter;
  bodies.lateral_coefficient = longer_is_longitudinal ? along_shorter : along_longer;
  bodies.longitudinal_radius = 0.5 / bodies.longitudinal_coefficient;
  bodies.lateral_radius = 0.5 / bodies.lateral_coefficient;
  return bodies;
}

double hertz_pressure(const HertzContact& contact, double longitudinal, double lateral) {
  if (contact.normal_force <= 0.0) {
    return 0.0;
  }
  const double x = longitudinal / contact.semi_axis_longitudinal;
  const double y = lateral / contact.semi_axis_lateral;
  return contact.peak_pressure * std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
}

} // namespace wrc
