/// What the name of a profile file says of it.
///
/// Thread rule: pure functions.
#pragma once

#include <filesystem>
#include <optional>

#include "profile/profile.hpp"
#include "profile/read_options.hpp"

namespace wrc {

/// What a file's extension says.
struct FileType {
  ProfileFormat format = ProfileFormat::columns;
  std::optional<ProfileKind> kind;
};
FileType type_of(const std::filesystem::path& path);

} // namespace wrc
