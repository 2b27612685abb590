/// One field of a patch: a name, and how its values are computed from the results.
///
/// Values in mm, N, MPa, y left, z up. Thread rule: constants; the functions are pure.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/solve_scene.hpp"

namespace wrc {

struct PatchField {
  std::string_view name;
  Dimension dimension;
  std::vector<double> (*compute)(const WheelDetails&, const PatchResult&);
};

/// That of stresses or wear with this name, or none (damage_fields.cpp).
const PatchField* damage_field(std::string_view name);
/// All of those.
std::span<const PatchField> damage_fields();

} // namespace wrc
