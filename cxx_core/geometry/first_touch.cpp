#include "geometry/first_touch.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace wrc {
namespace {

/// What lies so close below the largest radius is the flange tip, mm.
/// origin: published: qR is measured from 2 mm below the tip (EN 13715).
constexpr double tip_height = 2.0;
/// So far above the tread a flange tip is at least, mm, and so far beside it the tread is.
/// origin: published: flanges of trams are 20 mm high or more; the taping line is 55 mm from the
/// tip (EN 13715).
constexpr double least_flange_height = 15.0;
constexpr double tread_distance = 60.0;
/// Slope of a chamfer at least, falling to the field side.
/// origin: published: treads have slopes up to 1:6.7, chamfers of 1:1 (EN 13715).
constexpr double chamfer_slope = 0.3;

} // namespace

std::optional<Warning> warning_of_touch(const WheelSurface& wheel, const ContactCandidate& touch) {
  const std::string where = " at s_wheel " + short_text_of(touch.wheel.lateral) + " mm, height " +
                            short_text_of(touch.wheel.height) + " mm";
  const std::string advice = ": check the profile's origin and signs, the gauge and the position";
  const CurveGraph& graph = wheel.graph();
  const ProfileNodes& nodes = wheel.nodes();
  const auto highest = std::max_element(nodes.height.begin(), nodes.height.end());
  const double tip = *highest;
  const double tip_lateral =
      nodes.lateral[static_cast<std::size_t>(highest - nodes.height.begin())];
  const double flange_height = tip - graph.at_lateral(tip_lateral + tread_distance).height;
  if (flange_height > least_flange_height && touch.wheel.height > tip - tip_height) {
    return Warning{WarningClass::flange_tip, "first touch is on the flange tip," + where + advice};
  }
  if (touch.wheel.lateral > 0.0 && graph.at_lateral(touch.wheel.lateral).slope() < -chamfer_slope) {
    return Warning{WarningClass::chamfer,
                   "first touch is on the wheel's chamfer," + where + advice};
  }
  return std::nullopt;
}

} // namespace wrc
