/// Units of results and keys, for files and pictures.
#pragma once

#include <string>

namespace driver {

/// "mm", "MPa", "rad", ...; "1" for ratios and counts.
std::string unit_of(const std::string& name);

} // namespace driver
