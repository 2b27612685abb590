#include "wheel/yielded_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/smoothstep.hpp"
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

void take_back_sections(GridSolution& elastic) {
  for (Patch& patch : elastic.patches) {
    if (!patch.no_contact()) {
      patch.elastic_peak = patch.contact.peak_pressure;
      const double of_elements = peak_pressure(patch.grid, patch.pressure);
      patch.peak_error = std::max(patch.peak_error, patch.contact.peak_pressure - of_elements);
      patch.contact.peak_pressure = of_elements;
    }
  }
}

void refine_for_yield(const GridSolution& elastic, const AccuracyGoal& goal,
                      std::vector<PatchElements>& elements) {
  std::vector<PatchElements> others;
  if (goal.forces_only) {
    for (const Patch& patch : elastic.patches) {
      others.push_back({patch.penetration.mean_x, patch.penetration.mean_y, patch.grid.lateral_step,
                        patch.grid.longitudinal_step, 0.5});
    }
  } else {
    others = finer_elements(elastic, estimate_error(elastic, goal), goal);
  }
  for (PatchElements& one : elements) {
    const PatchElements& nearest =
        *std::ranges::min_element(others, {}, [&](const PatchElements& other) {
          return std::hypot(other.mean_x - one.mean_x, other.mean_y - one.mean_y);
        });
    one.lateral_step = std::min(one.lateral_step, nearest.lateral_step);
    one.longitudinal_step = std::min(one.longitudinal_step, nearest.longitudinal_step);
    if (!goal.forces_only) { // which must not step at the onset
      one.longitudinal_step =
          std::min(one.longitudinal_step, longest_yielding_element * one.lateral_step);
    }
  }
}

void set_elastic_peaks(GridSolution& solution, const GridSolution& elastic,
                       const AccuracyGoal& goal, std::span<const YieldingBody> bodies) {
  for (Patch& patch : solution.patches) {
    patch.elastic_peak = 0.0;
  }
  for (const Patch& patch : elastic.patches) {
    if (patch.no_contact()) {
      continue;
    }
    Patch& nearest = *std::ranges::min_element(solution.patches, {}, [&](const Patch& one) {
      return std::hypot(one.penetration.mean_x - patch.penetration.mean_x,
                        one.penetration.mean_y - patch.penetration.mean_y);
    });
    if (*patch.elastic_peak > *nearest.elastic_peak) {
      nearest.elastic_peak = patch.elastic_peak;
      nearest.peak_error =
          patch.peak_error * std::min(1.0, nearest.grid.lateral_step / patch.grid.lateral_step);
    }
  }
  for (Patch& patch : solution.patches) {
    const double beyond = *patch.elastic_peak / onset_of_yield(bodies) - 1.0;
    patch.bend = std::max(patch.bend, smoothstep(beyond / (yield_rim_whole - 1.0)));
    double& peak = patch.contact.peak_pressure;
    if (*patch.elastic_peak > 0.0) {
      peak = std::min(peak, *patch.elastic_peak);
    }
    if (!goal.forces_only && peak > 0.0) {
      const double by_crest = peak - patch.contact.largest_element_pressure;
      patch.peak_error =
          std::max(patch.peak_error, yield_error_of_crest * by_crest * by_crest / peak);
    }
  }
}

void state_error_of_yield(WheelSolution& result) {
  double elastic = 0.0;
  for (const Patch& patch : result.patches) {
    elastic = std::max(elastic, patch.elastic_peak.value_or(0.0));
  }
  if (!(elastic > 0.0) || result.stop_reason != StopReason::tolerance_met) {
    return;
  }
  const WheelRequest& request = result.request;
  const double beyond = elastic / softest_of(request.yielding);
  const bool again = request.passes > 1;
  const double of_pmax =
      std::hypot(beyond > yield_well_known ? yield_error_far_beyond : yield_error_of_pmax,
                 again ? yield_error_of_passes : 0.0);
  result.model_error =
      std::hypot(result.model_error.value_or(0.0), request.accuracy_of == AccuracyOf::pressures ||
                                                           again || request.position_is_prescribed()
                                                       ? of_pmax
                                                       : yield_error_of_forces);
  const bool compared = beyond <= yield_compared;
  result.warnings.push_back(
      {WarningClass::first_pressing,
       "steel yields: pmax is " + text_of(std::round(result.peak_pressure)) +
           " MPa instead of an elastic " + text_of(std::round(elastic)) + " MPa, as at " +
           (again ? "pass " + text_of(request.passes) + " over the same place"
                  : "a first pressing") +
           " without tractions; " +
           (again
                ? "repeated passes were not compared with finite elements and have no derivatives; "
                : "") +
           "the law knows pmax to " + text_of(std::round(100.0 * of_pmax)) + " %, the area to " +
           text_of(100.0 * yield_error_of_area) + " %" +
           (compared ? "" : "; it was not compared at such pressures"),
       compared ? of_pmax / yield_error_of_pmax : std::numeric_limits<double>::infinity()});
}

} // namespace wrc
