/// The picture of a solved scene: profiles in contact and the pressures of each wheel.
#pragma once

#include <filesystem>

#include "support/scene.hpp"

namespace driver {

/// Draws a .png or .svg file. Seen in driving direction: the left wheel is on the left.
void draw_scene(const Scene& scene, const std::filesystem::path& path);

} // namespace driver
