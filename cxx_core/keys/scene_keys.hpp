/// The keys of a scene: one table of name, unit, default, permitted values and meaning.
///
/// Scene files, the C interface and the drivers' help all read this table, so they cannot differ.
/// Thread rule: the table is constant; setting changes only the scene given.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "keys/scene.hpp"
#include "keys/scene_key.hpp"

namespace wrc {

/// All keys, in the order of a scene file.
std::span<const KeyDescription> scene_keys();

/// Value of a key, in the scene's convention. Throws Error(unknown_name).
KeyValue key_value(const Scene& scene, std::string_view key);

/// Set a key, or an option of a profile ("track.rail.smoothing"), with numbers in the scene's
/// convention. Each throws Error(unknown_name) for an
/// unknown key and Error(invalid_argument) for a value of the wrong type or outside its range; the
/// scene is then unchanged.
void set_number(Scene& scene, std::string_view key, double value);
void set_text(Scene& scene, std::string_view key, std::string_view value);
void set_numbers(Scene& scene, std::string_view key, std::span<const double> values);

/// Unit of the number that a key holds, "mm" or "1" of a pure one; "" if it holds a text or a list.
/// Throws Error(unknown_name).
std::string key_unit(std::string_view key, Units units);

/// Id of a key: its index in scene_keys(). Throws Error(unknown_name).
std::int32_t key_id(std::string_view key);
/// As set_number for each key by its id, in this order; if one is refused, none is set. One
/// value for each id. Throws Error(invalid_argument).
void set_numbers_by_id(Scene& scene, std::span<const std::int32_t> ids,
                       std::span<const double> values);

/// "track.rail" or "wheelset.wheel": a profile of that kind, instead of one by name.
void set_profile(Scene& scene, std::string_view key, const Profile& profile);

} // namespace wrc
