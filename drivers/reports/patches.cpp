#include "reports/patches.hpp"

#include <algorithm>
#include <utility>

namespace driver {

std::vector<PatchName> patches_of(const Scene& scene, const std::string& side) {
  std::vector<PatchName> patches;
  const int count = scene.count_of(side + ".patches");
  for (int i = 0; i < count; ++i) {
    patches.push_back({side, i, side + ".patches." + std::to_string(i) + '.'});
  }
  return patches;
}

std::vector<PatchName> all_patches(const Scene& scene) {
  std::vector<PatchName> patches;
  for (const std::string& side : sides_of(scene)) {
    for (PatchName& patch : patches_of(scene, side)) {
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

std::vector<PatchName> parts_with(const Scene& scene, const std::vector<PatchName>& patches,
                                  const std::string& result) {
  std::vector<PatchName> found;
  for (const PatchName& patch : patches) {
    const int parts = scene.count_of(patch.prefix + "parts");
    for (int i = 0; i < std::max(parts, 1); ++i) {
      PatchName one = patch;
      if (parts > 0) {
        one.prefix += "parts." + std::to_string(i) + '.';
      }
      if (scene.has_number(one.prefix + result)) {
        found.push_back(one);
      }
    }
  }
  return found;
}

} // namespace driver
