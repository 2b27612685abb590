#include "scene/model_choice.hpp"

namespace wrc {

ModelChoice choose_model(const Scene& scene) {
  const std::string asked = "asked for by name";
  if (scene.model == "hertz") {
    return {ApproximateModel::hertz, "hertz", asked};
  }
  if (scene.model == "kik-piotrowski") {
    return scene.yaw == 0.0
               ? ModelChoice{ApproximateModel::kik_piotrowski, "kik-piotrowski", asked}
               : ModelChoice{ApproximateModel::kik_piotrowski, "kik-piotrowski-yawed",
                             asked + "; with yaw strips are centred on the wheel's own gap"};
  }
  if (scene.model == "half-space") {
    return {std::nullopt, "half-space", asked};
  }
  return {std::nullopt, "half-space",
          "auto: of all models only the half-space estimates its error, at about the same cost"};
}

} // namespace wrc
