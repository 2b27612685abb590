/// Files are written aside and then renamed, so that a fault leaves an old one as it was.
/// Thread rule: two writers of one path are the caller's to avoid.
#pragma once

#include <filesystem>
#include <string>

namespace wrc {

/// Throws Error(file_unreadable) if the file cannot be written.
void write_file(const std::filesystem::path& path, const std::string& content);

} // namespace wrc
