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

/// A title with "{track.cant}" and so on replaced by the study's value, of keys that do not vary.
std::string with_values(std::string text, const Study& study);

} // namespace driver
