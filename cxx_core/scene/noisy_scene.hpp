/// A scene with noisy profiles, and what their noise leaves uncertain (noise_spread.hpp).
///
/// Units mm, MPa. Thread rule: plain values.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "keys/scene.hpp"
#include "profile/curve.hpp"

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

/// A scene with the equally likely curves of its profiles, and its spread once it was requested.
struct NoisyScene {
  using LikelyCurves = std::shared_ptr<const std::vector<Curve>>; ///< none: NULL

  Scene scene;
  LikelyCurves left_wheel;
  LikelyCurves left_rail;
  LikelyCurves right_wheel;
  LikelyCurves right_rail;
  std::optional<SceneSpread> spread{};
};

} // namespace wrc
