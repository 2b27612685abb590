#include "wrc_case/vtk_file.hpp"

namespace driver {

VtkFile::VtkFile(const std::filesystem::path& path, const std::string& title, const VtkGrid& grid,
                 const std::string& of)
    : file_(path) {
  std::ofstream& out = file_.stream();
  out << "# vtk DataFile Version 3.0\n"
      << title << "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << grid.points.size()
      << " double\n";
  for (const auto& point : grid.points) {
    out << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  }
  out << "CELLS " << grid.quads.size() << ' ' << 5 * grid.quads.size() << '\n';
  for (const auto& quad : grid.quads) {
    out << "4 " << quad[0] << ' ' << quad[1] << ' ' << quad[2] << ' ' << quad[3] << '\n';
  }
  out << "CELL_TYPES " << grid.quads.size() << '\n';
  for (std::size_t i = 0; i < grid.quads.size(); ++i) {
    out << "9\n";
  }
  out << of << ' ' << (of == "POINT_DATA" ? grid.points.size() : grid.quads.size()) << '\n';
}

void VtkFile::add(const std::string& name, const std::vector<double>& values, const char* type) {
  std::ofstream& out = file_.stream();
  out << "SCALARS " << name << ' ' << type << " 1\nLOOKUP_TABLE default\n";
  for (const double value : values) {
    out << value << '\n';
  }
}

} // namespace driver
