/// What wrc_case prints and writes of a solved scene.
#pragma once

#include <filesystem>
#include <ostream>

#include "support/scene.hpp"

namespace driver {

/// A table for people.
void print_table(const Scene& scene, std::ostream& out);
/// One JSON object with all results, 17 digits.
void print_json(const Scene& scene, std::ostream& out);
/// One line of column names, one line per side.
void print_csv(const Scene& scene, std::ostream& out);
/// Fields of all patches, a line an element: side, patch (N of patches.N), x, y, z,
/// undeformed_distance, pressure, displacement.
void write_field(const Scene& scene, const std::filesystem::path& path);

} // namespace driver
