#include "measured/reader_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace wrc::reading {
namespace {

/// Bytes looked at to recognise a format or an encoding (not a tuning constant).
constexpr std::size_t beginning = 4096;

enum class Encoding { bytes, utf16_little, utf16_big };

/// Text of ASCII characters in UTF-16 has a zero in every second byte.
Encoding encoding_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) {
    return Encoding::utf16_little;
  }
  if (bytes.starts_with("\xFE\xFF")) {
    return Encoding::utf16_big;
  }
  std::array<std::size_t, 2> zeros{};
  const std::size_t looked_at = std::min(bytes.size(), beginning);
  for (std::size_t i = 0; i < looked_at; ++i) {
    zeros[i % 2] += bytes[i] == '\0' ? 1U : 0U;
  }
  const std::size_t most = looked_at / 2;
  if (most >= 4 && zeros[0] == 0 && zeros[1] >= most - most / 4) {
    return Encoding::utf16_little;
  }
  if (most >= 4 && zeros[1] == 0 && zeros[0] >= most - most / 4) {
    return Encoding::utf16_big;
  }
  return Encoding::bytes;
}

void add_utf8(std::string& text, std::uint32_t code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | (code >> 6U));
    text += static_cast<char>(0x80U | (code & 0x3FU));
  } else if (code >= 0xD800 && code < 0xE000) {
    text += '?'; // half of a character beyond the first 65536
  } else {
    text += static_cast<char>(0xE0U | (code >> 12U));
    text += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
    text += static_cast<char>(0x80U | (code & 0x3FU));
  }
}

std::string from_utf16(std::string_view bytes, bool little) {
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    add_utf8(text, little ? first + 256U * second : second + 256U * first);
  }
  return text;
}

/// Characters that look like ASCII but are not, and the mark of the byte order.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> lookalikes{{
    {"\xE2\x88\x92", "-"}, // minus sign
    {"\xE2\x80\x93", "-"}, // en dash
    {"\xC2\xA0", " "},     // hard space
    {"\xE2\x80\xAF", " "}, // narrow hard space
    {"\xEF\xBB\xBF", ""},  // byte order mark
}};

std::string with_ascii(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const auto* const found =
        static_cast<unsigned char>(text[i]) < 0x80
            ? lookalikes.end()
            : std::find_if(lookalikes.begin(), lookalikes.end(), [&](const auto& pair) {
                return text.substr(i).starts_with(pair.first);
              });
    if (found == lookalikes.end()) {
      result += text[i++];
    } else {
      result += found->second;
      i += found->first.size();
    }
  }
  return result;
}

struct Signature {
  std::string_view begin;
  std::string_view what;
};

/// First bytes of files of other formats (a table of names, not a tuning constant): the
/// specifications of these formats.
constexpr std::array<Signature, 16> signatures{{
    {"PK\x03\x04", "an Excel workbook (.xlsx) or another ZIP archive"},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "an old Excel workbook (.xls)"},
    {"%PDF", "a PDF document"},
    {"\x89PNG", "a picture"},
    {"\xFF\xD8\xFF", "a picture"},
    {"\x89HDF", "an HDF5 file"},
    {"MATLAB 5.0", "a MATLAB file (.mat)"},
    {"\x1F\x8B", "a compressed file (.gz)"},
    {"7z\xBC\xAF", "a compressed file (.7z)"},
    {"Rar!", "a compressed file (.rar)"},
    {"AutoCAD Binary DXF", "a drawing (.dxf)"},
    {"AC10", "a drawing (.dwg)"},
    {"ISO-10303-21", "a STEP model"},
    {"<", "XML or HTML"},
    {"{\\rtf", "a document (.rtf)"},
    {"{", "JSON"},
}};

bool is_drawing(std::string_view text) { // text DXF: group code 0, then SECTION
  const Words words = words_of(text.substr(0, 64), " \t\r\n");
  return words.count >= 2 && words.word[0] == "0" && words.word[1] == "SECTION";
}

} // namespace

std::optional<std::string> decoded(std::string_view bytes) {
  const Encoding encoding = encoding_of(bytes);
  std::optional<std::string> text;
  if (encoding != Encoding::bytes) {
    text = from_utf16(bytes, encoding == Encoding::utf16_little);
  }
  const std::string_view seen = text ? std::string_view(*text) : bytes;
  const bool ends_with_mark = seen.ends_with('\x1A');
  const bool is_ascii = std::none_of(seen.begin(), seen.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0xE2 || byte == 0xC2 || byte == 0xEF;
  });
  if (!is_ascii) {
    text = with_ascii(seen);
  }
  if (ends_with_mark) {
    if (!text) {
      text = std::string(bytes);
    }
    text->pop_back();
  }
  return text;
}

void refuse_foreign(std::string_view bytes, const Log& log) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const std::string_view begin = first == std::string_view::npos ? "" : bytes.substr(first);
  const auto* found =
      std::find_if(signatures.begin(), signatures.end(),
                   [&](const Signature& each) { return begin.starts_with(each.begin); });
  const bool drawing = is_drawing(begin);
  const std::string what(found == signatures.end() ? "" : found->what);
  const bool is_workbook = what.find("workbook") != std::string::npos;
  if (found != signatures.end() || drawing) {
    log.refuse("is " + (drawing ? "a drawing (.dxf)" : what) + ", which is not supported; " +
               (is_workbook ? "save the sheet with the points as CSV text (in Excel: Save As, CSV; "
                              "in LibreOffice: Save As, Text CSV) and read that file; "
                            : "") +
               "it must be a text file: two columns, Simpack .prr/.prw, "
               "MiniProf .ban/.whl");
  }
}

std::optional<ProfileFormat> format_by_content(std::string_view text) {
  const std::string_view begin = text.substr(0, beginning);
  if (begin.find("spline.begin") != std::string_view::npos) {
    return ProfileFormat::simpack;
  }
  if (begin.find("ColumnDef=") != std::string_view::npos ||
      begin.find("XYPoints=") != std::string_view::npos || begin.starts_with("[Profile") ||
      begin.find("\n[Profile") != std::string_view::npos) {
    return ProfileFormat::miniprof;
  }
  return std::nullopt;
}

} // namespace wrc::reading
