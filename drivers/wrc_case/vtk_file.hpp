/// A legacy VTK file of quadrilaterals, as ParaView reads it.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/output_file.hpp"

namespace driver {

struct VtkGrid {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 4>> quads; ///< corners by their index in `points`
};

/// Written as it comes: the grid at once, then scalars; nothing is there before `commit`.
class VtkFile {
public:
  /// `title`: one line; `of`: what has scalars, "POINT_DATA" or "CELL_DATA".
  VtkFile(const std::filesystem::path& path, const std::string& title, const VtkGrid& grid,
          const std::string& of);
  void add(const std::string& name, const std::vector<double>& values, const char* type = "double");
  void commit() { file_.commit(); }

private:
  OutputFile file_;
};

} // namespace driver
