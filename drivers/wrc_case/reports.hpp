/// What wrc_case prints and writes of a solved scene.
#pragma once

#include <filesystem>
#include <ostream>

#include "support/scene.hpp"

namespace driver {

/// A table for people.
void print_table(const Scene& scene, std::ostream& out);
/// The part of it on places that nearly touch at first touch.
void print_near_contacts(const Scene& scene, std::ostream& out);
/// All results as one object.
void print_json(const Scene& scene, std::ostream& out);
/// One line of column names, one line per side.
void print_csv(const Scene& scene, int digits, std::ostream& out);
/// Fields of all patches, a line per element: side, patch (N of patches.N), x, y, z,
/// undeformed_distance, pressure, displacement.
void write_field(const Scene& scene, const std::filesystem::path& path);

/// Tractions and slips, a line per element: side, patch, creep_x, creep_y, creep_z,
/// creep_pressure, traction_x, traction_y, slip_x, slip_y. Throws Failure if there are none.
void write_creep_field(const Scene& scene, const std::filesystem::path& path);

/// A legacy VTK unstructured grid: one quadrilateral per element, at its position in the track
/// frame, of all patches of all sides. Values of cells: undeformed_distance, pressure,
/// displacement; `patch` (N of patches.N) and `side` (1 left, -1 right) distinguish them.
void write_vtk(const Scene& scene, const std::filesystem::path& path);

/// Sections of stresses below the surface as a legacy VTK unstructured grid in the track frame,
/// stresses at its points. Throws Failure if there are none.
void write_stress_vtk(const Scene& scene, const std::filesystem::path& path);

/// A Failure if the wheel's or rail's profile of the one side solved varies along the rail.
void require_one_profile(const Scene& scene, bool wheel);

/// The wheel's or rail's profile of the one side solved, less its groove. Its points are close
/// enough for the groove, and are to be read without smoothing.
void write_grooved_profile(const Scene& scene, bool wheel, const std::filesystem::path& path);
} // namespace driver
