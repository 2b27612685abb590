/// Scene files: TOML tables whose keys are those of the library (wrc_scene_key).
#pragma once

#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// Sets a scene from a file, from the text of one, or from assignments "key=value", in which texts
/// need no quotes. Keys are applied in the library's order, the general before the special
/// (load.vertical before load.left). Profile files named in a scene file are looked up beside it.
/// Throws Failure naming file and line, or key, value and what is allowed.
void apply_scene_file(Scene& scene, const std::string& path);
void apply_scene_text(Scene& scene, const std::string& path, const std::string& text);
void apply_assignments(Scene& scene, const std::vector<std::string>& assignments);

} // namespace driver
