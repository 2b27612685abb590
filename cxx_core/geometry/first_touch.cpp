#include "geometry/first_touch.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "geometry/constants.hpp"

namespace wrc {
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
  const double flange_height = tip - graph.at_lateral(tip_lateral + tread_from_flange_tip).height;
  if (flange_height > least_flange_height && touch.wheel.height > tip - flange_tip_height) {
    return Warning{WarningClass::flange_tip, "first touch is on the flange tip," + where + advice};
  }
  if (touch.wheel.lateral > 0.0 &&
      graph.at_lateral(touch.wheel.lateral).slope() < -least_chamfer_slope) {
    return Warning{WarningClass::chamfer,
                   "first touch is on the wheel's chamfer," + where + advice};
  }
  return std::nullopt;
}

} // namespace wrc
