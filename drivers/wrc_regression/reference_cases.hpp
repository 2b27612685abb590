/// Cases that are no scene file: closed forms, and values of the program CONTACT.
#pragma once

#include <filesystem>
#include <vector>

#include "wrc_regression/check.hpp"

namespace driver {

/// Hertz (1882): a sphere on a half-space, in closed form, by wrc_normal.
std::vector<Check> run_hertz_cases();
/// Wheel/rail cases of a JSON file as the reference folder has them (see tests/README.md). Throws
/// Failure if it cannot be understood.
std::vector<Check> run_contact_cases(const std::filesystem::path& file);

} // namespace driver
