#include "wrc_case/reports.hpp"

#include <array>
#include <cmath>

#include "reports/patches.hpp"
#include "wrc_case/vtk_file.hpp"

namespace driver {
namespace {

using Point = std::array<double, 3>;

/// Where the elements of a patch lie: corner(i, j) = first + i lateral + j longitudinal.
struct PatchMesh {
  std::size_t rows = 0;
  std::size_t columns = 0;
  Point first{}; ///< outer corner of the first element
  Point lateral{};
  Point longitudinal{};

  [[nodiscard]] Point corner(std::size_t row, std::size_t column) const;
};

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
  mesh.rows = static_cast<std::size_t>(number("grid.lateral"));
  mesh.columns = static_cast<std::size_t>(number("grid.longitudinal"));
  // Steps from the element centres; of a single row or column from the plane's angle.
  const double outwards = patch.side == "left" ? 1.0 : -1.0;
  const double angle = number("plane_angle");
  const double width = number("element_size.lateral");
  mesh.lateral = {0.0, outwards * width * std::cos(angle), outwards * width * std::sin(angle)};
  mesh.longitudinal = {number("element_size.longitudinal"), 0.0, 0.0};
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

void append(std::vector<double>& values, const std::vector<double>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

} // namespace

void write_vtk(const Scene& scene, const std::filesystem::path& path) {
  constexpr std::array names{"undeformed_distance", "row_scale", "pressure", "displacement"};
  VtkGrid grid;
  std::array<std::vector<double>, names.size()> fields;
  std::vector<double> indices;
  std::vector<double> sides;
  for (const PatchName& patch : all_patches(scene)) {
    const PatchMesh mesh = mesh_of(scene, patch);
    const std::size_t offset = grid.points.size();
    const std::size_t length = mesh.columns + 1;
    for (std::size_t row = 0; row <= mesh.rows; ++row) {
      for (std::size_t column = 0; column <= mesh.columns; ++column) {
        grid.points.push_back(mesh.corner(row, column));
        if (row < mesh.rows && column < mesh.columns) {
          const std::size_t corner = offset + row * length + column;
          grid.quads.push_back({corner, corner + 1, corner + length + 1, corner + length});
        }
      }
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      append(fields[i], scene.field(patch.prefix + names[i]));
    }
    indices.resize(grid.quads.size(), patch.index);
    sides.resize(grid.quads.size(), patch.side == "left" ? 1.0 : -1.0);
  }
  VtkFile file(path, "wrcontact: x y z in mm (track frame), pressure in MPa", grid, "CELL_DATA");
  for (std::size_t i = 0; i < names.size(); ++i) {
    file.add(names[i], fields[i]);
  }
  file.add("patch", indices, "int");
  file.add("side", sides, "int");
  file.commit();
}

} // namespace driver
