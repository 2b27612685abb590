/// Study files: scene files in which a key may have a list or a range of values.
///
/// A list [a, b, c], a range {from, to, step} or {from, to, count}; crossed, and the key that
/// stands first in the file varies slowest. The table [study] has name, title, results and fields,
/// and each [[picture]] asks for a picture.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/toml.hpp"
#include "wrc_sweep/study.hpp"

namespace driver {

/// What the command line changes in a study: it counts more than the file.
struct StudyChanges {
  std::vector<std::string> assignments; ///< "key=value"
  std::vector<std::string> wheels; ///< names and files for both wheels; empty: those of the file
  std::vector<std::string> rails;
};

/// Reads a study: a file, or a shipped study by its name. Every value of every key is tried on a
/// scene. Throws Failure naming file, key, value and what is allowed.
Study read_study(const std::string& path, const StudyChanges& changes);

/// Name and purpose of each study that is part of the program.
std::vector<std::pair<std::string, std::string>> shipped_studies();

/// Throws Failure naming key, value and what is allowed.
std::vector<PictureRequest> read_pictures(const toml::table& file, const Study& study);
/// The results that a kind of picture reads, besides those that its panels name.
std::vector<std::string> needed_results(const PictureRequest& picture);

/// A title in which "{track.inclination}" and so on are replaced by the study's values, each as
/// `shown` returns it: of keys that do not vary, and of texts, such as profiles, that do.
std::string with_values(const std::string& text, const Study& study,
                        const std::function<std::string(const std::string&)>& shown);

} // namespace driver
