/// What noise and short waves of measured profiles leave open of a scene that is solved.
///
/// Units mm and MPa, as the scene's convention has to say. Nothing is computed with profiles that
/// are built in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// pmax and area by the wavelength that profiles of points are smoothed with: a row of titles, then
/// two for each side. Empty with profiles that are built in.
std::vector<std::vector<std::string>> smoothing_rows(const Scene& scene);

/// Draws pmax over that wavelength.
void draw_smoothing(const Scene& scene, const std::filesystem::path& path);

/// A warning for each side whose results are more uncertain than the accuracy asks.
std::vector<Warning> spread_warnings(const Scene& scene);

} // namespace driver
