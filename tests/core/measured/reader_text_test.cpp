// Encodings of profile files, and files that are certainly no profiles.
#include "measured/reader_text.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace wrc::test::reader_text_test {
namespace {

using namespace reading;

std::string utf16(const std::string& text, bool little, bool mark) {
  std::string bytes = mark ? (little ? "\xFF\xFE" : "\xFE\xFF") : "";
  for (const char c : text) {
    bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
  }
  return bytes;
}

TEST(ReaderText, PlainTextIsUnchanged) {
  EXPECT_FALSE(decoded("1.0 2.0\n3.0 4.0\n"));
  EXPECT_FALSE(decoded("# H\xC3\xB6he\n1 2\n")) << "UTF-8";
}

TEST(ReaderText, Utf16IsReadWithAndWithoutItsMark) {
  const std::string text = "# points\n-1.5 2.5\n";
  for (const bool little : {true, false}) {
    for (const bool mark : {true, false}) {
      EXPECT_EQ(decoded(utf16(text, little, mark)), text) << little << mark;
    }
  }
}

TEST(ReaderText, LookalikeCharactersBecomeAscii) {
  EXPECT_EQ(decoded("\xEF\xBB\xBF\xE2\x88\x92"
                    "1.5\xC2\xA0"
                    "2"),
            "-1.5 2");
}

TEST(ReaderText, EndMarkOfDosIsDropped) {
  EXPECT_EQ(decoded("1 2\n\x1A").value_or("1 2\n\x1A").find('\x1A'), std::string::npos);
}

TEST(ReaderText, ForeignFilesAreRefusedByName) {
  const Log log("file.dat", false);
  for (const char* begin : {"PK\x03\x04", "%PDF-1.5", "\x89PNG\r\n"}) {
    expect_error(
        ErrorCode::file_malformed, [&] { refuse_foreign(begin, log); }, "file.dat");
  }
  EXPECT_NO_THROW(refuse_foreign("1.0 2.0\n", log));
}

TEST(ReaderText, ContentShowsTheFormat) {
  EXPECT_EQ(format_by_content("header.begin\nheader.end\nspline.begin\n"), ProfileFormat::simpack);
  EXPECT_EQ(format_by_content("[File]\nColumnDef=X,Y,*\n"), ProfileFormat::miniprof);
  EXPECT_FALSE(format_by_content("1.0 2.0\n3.0 4.0\n"));
}

} // namespace
} // namespace wrc::test::reader_text_test
