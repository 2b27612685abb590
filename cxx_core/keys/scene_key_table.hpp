/// The table of all keys of a scene.
///
/// Thread rule: the table is made once, and constant then.
#pragma once

#include <vector>

#include "keys/scene_key.hpp"

namespace wrc {

/// All keys, in the order of a scene file: those of one side after those of both. Built by each
/// call.
std::vector<Key> make_scene_keys();
/// Those of the track and the wheelset among them.
std::vector<Key> make_track_keys();
std::vector<Key> make_wheelset_keys();
/// Those of loads.
std::vector<Key> make_load_keys();
/// Those of friction, creepages and speed.
std::vector<Key> make_rolling_keys();
/// Those of stresses, wear and fatigue.
std::vector<Key> make_damage_keys();

} // namespace wrc
