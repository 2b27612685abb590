/// The picture of a profile and its curvature, or of its distance to another one.
#pragma once

#include <filesystem>

#include "reports/profile_measures.hpp"
#include "support/scene.hpp"

namespace driver {

/// Draws a .png or .svg file; `other` may be null, or a profile to draw beneath, and the distance
/// to it instead of the curvature.
void draw_profile(const Profile& profile, const Measures& measures, const Profile* other,
                  const std::filesystem::path& path);

} // namespace driver
