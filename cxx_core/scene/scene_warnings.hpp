/// All warnings of a result: those of the profiles, and of both wheels.
///
/// Thread rule: pure functions.
#pragma once

#include <cstddef>

#include "base/warning.hpp"
#include "scene/scene_result.hpp"

namespace wrc {

/// How many warnings there are: of profiles and both wheels.
std::size_t warning_count(const SceneResult& result);
/// All of them, those of profiles first, then those of the left and the right wheel; each begins
/// with its source: "wheel profile worn.prw: ", "left: ".
Warnings all_warnings(const SceneResult& result);
} // namespace wrc
