/// Contact patches of a solved scene, as reports and pictures need them.
///
/// Units mm; track frame. Rows of elements go from the track centre to the field side.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// "left.patches.0." and so on.
struct PatchName {
  std::string side;
  int index = 0;
  std::string prefix;
};

/// Those of one side, and those of all sides, in the order of the results.
std::vector<PatchName> patches_of(const Scene& scene, const std::string& side);
std::vector<PatchName> all_patches(const Scene& scene);

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
PatchMesh mesh_of(const Scene& scene, const PatchName& patch);

} // namespace driver
