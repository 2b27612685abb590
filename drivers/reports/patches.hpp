/// The patches of a solved scene by their names, and what has fields of its own.
///
/// Units mm; track frame. Rows of elements go from the track centre to the field side.
#pragma once

#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// "left.patches.0." and so on.
struct PatchName {
  std::string side;
  int index = 0;
  std::string prefix;
};

/// Those of one side, and those of all sides, in the order of the results.
std::vector<PatchName> patches_of(const Scene& scene, const std::string& side);
std::vector<PatchName> all_patches(const Scene& scene);

/// What has fields of its own, a patch or its parts, if it has this result.
std::vector<PatchName> parts_with(const Scene& scene, const std::vector<PatchName>& patches,
                                  const std::string& result);

inline constexpr const char* creep_result = "creep_force.longitudinal";
inline constexpr const char* stress_result = "stress.von_mises_max";
inline constexpr const char* groove_result = "groove.depth_max";

} // namespace driver
