/// From the depth that a solution asks for to the next one to solve at.
///
/// Units mm. Thread rule: one object for each wheel that is solved.
/// Not known here: what a change of the depth does to distances.
#pragma once

#include <algorithm>
#include <optional>

#include "wheel/constants.hpp"

namespace wrc {

/// The depth by the secant method: along a steep tangent the steps that solutions ask for shrink to
/// a half only. A step counts by how far what it changes exceeds a limit, from nothing at the limit
/// to all at twice it: depths are continuous functions of the scene, whatever the number of steps.
class DepthIteration {
public:
  /// `change`: in limits. None: there is nothing left to be done.
  [[nodiscard]] std::optional<double> next(double depth, double found, double change) {
    if (!(change > 1.0)) {
      return std::nullopt;
    }
    const double step = found - depth;
    const double rate = last_step_ != 0.0 ? (step - last_step_) / (depth - last_depth_) : -1.0;
    last_depth_ = depth;
    last_step_ = step;
    const double whole = rate < min_rate ? -step / rate : step;
    return std::max(depth + std::min(2.0 - 2.0 / change, 1.0) * whole, min_depth_ratio * depth);
  }

private:
  double last_depth_ = 0.0;
  double last_step_ = 0.0;
};

} // namespace wrc
