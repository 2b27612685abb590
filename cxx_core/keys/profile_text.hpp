/// A profile as one text: its name, and options of it behind semicolons,
///
///   worn wheel.txt; smoothing = 5; align_to = S1002
///
/// An option begins at a semicolon with a word and an equal sign behind it, so that names may have
/// blanks, commas, equal signs and other semicolons. Numbers are in the units of the convention.
/// A name comes without the options of the profile before it; a text that begins with an option
/// keeps the profile and its other options. Each option also has a name of its own behind that of
/// the key, "track.rail.smoothing", and so has the profile, "track.rail.file".
/// Thread rule: pure functions.
#pragma once

#include <string>
#include <string_view>

#include "keys/scene_key.hpp"
#include "profile/profile.hpp"

namespace wrc {

/// A key that names a profile of this kind.
struct ProfileKey {
  std::string_view name; ///< for errors
  ProfileKind kind;
};

/// Sets what a text says. Throws Error(invalid_argument) for an option that a profile of this kind
/// does not have, or that is there twice, and for its value.
void set_profile_text(ProfileChoice& choice, std::string_view text, const ProfileKey& key,
                      const Convention& convention);
/// The text that sets this, with the options that are not those by default.
std::string profile_text(const ProfileChoice& choice, const Convention& convention);

/// One option, or "file", in any case; its value is the text as it is. Throws as above.
void set_profile_option(ProfileChoice& choice, std::string_view option, std::string_view value,
                        const ProfileKey& key, const Convention& convention);
/// Its number, or its word.
KeyValue profile_option(const ProfileChoice& choice, std::string_view option, const ProfileKey& key,
                        const Convention& convention);
/// "mm", "rad", or "" if it is a text.
std::string profile_option_unit(std::string_view option, const ProfileKey& key, Units units);

} // namespace wrc
