/// Files read and written whole.
///
/// What is written goes aside and is then renamed, so that a fault leaves an old file as it was;
/// symbolic links are followed, and a file that is replaced leaves its permissions to the new one.
/// A limit of a file's size is a failure and raises no signal. Nothing but memory for texts is
/// allocated, and that as std::bad_alloc.
/// Thread rule: two writers of one path are the caller's to avoid.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace wrc {

/// The content of a regular file of at most `most` bytes. Throws Error(file_unreadable), also for
/// one that would wait for what is still to come, as some of the system do.
std::string read_file(const std::filesystem::path& path, std::size_t most);

/// Throws Error(file_unreadable) if the file cannot be written.
void write_file(const std::filesystem::path& path, const std::string& content);

} // namespace wrc
