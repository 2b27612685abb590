/// A wheel of a scene: its result, and what is computed from it when it is first read.
///
/// Track frame, units of the result. Thread rule: the result is a plain value; the functions keep
/// what they compute, so one thread at a time calls them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/heap_optional.hpp"
#include "records/wheel_result.hpp"
#include "results/pressure_lobes.hpp"

namespace wrc {

struct SceneWheel : WheelResult {
  SceneWheel() = default;
  explicit SceneWheel(WheelResult result);

  /// results/residuals.hpp.
  const Residuals& residuals();
  /// derivatives/wheel_rates.hpp; null if there are none.
  const WheelRates* sensitivities();
  /// derivatives/force_jacobian.hpp; null if there is none.
  const ForceJacobian* jacobian();
  /// results/pressure_lobes.hpp, of a patch or of one of its parts.
  const std::vector<PressureLobe>& lobes(std::size_t patch, std::optional<std::size_t> part);

private:
  HeapOptional<Residuals> residuals_;
  std::optional<HeapOptional<WheelRates>> sensitivities_; ///< of which there may be none
  HeapOptional<ForceJacobian> jacobian_;
  std::map<std::pair<std::size_t, std::optional<std::size_t>>, std::vector<PressureLobe>> lobes_;
};

} // namespace wrc
