/// A scene with noisy profiles, and what their noise leaves uncertain (noise_spread.hpp).
///
/// Units mm, MPa. Thread rule: plain values.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "keys/scene.hpp"
#include "profile/profile.hpp"
#include "results/grade.hpp"

namespace wrc {

/// None if the wheel is not solved, or if too few curves give a solution.
struct PressedNumbers {
  std::optional<double> pmax{};
  std::optional<double> area{};
};

struct WheelSpread : PressedNumbers {
  std::optional<Grade> grade{}; ///< of the larger of both, over what they are of
};

struct SceneSpread {
  std::optional<double> rolling_radius_difference{};
  WheelSpread left;
  WheelSpread right;
  /// rolling_radius_difference with each likely curve, and with each smoothed one where waves may
  /// be noise; not-a-number where there is none.
  std::vector<double> likely_differences{};
  std::vector<double> smoothed_differences{};
};

/// What each wheel has with its profiles of points smoothed by each of smoothed_waves.
struct SmoothedScene {
  using Wheel = std::array<PressedNumbers, smoothed_waves.size()>;
  Wheel left;
  Wheel right;
};

/// A scene and the doubts about its profiles.
struct NoisyScene {
  using Doubt = Deferred<ProfileDoubt>; ///< none: not valid

  Scene scene;
  Doubt left_wheel;
  Doubt left_rail;
  Doubt right_wheel;
  Doubt right_rail;
};

} // namespace wrc
