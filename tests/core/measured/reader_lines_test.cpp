// Lines, words and numbers of untrusted text.
#include "measured/reader_lines.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/lower_case.hpp"
#include "support/errors.hpp"

namespace wrc::test::reader_lines_test {
namespace {

using namespace reading;

std::vector<std::string> lines_of(std::string_view text) {
  const Log log("file", false);
  Lines lines(text, log);
  std::vector<std::string> all;
  while (lines.next()) {
    all.emplace_back(lines.text());
    EXPECT_EQ(lines.number(), all.size());
  }
  return all;
}

TEST(ReaderLines, EveryEndOfALineCounts) {
  const std::vector<std::string> expected{"a", "b c", "", "e"};
  EXPECT_EQ(lines_of("a\nb c\n\ne"), expected);
  EXPECT_EQ(lines_of("a\r\n  b c \r\n\r\ne\r\n"), expected);
  EXPECT_EQ(lines_of("a\rb c\r\re\r"), expected);
}

TEST(ReaderLines, ControlCharactersAreRefusedWithTheirLine) {
  expect_error(
      ErrorCode::file_malformed, [] { lines_of("a\nb\x01"); }, "file:2");
  expect_error(
      ErrorCode::file_malformed, [] { lines_of(std::string(100000, 'a')); }, "file:1");
}

TEST(ReaderLines, NumbersDoNotDependOnNotation) {
  EXPECT_EQ(number_of("-12.5"), -12.5);
  EXPECT_EQ(number_of("+1.25E2"), 125.0);
  EXPECT_EQ(number_of("1.25D+02"), 125.0);
  EXPECT_EQ(number_of("1.25d-1"), 0.125);
  EXPECT_EQ(number_of("0.12345-102"), 0.12345e-102);
  EXPECT_EQ(number_of("-0.5+101"), -0.5e101);
  for (const char* word :
       {"", "1,5", "12a", "e5", "--1", "0x10", "0.5-12", "1.5--102", "12-101", "1.5-1.2"}) {
    EXPECT_FALSE(number_of(word)) << word;
  }
  const Log log("file", false);
  EXPECT_EQ(finite_number("2.5", 7, log), 2.5);
  expect_error(
      ErrorCode::file_malformed, [&] { finite_number("nan", 7, log); }, "file:7", "nan");
  expect_error(
      ErrorCode::file_malformed, [&] { finite_number("1e999", 7, log); }, "file:7");
}

TEST(ReaderLines, SeparatorsAreNormalised) {
  const auto numbers_of = [](std::string_view line) {
    std::vector<double> numbers;
    const std::string row = plain_row(line);
    const Words words = words_of(row, " ");
    for (std::size_t i = 0; i < words.count; ++i) {
      numbers.push_back(number_of(words.word[i]).value_or(std::nan("")));
    }
    return numbers;
  };
  const std::vector<double> expected{1.5, -2.25};
  EXPECT_EQ(numbers_of("1.5 -2.25"), expected);
  EXPECT_EQ(numbers_of("1.5,-2.25"), expected);
  EXPECT_EQ(numbers_of("1,5;-2,25"), expected);
  EXPECT_EQ(numbers_of("1,5\t-2,25"), expected);
  EXPECT_EQ(numbers_of("\"1.5\" , \"-2.25\""), expected);
}

TEST(ReaderLines, WordsAreCountedBeyondThoseKept) {
  std::string line;
  for (int i = 0; i < 20; ++i) {
    line += " w" + std::to_string(i);
  }
  const Words words = words_of(line, " ");
  EXPECT_EQ(words.count, 20U);
  EXPECT_EQ(words.word.front(), "w0");
  EXPECT_EQ(words.word.back(), "w15");
}

TEST(ReaderLines, TextsAreTrimmedLoweredAndPrintable) {
  EXPECT_EQ(trimmed(" \t a b \t"), "a b");
  EXPECT_EQ(trimmed("  "), "");
  EXPECT_EQ(lower_case("Rail 60E1"), "rail 60e1");
  EXPECT_EQ(printable("a\x07z").find('\x07'), std::string::npos);
  EXPECT_LT(printable(std::string(1000, 'a')).size(), 100U);
}

TEST(ReaderLines, GuessesAndWarningsAreErrorsInStrictMode) {
  Log log("file", false);
  log.note("moved");
  log.guess("mirrored", "state the sign");
  log.warn(WarningClass::profile_gap, "a gap");
  log.advise(WarningClass::profile_noise, "scatter");
  EXPECT_EQ(log.corrections().size(), 2U);
  EXPECT_EQ(log.guesses(), 1U);
  ASSERT_EQ(log.warnings().size(), 2U);
  EXPECT_EQ(log.warnings()[1].kind, WarningClass::profile_noise);
  Log strict("file", true);
  strict.note("moved");
  strict.advise(WarningClass::profile_noise, "scatter");
  expect_error(
      ErrorCode::file_malformed, [&] { strict.guess("mirrored", "state the sign"); }, "file",
      "mirrored", "state the sign");
  expect_error(
      ErrorCode::file_malformed, [&] { strict.warn(WarningClass::profile_gap, "a gap"); }, "a gap");
}

TEST(ReaderLines, LinesOfOneKindAreCounted) {
  LineCount count;
  count.add(4);
  count.add(9);
  EXPECT_EQ(count.text("comments"), "2 comments, first in line 4");
}

} // namespace
} // namespace wrc::test::reader_lines_test
