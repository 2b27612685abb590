/// Checks as a table for people and as JUnit XML for programs.
#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "wrc_regression/check.hpp"

namespace driver {

void print_checks(const std::vector<Check>& checks, std::ostream& out);
void write_junit(const std::vector<Check>& checks, const std::filesystem::path& path);

} // namespace driver
