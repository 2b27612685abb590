#include "keys/scene.hpp"

#include <cmath>

#include "base/lower_case.hpp"

namespace wrc {

Scene::Scene() {
  track.cant = std::atan(1.0 / 40.0);
}

bool is_sliced(const ProfileChoice& choice) {
  const std::string name = lower_case(choice.name);
  return !choice.given && (name.ends_with(".slcs") || name.ends_with(".slcw"));
}

bool has_prismatic_rails(const Scene& scene) {
  return !is_sliced(scene.left.rail) && !is_sliced(scene.right.rail);
}

bool has_round_wheels(const Scene& scene) {
  return !is_sliced(scene.left.wheel) && !is_sliced(scene.right.wheel) &&
         scene.left.wheel.harmonics.empty() && scene.right.wheel.harmonics.empty();
}

} // namespace wrc
