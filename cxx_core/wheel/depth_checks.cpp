#include "wheel/depth_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/peak_section.hpp"
#include "base/error.hpp"
#include "patches/depth_estimate.hpp"
#include "wheel/constants.hpp"

namespace wrc {
namespace {

/// By how much the rounding of positions may change a patch's largest pressure, MPa.
double pressure_rounding(const Patch& patch, const WheelRequest& request, double wheel_radius) {
  const double rounding = coordinate_deviation * std::numeric_limits<double>::epsilon();
  const double angle = patch.frame.angle();
  const double radial = rounding * wheel_radius * std::cos(angle);
  const double lateral = rounding * patch.frame.origin.y * std::sin(angle);
  const double strips = request.accuracy_of == AccuracyOf::pressures ? strips_in_row(patch) : 1.0;
  const double gradient =
      std::hypot(radial / patch.grid.longitudinal_step,
                 std::hypot(radial, lateral) / (patch.grid.lateral_step / strips));
  return pressure_deviations * noise_response * request.combined_modulus * gradient;
}

} // namespace

bool is_in_contact(const WheelRequest& request, double depth, Warnings& warnings) {
  if (!(depth >= min_depth)) {
    if (request.position_is_prescribed()) {
      warnings.push_back({WarningClass::no_contact, "no contact at this height"});
    } else if (request.load() > 0.0) {
      warnings.push_back({WarningClass::no_load,
                          "the load, " + text_of(request.load()) +
                              " N, is treated as zero load: it presses wheel " +
                              "and rail together by less than " + text_of(min_depth) + " mm"});
    } // a load of zero is what was asked for
    return false;
  }
  if (!(depth < max_depth)) {
    throw_invalid_argument(request.vertical ? "pose.vertical" : "load of a wheel",
                           request.vertical.value_or(request.load()),
                           "wheel and rail would overlap by " + short_text_of(depth) +
                               " mm or more; the overlap must be less than " + text_of(max_depth) +
                               " mm");
  }
  return true;
}

void check_found_depth(const WheelRequest& request, double depth) {
  if (request.position_is_prescribed() || std::abs(depth) < max_depth) {
    return;
  }
  const double load = request.load();
  throw Error(ErrorCode::no_contact, "no contact found that carries the load of " + text_of(load) +
                                         " N: the search for the depth ended at " +
                                         short_text_of(depth) + " mm; it must be less than " +
                                         text_of(max_depth) + " mm");
}

void mark_unsettled(GridSolution& solution, int solutions, Warnings& warnings) {
  if (solution.no_contact()) {
    return;
  }
  solution.stop_reason = StopReason::iteration_limit;
  warnings.push_back({WarningClass::not_settled,
                      "not settled: depth, plane or extent of the contact still changes after " +
                          std::to_string(solutions) + " solutions on the final grid"});
}

void warn_of_rounding(const GridSolution& solution, const WheelRequest& request,
                      double wheel_radius, Warnings& warnings) {
  double overlap = 0.0;
  double pressure = 0.0;
  for (const Patch& patch : solution.patches) {
    if (!patch.no_contact()) {
      overlap = std::max(overlap, patch.overlap());
      pressure = std::max(pressure, pressure_rounding(patch, request, wheel_radius));
    }
  }
  if (!(overlap > 0.0)) {
    return;
  }
  const double error = std::max(pressure / solution.peak_pressure(), table_difference / overlap);
  const double left = warned_rounding * request.accuracy;
  if (error > left) {
    // With the same number of elements across, elements and pressures grow with the root of the
    // overlap.
    warnings.push_back(
        {WarningClass::rounding,
         "wheel and rail overlap by only " + short_text_of(overlap) + " mm: below " +
             short_text_of(overlap * error / left) +
             " mm the rounding of positions changes the pressures too much for the accuracy of " +
             text_of(request.accuracy),
         error / request.accuracy});
  }
}

} // namespace wrc
