/// Values of other programs that tests compare with, and files in their formats.
///
/// The values are part of the project, in tests/reference, where README.md says what they are and
/// where they come from. Files in the formats of other programs are not: tests of the readers look
/// for them in WRCONTACT_ORIGINAL_FILES_DIR and skip without.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace wrc::test {

/// A file of tests/reference.
std::filesystem::path reference_file(const std::string& name);

/// The content of one in JSON; throws if it is not there or cannot be read.
nlohmann::json reference_data(const std::string& name);

/// The cases of creep_wheel_rail.json, each with all of its inputs.
nlohmann::json creep_wheel_rail_cases();

/// A file in the format of another program, which may not be there.
std::filesystem::path original_file(const std::string& name);

} // namespace wrc::test

/// Skips a test of the readers. The text has no file name in it: scripts/skipped_tests.sh counts
/// tests by their reason.
#define WRC_NEEDS_ORIGINAL(name)                                                                   \
  if (!std::filesystem::exists(wrc::test::original_file(name)))                                    \
  GTEST_SKIP() << "reads a file in another program's own format, which is not part of the "        \
                  "project (WRCONTACT_ORIGINAL_FILES_DIR)"
