/// Files read whole, of a sensible size and with an end.
#pragma once

#include <cstddef>
#include <string>

namespace driver {

/// The content of a file; `what` names it in failures, for example "scene file". Throws Failure for
/// one that is not there, is no regular file, is larger than `most` bytes, or, as some of the
/// system, would wait for what is still to come.
std::string read_file(const std::string& what, const std::string& path, std::size_t most);

} // namespace driver
