#include "wrc_case/patches.hpp"

#include <cmath>

namespace driver {

std::vector<PatchName> patches_of(const Scene& scene, const std::string& side) {
  std::vector<PatchName> patches;
  const int count = scene.count_of(side + ".patches");
  for (int i = 0; i < count; ++i) {
    patches.push_back({side, i, side + ".patches." + std::to_string(i) + '.'});
  }
  return patches;
}

std::vector<PatchName> all_patches(const Scene& scene) {
  std::vector<PatchName> patches;
  for (const std::string& side : scene.sides()) {
    for (PatchName& patch : patches_of(scene, side)) {
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

Point PatchMesh::corner(std::size_t row, std::size_t column) const {
  Point point = first;
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] +=
        static_cast<double>(row) * lateral[i] + static_cast<double>(column) * longitudinal[i];
  }
  return point;
}

PatchMesh mesh_of(const Scene& scene, const PatchName& patch) {
  const auto number = [&](const char* name) { return scene.number(patch.prefix + name); };
  PatchMesh mesh;
  mesh.rows = static_cast<std::size_t>(number("grid.0"));
  mesh.columns = static_cast<std::size_t>(number("grid.1"));
  // Steps from the element centres; of a single row or column from the plane's angle.
  const double outwards = patch.side == "left" ? 1.0 : -1.0;
  const double angle = number("angle");
  const double width = number("element_size.0");
  mesh.lateral = {0.0, outwards * width * std::cos(angle), outwards * width * std::sin(angle)};
  mesh.longitudinal = {number("element_size.1"), 0.0, 0.0};
  constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<double> centre = scene.field(patch.prefix + names[i]);
    if (mesh.columns > 1) {
      mesh.longitudinal[i] =
          (centre[mesh.columns - 1] - centre[0]) / static_cast<double>(mesh.columns - 1);
    }
    if (mesh.rows > 1) {
      mesh.lateral[i] =
          (centre[(mesh.rows - 1) * mesh.columns] - centre[0]) / static_cast<double>(mesh.rows - 1);
    }
    mesh.first[i] = centre[0] - 0.5 * (mesh.lateral[i] + mesh.longitudinal[i]);
  }
  return mesh;
}

} // namespace driver
