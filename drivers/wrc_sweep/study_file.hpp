/// Study files: scene files in which a key may have a list or a range of values.
///
/// A list [a, b, c], a range {from, to, step} or {from, to, count}; crossed, and the key that
/// stands first in the file varies slowest. The table [study] has name, title, results and fields,
/// and each [[picture]] asks for a picture.
#pragma once

#include <string>
#include <vector>

#include "wrc_sweep/study.hpp"

namespace driver {

/// Reads a study; assignments "key=value" of the command line count more than the file. Every value
/// of every key is tried on a scene. Throws Failure naming file, key, value and what is allowed.
Study read_study(const std::string& path, const std::vector<std::string>& assignments);

} // namespace driver
