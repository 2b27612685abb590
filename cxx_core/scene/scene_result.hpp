/// The result of a scene.
///
/// In the track frame (geometry/frames.hpp), both wheels alike; only along a profile (`s_wheel`,
/// `t_rail`) and across a patch (`lateral`) positive means to the field side.
/// Units mm, N, MPa, rad; times in ms. Thread rule: a plain value, except for what its
/// wheels compute when it is first read (scene_wheel.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/heap_optional.hpp"
#include "keys/key_warnings.hpp"
#include "keys/scene.hpp"
#include "scene/noisy_scene.hpp"
#include "scene/profile_warnings.hpp"
#include "scene/scene_wheel.hpp"

namespace wrc {

/// Milliseconds by stage; a stage's threads are added up, the total is wall time.
struct StageMilliseconds {
  double profile = 0.0;
  double setup = 0.0;
  double geometry = 0.0;
  double remesh = 0.0;
  double mechanics = 0.0;
  double rolling = 0.0; ///< creep forces
  double damage = 0.0;  ///< stresses, wear and fatigue, if requested
  double total = 0.0;
};

struct SceneResult {
  double roll = 0.0;
  double vertical = 0.0; ///< height of the wheelset's centre at the first touch
  std::optional<double> rolling_radius_difference; ///< left - right; with both sides
  std::optional<double> pitch;     ///< rate of the axle, rad/s; with a motion and creep forces
  bool pitch_is_ambiguous = false; ///< friction falls: another rate holds the torque, too
  bool pitch_is_saturated = false; ///< friction cannot hold the torque of a free pitch rate
  std::string model;
  SolverChoice solver = SolverChoice::standard;
  std::optional<SceneWheel> left;
  std::optional<SceneWheel> right;
  StageMilliseconds time;
  std::vector<std::string> corrections; ///< made to profiles read from files
  KeyWarnings key_warnings;             ///< of the scene
  ProfileWarnings profile_warnings;     ///< of the profiles it was solved with
  HeapOptional<NoisyScene> noise;       ///< with profiles of points
  HeapOptional<SceneSpread> spread;     ///< once it was requested, see spread_of
  HeapOptional<SmoothedScene> smoothed; ///< likewise, see smoothed_of
};

} // namespace wrc
