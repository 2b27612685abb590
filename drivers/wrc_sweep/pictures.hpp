/// Pictures of a finished study.
#pragma once

#include <filesystem>
#include <vector>

#include "wrc_sweep/picture_data.hpp"

namespace driver {

/// Draws one picture into a folder; returns what it has written: the picture, and for conicity a
/// table too.
std::vector<std::filesystem::path> draw_picture(const PictureRequest& picture,
                                                const PictureData& data,
                                                const std::filesystem::path& folder);

void draw_lines(const PictureRequest& picture, const PictureData& data,
                const std::filesystem::path& path);
void draw_patches(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& path);
void draw_connections(const PictureRequest& picture, const PictureData& data,
                      const std::filesystem::path& path);
/// Also writes what it draws as a table.
void draw_conicity(const PictureRequest& picture, const PictureData& data,
                   const std::filesystem::path& path, const std::filesystem::path& table);

} // namespace driver
