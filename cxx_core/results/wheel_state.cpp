#include "results/wheel_state.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "results/constants.hpp"

namespace wrc {
namespace {

/// The profile's slope there, between two nodes linear.
double slope_at(const ProfileNodes& nodes, double s) {
  const auto after = std::upper_bound(nodes.lateral.begin(), nodes.lateral.end(), s);
  if (after == nodes.lateral.begin()) {
    return nodes.slope.front();
  }
  if (after == nodes.lateral.end()) {
    return nodes.slope.back();
  }
  const auto i = static_cast<std::size_t>(after - nodes.lateral.begin());
  const double share = (s - nodes.lateral[i - 1]) / (nodes.lateral[i] - nodes.lateral[i - 1]);
  return std::lerp(nodes.slope[i - 1], nodes.slope[i], share);
}

/// Whether the profile falls more steeply somewhere between this point and the taping line.
bool is_on_flange_tip(const ProfileNodes& nodes, double s) {
  double steepest = INFINITY;
  for (std::size_t i = 0; i < nodes.lateral.size(); ++i) {
    if (nodes.lateral[i] > s && nodes.lateral[i] < 0.0) {
      steepest = std::min(steepest, nodes.slope[i]);
    }
  }
  return std::atan(steepest) < std::atan(slope_at(nodes, s)) - tip_fall;
}

bool is_on_chamfer(const ProfileNodes& nodes, double s) {
  return s > 0.0 && std::atan(slope_at(nodes, s)) < -max_tread_slope;
}

} // namespace

std::optional<int> wheel_state(const WheelResult& wheel) {
  if (!wheel.solved) {
    return std::nullopt;
  }
  int state = wheel.patches.empty() ? lifted : wheel.meets_part_end ? at_part_end : 0;
  const ProfileNodes& nodes = wheel.details.wheel->nodes();
  for (const PatchResult& patch : wheel.patches) {
    state |= is_on_flange_tip(nodes, patch.reference.s_wheel) ? on_flange_tip : 0;
    state |= is_on_chamfer(nodes, patch.reference.s_wheel) ? on_chamfer : 0;
  }
  const std::vector<YieldingBody>& bodies = wheel.details.request.yielding;
  const bool yields =
      !bodies.empty() && (wheel.is_unbounded || wheel.pmax > onset_of_yield(bodies));
  return state | (yields ? beyond_yield : 0);
}

void warn_of_pressure(WheelResult& wheel) {
  const bool is_steel = !(wheel.details.request.combined_modulus > stiffest_steel);
  const double limit = is_steel ? hardest_steel : hardest_ceramic;
  if (wheel.is_unbounded || !(wheel.pmax > limit)) {
    return;
  }
  const auto pressed = std::max_element(
      wheel.patches.begin(), wheel.patches.end(),
      [](const PatchResult& one, const PatchResult& other) { return one.pmax < other.pmax; });
  const auto index = static_cast<std::size_t>(pressed - wheel.patches.begin());
  wheel.warnings.push_back(
      {WarningClass::pressure,
       of_patch(wheel, index) + "the largest pressure, " + text_of(std::round(wheel.pmax)) +
           (is_steel ? " MPa, is more than steel can carry: the hardest rails"
                     : " MPa, is more than any body can carry: hard ceramics") +
           " flow at " + text_of(std::round(limit)) +
           " MPa, so real pressures are lower and the contact is larger"});
}

} // namespace wrc
