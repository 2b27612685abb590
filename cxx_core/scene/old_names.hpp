/// Names that results of a wheel or a patch once had, and those that they have now.
///
/// Programs, studies and ids of earlier versions go on with them: number_id (scene/number_ids.hpp)
/// looks here for names it does not know. No list of names shows them. Thread rule: constants.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace wrc {

/// The beginning of a name, behind the wheel and the patch, or all of it.
struct OldName {
  std::string_view old;
  std::string_view now;
};

/// The first of two numbers was the lateral one in grids, the longitudinal one in axes and radii.
inline constexpr std::array old_names{
    OldName{"grid.0", "grid.lateral"},
    OldName{"grid.1", "grid.longitudinal"},
    OldName{"element_size.0", "element_size.lateral"},
    OldName{"element_size.1", "element_size.longitudinal"},
    OldName{"creep_grid.0", "creep_grid.lateral"},
    OldName{"creep_grid.1", "creep_grid.longitudinal"},
    OldName{"creep_element_size.0", "creep_element_size.lateral"},
    OldName{"creep_element_size.1", "creep_element_size.longitudinal"},
    OldName{"semi_axes.0", "semi_axes.longitudinal"},
    OldName{"semi_axes.1", "semi_axes.lateral"},
    OldName{"radii.0", "radii.longitudinal"},
    OldName{"radii.1", "radii.lateral"},
    OldName{"closeness", "coupling_weight"},
    OldName{"moment.", "pressure_moment."},
    OldName{"sensitivities.lateral_force.", "sensitivities.pressure_force.y."},
    OldName{"sensitivities.vertical_force.", "sensitivities.pressure_force.z."},
    OldName{"sensitivities.at_load.lateral_force.", "sensitivities.at_load.pressure_force.y."},
};

/// What a name that is no longer there is called now.
inline std::optional<std::string> name_now(std::string_view name) {
  const auto* const found =
      std::find_if(old_names.begin(), old_names.end(),
                   [name](const OldName& entry) { return name.starts_with(entry.old); });
  if (found == old_names.end()) {
    return std::nullopt;
  }
  return std::string(found->now).append(name.substr(found->old.size()));
}

} // namespace wrc
