/// The paper's statement on time, 8.25 s for 256 x 128 elements, beside times of this machine.
#pragma once

#include <filesystem>
#include <ostream>

namespace driver {

/// Reads timing.json in a folder, as wrc_benchmark --case table1 --grid 256x128 --json prints it;
/// draws timing.png there and writes a section of the report. Throws Failure for a file that cannot
/// be understood.
void write_timing(const std::filesystem::path& folder, std::ostream& out);

} // namespace driver
