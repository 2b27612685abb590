#include "scene/scene.hpp"

#include <cmath>

#include <algorithm>
#include <cctype>

namespace wrc {

Scene::Scene() {
  track.cant = std::atan(1.0 / 40.0);
}

bool is_sliced(const ProfileChoice& choice) {
  std::string ending =
      choice.name.substr(choice.name.size() - std::min<std::size_t>(5, choice.name.size()));
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return !choice.given && (ending == ".slcs" || ending == ".slcw");
}

bool has_prismatic_rails(const Scene& scene) {
  return !is_sliced(scene.left.rail) && !is_sliced(scene.right.rail);
}

bool has_round_wheels(const Scene& scene) {
  return !is_sliced(scene.left.wheel) && !is_sliced(scene.right.wheel) &&
         scene.left.wheel.harmonics.empty() && scene.right.wheel.harmonics.empty();
}

} // namespace wrc
