/// A scene as a file that wrc_case replays bit for bit.
///
/// TOML, one table for the first part of a key: every key that has a value, in the order of
/// scene_keys, numbers in mm, N, MPa, rad, y left, z up, with digits that read back as the same
/// doubles. Profile files are named with their whole path. Profiles given by hand go into files of
/// their points beside it, "<name>.wheel.txt" and "<name>.rail.txt".
/// Thread rule: two writers of one path are the caller's to avoid.
#pragma once

#include <filesystem>

#include "scene/scene.hpp"

namespace wrc {

/// Throws Error(file_unreadable) if a file cannot be written, and Error(invalid_argument) for a
/// profile given by hand whose points do not read back as they are.
void write_scene(const Scene& scene, const std::filesystem::path& path);

} // namespace wrc
