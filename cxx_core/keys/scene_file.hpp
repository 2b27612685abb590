/// A scene as a file that wrc_case replays bit for bit.
///
/// TOML, one table for the first part of a key: every key that has a value, in the order of
/// scene_keys, numbers in mm, N, MPa, rad, y left, z up, with digits that read back as the same
/// doubles. Profile files are named with their full path. Profiles given by the program go into
/// files of their points beside it, "<name>.wheel.txt" and "<name>.rail.txt". Thread rule: the
/// caller must not write one path from two threads.
#pragma once

#include <filesystem>
#include <string>

#include "keys/scene.hpp"

namespace wrc {

/// The text of such a file, profiles as the scene names them.
std::string scene_text(const Scene& scene);
/// Throws Error(file_unreadable) if a file cannot be written, and Error(invalid_argument) for a
/// profile given by the program whose points would not read back unchanged.
void write_scene(const Scene& scene, const std::filesystem::path& path);

} // namespace wrc
