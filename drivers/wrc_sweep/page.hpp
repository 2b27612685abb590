/// A page for a browser that shows the scenes of a study, one at a time, by a slider for each key
/// that varies: profiles, pressures and tractions, forces. One file, which loads nothing.
#pragma once

#include <cstdint>
#include <filesystem>

#include "reports/warning_summary.hpp"
#include "wrc_sweep/study.hpp"

namespace driver {

struct PageSummary {
  WarningSummary warnings;
  std::int64_t with_results = 0; ///< scenes that have any
};

/// Solves the scenes on `threads` threads and writes the page. A scene that cannot be solved shows
/// why. Throws Failure for more scenes than a browser holds, or
/// if the file cannot be written.
PageSummary write_page(const Study& study, int threads, const std::filesystem::path& path);

} // namespace driver
