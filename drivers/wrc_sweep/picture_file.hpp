/// The [[picture]] tables of a study file.
#pragma once

#include <vector>

#include "support/toml.hpp"
#include "wrc_sweep/study.hpp"

namespace driver {

/// Throws Failure naming key, value and what is allowed.
std::vector<PictureRequest> read_pictures(const toml::table& file, const Study& study);
/// The results that a kind of picture reads, besides those that its panels name.
std::vector<std::string> needed_results(const PictureRequest& picture);

} // namespace driver
