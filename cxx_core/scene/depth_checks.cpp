#include "scene/depth_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "remesh/depth_estimate.hpp"

namespace wrc {
namespace {

/// Depth that positions can just tell apart, mm: their rounding, 1e-13 mm, is 1e-4 of it. On steel
/// it takes about 2e-7 N.
constexpr double least_depth = 1e-9;
/// Roundings of the wheel's radius below which an overlap has pressures that are off by 1e-3.
constexpr double felt_roundings = 3e4;

} // namespace

bool is_in_contact(const SideRequest& request, double depth, std::vector<std::string>& warnings) {
  if (!(depth >= least_depth)) {
    if (request.position_is_prescribed()) {
      warnings.emplace_back("no contact at this height");
    } else if (request.load() > 0.0) {
      warnings.push_back("the load, " + text_of(request.load()) +
                         " N, is taken for none: it presses wheel " +
                         "and rail together by less than " + text_of(least_depth) + " mm");
    } else {
      warnings.emplace_back("no load");
    }
    return false;
  }
  if (!(depth < greatest_depth)) {
    throw_invalid_argument(request.vertical      ? "pose.vertical"
                           : request.normal_load ? "load.normal"
                                                 : "load of a wheel",
                           request.vertical.value_or(request.load()),
                           "wheel and rail would overlap by " + short_text_of(depth) +
                               " mm or more; allowed is less than " + text_of(greatest_depth) +
                               " mm");
  }
  return true;
}

void check_depth_found(const SideRequest& request, double depth) {
  if (request.position_is_prescribed() || std::abs(depth) < greatest_depth) {
    return;
  }
  const double load = request.load();
  throw Error(ErrorCode::no_contact, "no contact found that bears the load of " + text_of(load) +
                                         " N: the search for the depth ended at " +
                                         short_text_of(depth) + " mm; allowed is less than " +
                                         text_of(greatest_depth) + " mm");
}

void mark_unsettled(Trial& trial, int solutions, std::vector<std::string>& warnings) {
  if (trial.no_contact()) {
    return;
  }
  trial.stop_reason = StopReason::iteration_limit;
  warnings.push_back("not settled: depth, plane or extent of the contact still change after " +
                     std::to_string(solutions) + " solutions on the final grid");
}

void warn_of_rounding(const Trial& trial, double wheel_radius, std::vector<std::string>& warnings) {
  double overlap = 0.0;
  for (const PatchTrial& patch : trial.patches) {
    if (!patch.no_contact()) {
      overlap = std::max(overlap, patch.overlap(trial.approach));
    }
  }
  const double felt = felt_roundings * std::numeric_limits<double>::epsilon() * wheel_radius;
  if (overlap > 0.0 && overlap < felt) {
    warnings.push_back("wheel and rail overlap by " + short_text_of(overlap) + " mm only: below " +
                       short_text_of(felt) +
                       " mm the rounding of positions is felt in the pressures");
  }
}

} // namespace wrc
