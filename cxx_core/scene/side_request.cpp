#include "scene/side_request.hpp"

#include "error.hpp"
#include "remesh/depth_estimate.hpp"

namespace wrc {
namespace {

/// Depth that positions can just tell apart, mm: their rounding, 1e-13 mm, is 1e-4 of it. On steel
/// it takes about 2e-7 N.
constexpr double least_depth = 1e-9;

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

} // namespace wrc
