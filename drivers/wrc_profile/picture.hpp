/// The picture of a profile: to scale, with its curvature below.
#pragma once

#include <filesystem>

#include "wrc_profile/measures.hpp"

namespace driver {

/// Draws a .png or .svg file; `other` may be null, or a profile to draw beneath.
void draw_profile(const Profile& profile, const Measures& measures, const Profile* other,
                  const std::filesystem::path& path);

} // namespace driver
