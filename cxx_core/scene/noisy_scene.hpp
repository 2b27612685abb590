/// A scene with noisy profiles, and what their noise leaves uncertain (noise_spread.hpp).
///
/// Units mm, MPa. Thread rule: plain values.
#pragma once

#include <memory>
#include <optional>

#include "keys/scene.hpp"
#include "profile/profile.hpp"

namespace wrc {

/// Spreads of a wheel's results; none if it is not solved, or if too few likely curves give a
/// solution.
struct WheelSpread {
  std::optional<double> pmax{};
  std::optional<double> area{};
};

struct SceneSpread {
  std::optional<double> rolling_radius_difference{};
  WheelSpread left;
  WheelSpread right;
};

/// A scene and the doubts about its profiles.
struct NoisyScene {
  using Doubt = std::shared_future<ProfileDoubt>; ///< none: not valid

  Scene scene;
  Doubt left_wheel;
  Doubt left_rail;
  Doubt right_wheel;
  Doubt right_rail;
};

} // namespace wrc
