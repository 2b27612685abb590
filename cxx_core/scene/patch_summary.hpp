/// The patches of a result as vehicle codes read them: rows of numbers, in an order that stays.
///
/// Numbers are those of results by name (scene/number_tables.hpp), in the scene's convention.
/// Thread rule: pure functions.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "scene/scene_result.hpp"

namespace wrc {

/// A patch and its wheel; valid as long as the result.
struct FoundPatch {
  const WheelResult* wheel;
  const PatchResult* patch;
};

/// Patches of the left wheel first, each wheel's from the flange to the field side: their order
/// stays the same from step to step.
std::vector<FoundPatch> ordered_patches(const SceneResult& result);

/// The members of wrc_patch in their order. Further ones go to the end.
inline constexpr std::array patch_summary_names =
    std::to_array<std::string_view>({"wheel", // 0: left, 1: right
                                     "x",
                                     "y",
                                     "z", // of the reference
                                     "normal.x",
                                     "normal.y",
                                     "normal.z", // from the rail to the wheel
                                     "angle",
                                     "rolling_radius",
                                     "s_wheel",
                                     "normal_force",
                                     "creep_force.longitudinal",
                                     "creep_force.lateral",
                                     "spin_moment",
                                     "creepage.longitudinal",
                                     "creepage.lateral",
                                     "creepage.spin",
                                     "semi_axes.longitudinal",
                                     "semi_axes.lateral",
                                     "approach",
                                     "pmax",
                                     "friction_power",
                                     "longitudinal_force",
                                     "lateral_force",
                                     "vertical_force",
                                     "pressure_force.x",
                                     "pressure_force.y",
                                     "pressure_force.z",
                                     "coupling_weight"});

/// 0 for results of creep forces that were not requested, not-a-number for others that are absent.
using PatchSummary = std::array<double, patch_summary_names.size()>;

/// Summaries of all patches, as ordered_patches.
std::vector<PatchSummary> patch_summaries(const SceneResult& result, const Convention& convention);

} // namespace wrc
