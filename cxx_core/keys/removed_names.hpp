/// Names that earlier versions had, and what takes their place: the one table of them.
///
/// Errors say it wherever such a key or result is asked for, in every interface; the header refuses
/// removed functions with the same text, and CHANGELOG.md lists all.
/// Thread rule: constants.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace wrc {

enum class NameOf : unsigned char {
  key,            ///< of a scene
  result,         ///< of a wheel or a patch: the name behind "left." or "left.patches.0."
  rolling_result, ///< of wrc_rolling_number
  member,         ///< of wrc_patch, contact_patch and patch_table()
  function,
};

struct RemovedName {
  NameOf kind;
  std::string_view name;      ///< of a result also the beginning of names, up to a point
  std::string_view successor; ///< a name, or a sentence without a capital and a point
};

inline constexpr std::array removed_names{
    RemovedName{NameOf::key, "load.vertical", "use load.both"},
    RemovedName{NameOf::key, "load.normal", "use load.both with load.of = \"normal\""},
    RemovedName{NameOf::key, "load.total_vertical", "use load.both with load.of = \"total\""},
    RemovedName{NameOf::key, "load.total_left", "use load.left with load.of = \"total\""},
    RemovedName{NameOf::key, "load.total_right", "use load.right with load.of = \"total\""},
    RemovedName{NameOf::key, "track.cant", "use track.inclination, which is that of the rails"},
    RemovedName{NameOf::key, "track.superelevation",
                "gravity and cant deficiency belong to the vehicle's loads: use load.left and "
                "load.right"},
    RemovedName{NameOf::key, "material.yield_pressure",
                "use material.rail.yield_stress and material.wheel.yield_stress, with which steel "
                "yields from 1.44 of the smaller one on"},
    RemovedName{NameOf::key, "solve.slip", "slip is taken at each element"},
    RemovedName{NameOf::key, "solve.slip_surface", "slip is taken on the surface of the wheel"},
    RemovedName{NameOf::key, "solve.gap", "use solve.method = \"paper\" for vertical gaps"},
    RemovedName{NameOf::key, "solve.solver", "use solve.method = \"paper\" for the paper's solver"},
    RemovedName{NameOf::key, "solve.elements",
                "use solve.method = \"paper\" for elements of constant pressure"},
    RemovedName{NameOf::key, "solve.interaction", "all patches of a wheel displace each other"},
    RemovedName{
        NameOf::key, "solve.planner",
        "it is an option of a solver: wrc_solver_set_text(solver, \"planner\", \"measure\")"},
    RemovedName{
        NameOf::key, "solve.precision",
        "it is an option of a solver: wrc_solver_set_text(solver, \"precision\", \"double\")"},
    RemovedName{NameOf::key, "track.rail_origin", "use track.rail.origin"},
    RemovedName{NameOf::key, "track.rail_smoothing", "use track.rail.smoothing"},
    RemovedName{NameOf::key, "track.rail_smoothing_along", "use track.rail.smoothing_along"},
    RemovedName{NameOf::key, "track.left.rail_smoothing", "use track.left.rail.smoothing"},
    RemovedName{NameOf::key, "track.right.rail_smoothing", "use track.right.rail.smoothing"},
    RemovedName{NameOf::key, "wheelset.wheel_smoothing", "use wheelset.wheel.smoothing"},
    RemovedName{NameOf::key, "wheelset.wheel_smoothing_along",
                "use wheelset.wheel.smoothing_along"},
    RemovedName{NameOf::key, "wheelset.left.wheel_smoothing", "use wheelset.left.wheel.smoothing"},
    RemovedName{NameOf::key, "wheelset.right.wheel_smoothing",
                "use wheelset.right.wheel.smoothing"},
    RemovedName{NameOf::key, "wheelset.profile_origin", "use wheelset.wheel.origin"},
    RemovedName{NameOf::key, "wheelset.profile_shift", "use wheelset.wheel.shift"},
    RemovedName{NameOf::key, "wheelset.profile_rotation", "use wheelset.wheel.rotation"},
    RemovedName{NameOf::key, "wheelset.align_to", "use wheelset.wheel.align_to"},
    // The first of two numbers was the lateral one in grids, the longitudinal one in axes and
    // radii.
    RemovedName{NameOf::result, "grid.0", "grid.lateral"},
    RemovedName{NameOf::result, "grid.1", "grid.longitudinal"},
    RemovedName{NameOf::result, "element_size.0", "element_size.lateral"},
    RemovedName{NameOf::result, "element_size.1", "element_size.longitudinal"},
    RemovedName{NameOf::result, "creep_grid.0", "creep_grid.lateral"},
    RemovedName{NameOf::result, "creep_grid.1", "creep_grid.longitudinal"},
    RemovedName{NameOf::result, "creep_element_size.0", "creep_element_size.lateral"},
    RemovedName{NameOf::result, "creep_element_size.1", "creep_element_size.longitudinal"},
    RemovedName{NameOf::result, "semi_axes.0", "semi_axes.longitudinal"},
    RemovedName{NameOf::result, "semi_axes.1", "semi_axes.lateral"},
    RemovedName{NameOf::result, "radii.0", "radii.longitudinal"},
    RemovedName{NameOf::result, "radii.1", "radii.lateral"},
    RemovedName{NameOf::result, "closeness", "coupling_weight"},
    RemovedName{NameOf::result, "moment", "pressure_moment"},
    RemovedName{NameOf::result, "sensitivities.lateral_force", "sensitivities.pressure_force.y"},
    RemovedName{NameOf::result, "sensitivities.vertical_force", "sensitivities.pressure_force.z"},
    RemovedName{NameOf::result, "sensitivities.at_load.lateral_force",
                "sensitivities.at_load.pressure_force.y"},
    RemovedName{NameOf::result, "jump",
                "take the difference of rigid_contact.s_wheel of two results"},
    RemovedName{NameOf::result, "regrown", "grids no longer grow"},
    RemovedName{NameOf::rolling_result, "longitudinal_force", "creep_force.longitudinal"},
    RemovedName{NameOf::rolling_result, "lateral_force", "creep_force.lateral"},
    RemovedName{NameOf::member, "contact_angle", "angle"},
    RemovedName{NameOf::member, "longitudinal_creep_force", "creep_force_longitudinal"},
    RemovedName{NameOf::member, "lateral_creep_force", "creep_force_lateral"},
    RemovedName{NameOf::member, "longitudinal_creepage", "creepage_longitudinal"},
    RemovedName{NameOf::member, "lateral_creepage", "creepage_lateral"},
    RemovedName{NameOf::member, "spin_creepage", "creepage_spin"},
    RemovedName{NameOf::member, "longitudinal_semi_axis", "semi_axes_longitudinal"},
    RemovedName{NameOf::member, "lateral_semi_axis", "semi_axes_lateral"},
    RemovedName{NameOf::member, "largest_pressure", "pmax"},
    RemovedName{NameOf::function, "wrc_solver_forget", "use wrc_solver_clear"},
    RemovedName{NameOf::function, "WRCFOR", "use WRCCLR"},
    RemovedName{NameOf::function, "wrc_measure_transform", "time your own FFTW plans"},
};

/// The text of an error about a result that was removed, of which `before` is a wheel or patch:
/// "left.grid.0 is not a result any more: use left.grid.lateral". None if there was no such result.
inline std::optional<std::string> removed_result(NameOf kind, std::string_view before,
                                                 std::string_view name) {
  const auto* const found = std::ranges::find_if(removed_names, [&](const RemovedName& removed) {
    return removed.kind == kind && name.starts_with(removed.name) &&
           (name.size() == removed.name.size() || name[removed.name.size()] == '.');
  });
  if (found == removed_names.end()) {
    return std::nullopt;
  }
  const std::string text = std::string(before).append(name) + " is not a result any more: ";
  if (found->successor.find(' ') != std::string_view::npos) {
    return text + std::string(found->successor);
  }
  return (text + "use ")
      .append(before)
      .append(found->successor)
      .append(name.substr(found->name.size()));
}

} // namespace wrc
