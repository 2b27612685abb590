/// The report page: Markdown with pictures and tables.
#pragma once

#include <filesystem>
#include <ostream>

namespace driver {

/// Writes the page from the results below a folder: S1002/, LM/ and LMA/ as scripts/paper.sh makes
/// them. Pictures are linked beside it. Throws Failure for a result that is missing.
void write_report(const std::filesystem::path& folder, std::ostream& out);

} // namespace driver
