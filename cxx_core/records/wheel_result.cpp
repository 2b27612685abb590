#include "records/wheel_result.hpp"

#include <algorithm>

namespace wrc {

std::vector<const PatchResult*> solved_patches(const WheelResult& side) {
  std::vector<const PatchResult*> patches;
  for (const PatchResult& patch : side.patches) {
    if (patch.parts.empty()) {
      patches.push_back(&patch);
    }
    for (const PatchResult& part : patch.parts) {
      patches.push_back(&part);
    }
  }
  return patches;
}

bool is_pressed_again(const WheelResult& side) {
  return std::ranges::any_of(solved_patches(side), [](const PatchResult* patch) {
    return !patch->groove.carried.empty();
  });
}

std::span<const YieldingBody> yielding_of(const Patch& patch, const WheelDetails& side) {
  return patch.elastic_peak ? std::span<const YieldingBody>(side.request.yielding)
                            : std::span<const YieldingBody>();
}

std::string of_patch(const WheelResult& wheel, std::size_t index) {
  return wheel.patches.size() > 1 ? "patch " + std::to_string(index) + ": " : std::string();
}

} // namespace wrc
