#include "wheel/yielded_wheel.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "wheel/constants.hpp"

namespace wrc {

bool yields(const GridSolution& elastic, std::span<const YieldingBody> bodies) {
  const double onset = onset_of_yield(bodies);
  return std::ranges::any_of(elastic.patches, [onset](const Patch& patch) {
    return patch.contact.largest_element_pressure > onset;
  });
}

GridSolution softened(GridSolution elastic, std::span<const YieldingBody> bodies) {
  const double stress = softest_of(bodies);
  for (Patch& patch : elastic.patches) {
    for (double& pressure : patch.pressure) {
      pressure = yielded_estimate(pressure, stress);
    }
  }
  return elastic;
}

void set_elastic_peaks(GridSolution& solution, const GridSolution& elastic,
                       std::span<const YieldingBody> bodies) {
  const double stress = softest_of(bodies);
  std::vector<double> missing(solution.patches.size(), 0.0);
  for (Patch& patch : solution.patches) {
    patch.elastic_peak = 0.0;
  }
  for (const Patch& patch : elastic.patches) {
    if (patch.no_contact()) {
      continue;
    }
    const auto nearest = std::ranges::min_element(solution.patches, {}, [&](const Patch& one) {
      return std::hypot(one.penetration.mean_x - patch.penetration.mean_x,
                        one.penetration.mean_y - patch.penetration.mean_y);
    });
    const double peak = patch.contact.peak_pressure;
    if (peak > *nearest->elastic_peak) {
      nearest->elastic_peak = peak;
      missing[static_cast<std::size_t>(nearest - solution.patches.begin())] =
          yielded_estimate(peak, stress) -
          yielded_estimate(peak_pressure(patch.grid, patch.pressure), stress);
    }
  }
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    if (!patch.no_contact()) {
      patch.contact.peak_pressure += std::max(0.0, missing[k]);
      patch.peak_error = std::max(0.0, missing[k]);
    }
  }
}

void state_error_of_yield(WheelSolution& result) {
  double elastic = 0.0;
  for (const Patch& patch : result.patches) {
    elastic = std::max(elastic, patch.elastic_peak.value_or(0.0));
  }
  if (!(elastic > 0.0)) {
    return;
  }
  const WheelRequest& request = result.request;
  const double beyond = elastic / softest_of(request.yielding);
  const double of_pmax = beyond > yield_well_known ? yield_error_far_beyond : yield_error_of_pmax;
  result.model_error = std::hypot(result.model_error.value_or(0.0),
                                  request.accuracy_of == AccuracyOf::pressures ? of_pmax
                                  : request.position_is_prescribed()           ? of_pmax
                                                                     : yield_error_of_forces);
  result.warnings.push_back(
      {WarningClass::first_pressing,
       "steel yields: pmax is " + text_of(std::round(result.peak_pressure)) +
           " MPa instead of an elastic " + text_of(std::round(elastic)) +
           " MPa, as at a first pressing without tractions; the law knows pmax to " +
           text_of(100.0 * of_pmax) + " %, the area to " + text_of(100.0 * yield_error_of_area) +
           " %" + (beyond > yield_compared ? "; it was not compared at such pressures" : "")});
}

} // namespace wrc
