#include "scene/model_choice.hpp"

namespace wrc {

ModelChoice choose_model(const Scene& scene) {
  const std::string asked = "selected by name";
  switch (scene.model) {
  case ModelRequest::hertz:
    return {ApproximateModel::hertz, "hertz", asked};
  case ModelRequest::kik_piotrowski:
    return scene.yaw == 0.0
               ? ModelChoice{ApproximateModel::kik_piotrowski, "kik-piotrowski", asked}
               : ModelChoice{ApproximateModel::kik_piotrowski, "kik-piotrowski-yawed",
                             asked + "; with yaw strips are centred on the wheel's own gap"};
  case ModelRequest::half_space:
    return {std::nullopt, "half-space", asked};
  case ModelRequest::automatic:
    break;
  }
  return {std::nullopt, "half-space",
          "auto: of all models only the half-space estimates its error, at about the same cost"};
}

} // namespace wrc
