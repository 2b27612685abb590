/// The picture of a solved scene: profiles, patches, pressures, tractions and stresses.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// Draws a .png or .svg file. Seen in driving direction: the left wheel is on the left. `warnings`
/// stand below.
void draw_scene(const Scene& scene, const std::filesystem::path& path,
                const std::vector<Warning>& warnings);

} // namespace driver
