/// A wheel of a scene: its result, and what is computed from it when it is first read.
///
/// Track frame, units of the result. Thread rule: the result is a plain value; the functions keep
/// what they compute, so one thread at a time calls them.
#pragma once

#include <optional>

#include "records/wheel_result.hpp"

namespace wrc {

struct SceneWheel : WheelResult {
  SceneWheel() = default;
  explicit SceneWheel(WheelResult result);

  /// wheel/residuals.hpp.
  const Residuals& residuals();
  /// derivatives/wheel_sensitivities.hpp; null if there are none.
  const WheelRates* sensitivities();
  /// derivatives/force_jacobian.hpp; null if there is none.
  const ForceJacobian* jacobian();

private:
  std::optional<Residuals> residuals_;
  std::optional<std::optional<WheelRates>> sensitivities_; ///< of which there may be none
  std::optional<ForceJacobian> jacobian_;
};

} // namespace wrc
