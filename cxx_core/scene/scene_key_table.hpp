/// One key of a scene: what is said of it, and how it is read and set.
///
/// Here text ends: words become enumerators, and the scene holds no other strings than names of
/// profiles. Thread rule: the table is made once, and constant then.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene_keys.hpp"

namespace wrc {

struct Key {
  KeyDescription description;
  Dimension dimension;
  double min = 0.0; ///< range of a number in mm, y left, z up, ends included
  double max = 0.0;
  bool whole = false; ///< whole numbers only
  /// Numbers in mm, y left, z up. Setting returns false for what is not permitted.
  std::function<KeyValue(const Scene&)> get;
  std::function<void(Scene&, double)> set_number;
  std::function<bool(Scene&, std::string_view)> set_text;
  std::function<bool(Scene&, std::span<const double>)> set_numbers;
  std::function<bool(Scene&, const Profile&)> set_profile;
};

/// All keys, in the order of a scene file: those of one side after those of both. Made again by
/// each call.
std::vector<Key> make_scene_keys();
/// Of them, those of loads.
std::vector<Key> make_load_keys();
/// Those of friction, creepages and speed.
std::vector<Key> make_rolling_keys();
/// Those of stresses, wear and fatigue.
std::vector<Key> make_damage_keys();

} // namespace wrc
