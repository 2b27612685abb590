/// All warnings of a result: those of keys without effect, of the profiles, and of both wheels.
///
/// Thread rule: pure functions.
#pragma once

#include <cstddef>

#include "base/warning.hpp"
#include "scene/scene_result.hpp"

namespace wrc {

/// How many warnings there are: of keys, profiles and both wheels.
std::size_t warning_count(const SceneResult& result);
/// All of them, those of keys and profiles first, then those of the left and the right wheel; each
/// begins with its source: "load.left ", "wheel profile worn.prw: ", "left: ".
Warnings all_warnings(const SceneResult& result);
} // namespace wrc
