/// The checksum by which a reader knows a file again.
#pragma once

#include <string>

namespace driver {

/// As sha256sum prints it. `name` is for the failure.
std::string sha256_of(const std::string& name, const std::string& content);

} // namespace driver
