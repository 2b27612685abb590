#include "scene/scene_wheel.hpp"

#include <utility>

#include "derivatives/force_jacobian.hpp"
#include "derivatives/wheel_rates.hpp"
#include "results/residuals.hpp"

namespace wrc {

SceneWheel::SceneWheel(WheelResult result) : WheelResult(std::move(result)) {}

const Residuals& SceneWheel::residuals() {
  return residuals_ ? *residuals_ : residuals_.emplace(residuals_of(*this));
}

const WheelRates* SceneWheel::sensitivities() {
  if (!sensitivities_) {
    sensitivities_.emplace(wheel_rates_of(*this));
  }
  return *sensitivities_ ? &**sensitivities_ : nullptr;
}

const ForceJacobian* SceneWheel::jacobian() {
  if (!jacobian_ && jacobian_is_known(*this)) {
    if (const WheelRates* rates = sensitivities()) {
      jacobian_ = jacobian_of(*this, *rates);
    }
  }
  return jacobian_ ? &*jacobian_ : nullptr;
}

const std::vector<PressureLobe>& SceneWheel::lobes(std::size_t patch,
                                                   std::optional<std::size_t> part) {
  const std::pair key{patch, part};
  auto found = lobes_.find(key);
  if (found == lobes_.end()) {
    const PatchResult& of = part ? patches[patch].parts[*part] : patches[patch];
    found = lobes_.emplace(key, pressure_lobes(of, details)).first;
  }
  return found->second;
}

} // namespace wrc
