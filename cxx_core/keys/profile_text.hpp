/// A profile as one text: its name, and options of it behind semicolons,
///
///   worn wheel.txt; smoothing = 5; align_to = S1002
///
/// An option begins at a semicolon with a word and an equal sign behind it, so that names may have
/// blanks, equal signs and other semicolons. Numbers are in the units of the convention. A text
/// that begins with an option keeps the profile and replaces its options.
/// Thread rule: pure functions.
#pragma once

#include <string>
#include <string_view>

#include "keys/convention.hpp"
#include "keys/scene.hpp"
#include "profile/profile.hpp"

namespace wrc {

/// Name and options that a text says; `key` is named in errors. Throws Error(invalid_argument) for
/// an option that a profile of this kind does not have, and for its value.
ProfileChoice profile_choice(std::string_view text, ProfileKind kind, std::string_view key,
                             const Convention& convention);
/// The text that sets this, with the options that are not those by default.
std::string profile_text(const ProfileChoice& choice, const Convention& convention);

} // namespace wrc
