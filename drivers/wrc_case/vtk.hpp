/// Fields of a solved scene for visualisation programs.
#pragma once

#include <filesystem>

#include "support/scene.hpp"

namespace driver {

/// A legacy VTK unstructured grid: one quadrilateral an element, at its place in the track frame,
/// of all patches of all sides. Values of cells: undeformed_distance, pressure, displacement;
/// `patch` (N of patches.N) and `side` (1 left, -1 right) tell them apart.
void write_vtk(const Scene& scene, const std::filesystem::path& path);

} // namespace driver
