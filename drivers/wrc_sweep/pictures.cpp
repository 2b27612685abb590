#include "wrc_sweep/pictures.hpp"

namespace driver {

namespace fs = std::filesystem;

std::vector<fs::path> draw_picture(const PictureRequest& picture, const PictureData& data,
                                   const fs::path& folder) {
  const fs::path path = folder / picture.file;
  switch (picture.kind) {
  case PictureRequest::Kind::lines:
    draw_lines(picture, data, path);
    break;
  case PictureRequest::Kind::patches:
    draw_patches(picture, data, path);
    break;
  case PictureRequest::Kind::connections:
    draw_connections(picture, data, path);
    break;
  case PictureRequest::Kind::conicity: {
    const fs::path table = folder / (path.stem().string() + "_by_amplitude.csv");
    draw_conicity(picture, data, path, table);
    return {path, table};
  }
  }
  return {path};
}

} // namespace driver
