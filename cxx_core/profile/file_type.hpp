/// What the name of a profile file says of it.
///
/// Thread rule: pure functions.
#pragma once

#include <filesystem>
#include <optional>

#include "profile/profile.hpp"

namespace wrc {

enum class ProfileFormat { columns, simpack, miniprof, slices };

/// What a file's extension says.
struct FileType {
  ProfileFormat format = ProfileFormat::columns;
  std::optional<ProfileKind> kind;
};
FileType type_of(const std::filesystem::path& path);

} // namespace wrc
