#include "table/wheel_outputs.hpp"

#include <algorithm>
#include <cmath>

#include "results/wheel_state.hpp"
#include "scene/number_tables.hpp"
#include "table/constants.hpp"

namespace wrc {
namespace {

/// Of the normal force, by rows of elements.
double flange_share_of(const WheelResult& wheel) {
  double flange = 0.0;
  double all = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    for (const LoadedRow& row : patch.slip.value().rows) {
      all += row.force;
      flange += patch.frame.angle() + std::asin(row.sine) > flange_lobe_angle ? row.force : 0.0;
    }
  }
  return all > 0.0 ? flange / all : 0.0;
}

} // namespace

std::array<double, place_part_count> place_parts_of(const WheelResult& wheel) {
  std::array<double, place_part_count> parts{};
  if (wheel.patches.empty()) {
    return parts;
  }
  const int state = wheel.state.value_or(0);
  return {wheel.centroid.t_rail,
          wheel.centroid.s_wheel,
          wheel.details.mirror * wheel.centroid.angle,
          wheel.centroid.rolling_radius,
          flange_share_of(wheel),
          (state & on_flange_tip) != 0 ? 1.0 : 0.0,
          (state & on_chamfer) != 0 ? 1.0 : 0.0,
          0.0};
}

WheelOutputs outputs_of(const std::array<double, place_part_count>& place, double normal_force,
                        double wear_number) {
  const auto part = [&place](PlacePart which) { return place[static_cast<std::size_t>(which)]; };
  const double flange = std::clamp(part(PlacePart::flange_share), 0.0, 1.0) * normal_force;
  return {wear_number,
          part(PlacePart::rail_place),
          part(PlacePart::wheel_place),
          part(PlacePart::angle),
          part(PlacePart::radius),
          normal_force - flange,
          flange,
          part(PlacePart::tip) > 0.5 ? 1.0 : 0.0};
}

std::string names_of_outputs() {
  std::string names;
  for (const OutputKey& output : wheel_outputs) {
    (names += names.empty() ? "" : ", ") += output.name;
  }
  return names;
}

WheelOutputs outputs_of(const WheelResult& wheel) {
  return outputs_of(place_parts_of(wheel), wheel.normal_force,
                    number_tables::wear_number_of(wheel).value_or(0.0));
}

} // namespace wrc
