#include "scene/scene.hpp"

#include <cmath>

namespace wrc {

Scene::Scene() {
  track.cant = std::atan(1.0 / 40.0);
}

} // namespace wrc
