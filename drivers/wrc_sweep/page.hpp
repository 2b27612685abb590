/// A page for a browser that shows the scenes of a study, one at a time, by a slider for each key
/// that varies: profiles, pressures and tractions, forces. One file, which loads nothing.
#pragma once

#include <filesystem>
#include <string>

#include "wrc_sweep/journal.hpp"

namespace driver {

/// What the page shows of a solved scene, as JSON, in mm, N and MPa. The scene's convention is
/// changed meanwhile.
std::string page_text(Scene& scene);

/// Throws Failure for more scenes than a browser holds.
void refuse_large_page(const Study& study);

/// The page of a study with Study::for_page that has been solved. A scene that could not be solved
/// shows why. Throws Failure if the file cannot be written.
void write_page(const Study& study, Journal& journal, const std::filesystem::path& path);

} // namespace driver
