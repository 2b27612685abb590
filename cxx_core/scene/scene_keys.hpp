/// The keys of a scene: one table of name, unit, default, permitted values and meaning.
///
/// Scene files, the C interface and the drivers' help all read this table, so they cannot differ.
/// Thread rule: the table is constant; setting changes only the scene given.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace wrc {

/// What is told of a key.
struct KeyDescription {
  std::string_view name;          ///< for example "track.gauge"
  std::string_view default_value; ///< as it stands in a scene file
  std::string_view allowed;       ///< permitted values, with the unit
  std::string_view meaning;
};

/// All keys, in the order of a scene file.
std::span<const KeyDescription> scene_keys();

/// Set a key. Each throws Error(unknown_name) for an unknown key and Error(invalid_argument) for a
/// value of the wrong type or outside its range; the scene is then unchanged.
void set_number(Scene& scene, std::string_view key, double value);
void set_text(Scene& scene, std::string_view key, std::string_view value);
void set_numbers(Scene& scene, std::string_view key, std::span<const double> values);

} // namespace wrc
