/// Tables of contact forces as files.
///
/// Binary, for machines whose numbers are little-endian: a first line with the format's version,
/// the numbers of the table, and a checksum (FNV-1a of all bytes before) at the end. A file is not
/// trusted: sizes are checked against its length before anything is allocated, and what was changed
/// is refused. Thread rule: two writers of one path are the caller's to avoid.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "table/contact_table.hpp"

namespace wrc {

/// FNV-1a of its bytes.
std::uint64_t checksum_of(std::string_view text);

/// Whether a file of a table can have it: text of one line, 4096 bytes at most.
bool is_name_of_table(std::string_view name);

std::string text_of_table(const ContactTable& table);
/// Throws Error(file_malformed) that says what is wrong.
ContactTable table_from_text(std::string_view text);

/// Throws Error(file_unreadable) if the file cannot be written.
void write_table(const ContactTable& table, const std::filesystem::path& path);
/// Throws Error(file_unreadable) if the file cannot be read, and as table_from_text.
ContactTable read_table(const std::filesystem::path& path);

} // namespace wrc
