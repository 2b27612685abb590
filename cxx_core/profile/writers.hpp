/// Writing a profile: two-column text, or Simpack by the extension .prr/.prw.
///
/// Points are equally spaced along the arc, both ends included, with digits that read back as the
/// same doubles. Two-column text keeps the frame of profile.hpp; Simpack files have height
/// downwards and wheel points from the field side to the flange, as that format defines.
/// Units mm. Thread rule: no state; two writers of one path are the caller's to avoid.
#pragma once

#include <filesystem>

#include "profile/profile.hpp"

namespace wrc {

/// Writes points at most `spacing` mm apart. Throws Error(invalid_argument) for a spacing that is
/// not positive or gives more points than the readers accept, for a .prr wheel or a .prw rail and
/// for formats that are only read; Error(file_unreadable) if the file cannot be written.
void write_profile(const Profile& profile, const std::filesystem::path& path, double spacing);

/// Writes the points the profile was drawn through, as two-column text. Read again, without
/// smoothing, they give the same curve. Throws as write_profile.
void write_points(const Profile& profile, const std::filesystem::path& path);

} // namespace wrc
