/// The names that a word was probably meant to be.
///
/// Of names in groups, "pose.lateral", groups left out at either end count nothing, and points and
/// underscores are the same letter. Thread rule: a pure function.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wrc {

/// Those that differ least, by letters to insert, drop or replace (Levenshtein 1966), with blanks
/// between them: up to four. Empty if there are no names.
std::string nearest_names(std::string_view word, std::span<const std::string> names);

} // namespace wrc
