/// The bytes of a profile file as text, and what is certainly no profile file.
///
/// Encodings: UTF-8 and all others of one byte per ASCII character as they are, UTF-16 by its byte
/// order mark or its zero bytes; typographic minus signs and hard spaces become ASCII; an end mark
/// of DOS (0x1A) is dropped. Internal to the readers. Thread rule: pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "measured/reader_lines.hpp"
#include "profile/file_type.hpp"

namespace wrc::reading {

/// Text in UTF-8, without byte order mark; none if the bytes are that already.
std::optional<std::string> decoded(std::string_view bytes);

/// Refuses bytes that begin as a workbook, an archive, a picture, a document, a drawing or data of
/// another program, naming what they are.
void refuse_foreign(std::string_view bytes, const Log& log);

/// A format that the content shows whatever the file is called: Simpack by its sections, MiniProf
/// by its keys.
std::optional<ProfileFormat> format_by_content(std::string_view text);

} // namespace wrc::reading
