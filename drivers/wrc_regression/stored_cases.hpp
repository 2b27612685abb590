/// Cases in files: scenes with expected values and named tolerances, and own baselines.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "wrc_regression/check.hpp"

namespace driver {

/// Solves the cases of a file. Cases of the group "own" take what they expect from the baselines.
/// Throws Failure for a file that cannot be understood.
std::vector<Check> run_stored_cases(const std::filesystem::path& cases,
                                    const std::filesystem::path& baselines);

/// Writes the actual values of all own checks as the new baselines; returns a line for each value
/// that has changed. Throws Failure, and writes nothing, if one of them has no value.
std::vector<std::string> update_baselines(const std::vector<Check>& checks,
                                          const std::filesystem::path& baselines);

} // namespace driver
