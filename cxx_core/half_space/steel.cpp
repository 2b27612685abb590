#include "half_space/steel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "base/lower_case.hpp"
#include "half_space/constants.hpp"

namespace wrc {
namespace {

const SteelGrade* find_grade(std::string_view name) {
  const std::string wanted = lower_case(name);
  const auto* const found = std::ranges::find_if(
      steel_grades, [&](const SteelGrade& grade) { return lower_case(grade.name) == wanted; });
  return found != steel_grades.end() ? found : nullptr;
}

double compliance_of(const Material& material) {
  return (1.0 - material.poisson * material.poisson) / material.youngs_modulus;
}

} // namespace

std::optional<Steel> steel_of_grade(std::string_view grade) {
  const SteelGrade* const found = find_grade(grade);
  return found != nullptr ? std::optional(Steel{found->yield_stress, found->name}) : std::nullopt;
}

std::string text_of(const Steel& steel) {
  if (!steel.yield_stress) {
    return "elastic";
  }
  const std::string stress = text_of(*steel.yield_stress) + " MPa";
  const SteelGrade* const grade = find_grade(steel.grade);
  return grade != nullptr
             ? std::string(grade->name) + ", " + stress + " (" + std::string(grade->source) + ')'
             : stress;
}

std::string text_of(const Steel& of_wheel, const Steel& of_rail) {
  return of_wheel.yield_stress || of_rail.yield_stress
             ? "wheel " + text_of(of_wheel) + "; rail " + text_of(of_rail)
             : text_of(of_rail);
}

double shear_yield_of(const Steel& steel) {
  return steel.yield_stress ? *steel.yield_stress / std::numbers::sqrt3 : usual_shear_yield;
}

std::vector<YieldingBody> yielding_bodies(const Material& wheel, const Steel& of_wheel,
                                          const Material& rail, const Steel& of_rail) {
  const double share = compliance_of(wheel) / (compliance_of(wheel) + compliance_of(rail));
  std::vector<YieldingBody> bodies;
  if (of_wheel.yield_stress == of_rail.yield_stress && of_wheel.yield_stress) {
    bodies.push_back({*of_wheel.yield_stress, 1.0, share});
    return bodies;
  }
  if (of_wheel.yield_stress) {
    bodies.push_back({*of_wheel.yield_stress, share, 1.0});
  }
  if (of_rail.yield_stress) {
    bodies.push_back({*of_rail.yield_stress, 1.0 - share, 0.0});
  }
  return bodies;
}

double softest_of(std::span<const YieldingBody> bodies) {
  double least = std::numeric_limits<double>::infinity();
  for (const YieldingBody& body : bodies) {
    least = std::min(least, body.stress);
  }
  return least;
}

double onset_of_yield(std::span<const YieldingBody> bodies) {
  return yield_onset * softest_of(bodies);
}

Excess excess_of(double pressure, double yield_stress) {
  const double beyond = pressure / yield_stress - yield_onset;
  if (!(beyond > 0.0)) {
    return {};
  }
  const double slope = yield_exponent * std::pow(beyond, yield_exponent - 1.0);
  return {yield_stress * slope * beyond / yield_exponent, slope,
          (yield_exponent - 1.0) * slope / (beyond * yield_stress)};
}

Excess excess_of(double pressure, double yield_stress, double carried) {
  Excess excess = excess_of(pressure, yield_stress);
  const double before = excess_of(carried, yield_stress).value;
  if (!(before > 0.0)) {
    return excess;
  }
  excess.value -= before;
  if (!(excess.value > 0.0)) {
    return {};
  }
  const double range = yield_again_range * before;
  if (excess.value >= range) {
    excess.value -= 0.5 * range;
    return excess;
  }
  const double part = excess.value / range;
  return {0.5 * part * excess.value, part * excess.slope,
          part * excess.curvature + excess.slope * excess.slope / range};
}

double yielded_estimate(double pressure, double yield_stress) {
  const double beyond = pressure / yield_stress - yield_onset;
  return beyond > 0.0
             ? yield_stress * (yield_onset +
                               yield_estimate_range * -std::expm1(-beyond / yield_estimate_range))
             : pressure;
}

} // namespace wrc
