/// What wrc_case prints, writes and draws of a solved scene.
///
/// Units mm; track frame. Rows of elements go from the track centre to the field side.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "support/json.hpp"
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

/// A table for people.
void print_table(const Scene& scene, std::ostream& out);
/// The part of it on places that nearly touch at first touch.
void print_near_contacts(const Scene& scene, std::ostream& out);
/// All results as one object.
json json_of(const Scene& scene);
/// One line of column names, one line per side.
void print_csv(const Scene& scene, std::ostream& out);
/// Fields of all patches, a line per element: side, patch (N of patches.N), x, y, z,
/// undeformed_distance, pressure, displacement.
void write_field(const Scene& scene, const std::filesystem::path& path);

/// What has fields of its own, a patch or its parts, if it has this result.
std::vector<PatchName> parts_with(const Scene& scene, const std::vector<PatchName>& patches,
                                  const std::string& result);
/// Tractions and slips, a line per element: side, patch, creep_x, creep_y, creep_z,
/// creep_pressure, traction_x, traction_y, slip_x, slip_y. Throws Failure if there are none.
void write_creep_field(const Scene& scene, const std::filesystem::path& path);

/// A legacy VTK unstructured grid: one quadrilateral per element, at its position in the track
/// frame, of all patches of all sides. Values of cells: undeformed_distance, pressure,
/// displacement; `patch` (N of patches.N) and `side` (1 left, -1 right) distinguish them.
void write_vtk(const Scene& scene, const std::filesystem::path& path);

inline constexpr const char* creep_result = "creep_force.longitudinal";
inline constexpr const char* stress_result = "stress.von_mises_max";

/// Sections of stresses below the surface as a legacy VTK unstructured grid in the track frame,
/// stresses at its points. Throws Failure if there are none.
void write_stress_vtk(const Scene& scene, const std::filesystem::path& path);
/// Draws the section with the greatest stress of a side, which has one.
class Gnuplot;
void plot_stress(Gnuplot& gnuplot, const Scene& scene, const std::string& side);
/// Letters beside the colours of a panel, for their numbers and label.
inline constexpr int colour_box_margin = 7;

/// Draws a .png or .svg file. Seen in driving direction: the left wheel is on the left. `warnings`
/// stand below.
void draw_scene(const Scene& scene, const std::filesystem::path& path,
                const std::vector<std::string>& warnings);

} // namespace driver
