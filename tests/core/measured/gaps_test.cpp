// Numbers that are missing are gaps, and a gap where wheel and rail touch is not silent.
#include <gtest/gtest.h>

#include "samples.hpp"

namespace wrc::test::gaps_test {
namespace {

/// Rows of a wheel, each tenth with something in place of its height or lateral.
std::string wheel_rows_with(const std::string& lateral, const std::string& height,
                            const std::string& separator) {
  std::string text;
  std::size_t row = 0;
  for (const Position& point : wheel_points()) {
    ++row;
    const bool is_gap = row % 10 == 3;
    text += is_gap && !lateral.empty() ? (lateral == "empty" ? "" : lateral) : text_of(point[0]);
    text += separator;
    text += is_gap && !height.empty() ? (height == "empty" ? "" : height) : text_of(point[1]);
    text += "\n";
  }
  return text;
}

TEST(Gaps, MissingNumbersAreGaps) {
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  for (const char* separator : {";", ",", "\t", " "})
    for (const char* word : {"NaN", "nan", "#N/A", "#NV", "#VALUE!", "NA", "null", "empty"}) {
      if (separator[0] == ' ' && std::string(word) == "empty")
        continue;
      for (const bool is_height : {true, false}) {
        SCOPED_TRACE(std::string(word) + separator + (is_height ? "height" : "lateral"));
        const std::string text =
            wheel_rows_with(is_height ? "" : word, is_height ? word : "", separator);
        const ReadResult read = read_profile_text(text, ProfileFormat::columns, "a.txt", options);
        EXPECT_EQ(read.measured.size(), 59U);
        EXPECT_TRUE(
            says(read, "7 rows without lateral or height skipped as gaps, first in line 3"));
      }
    }
}

TEST(Gaps, EmptyCellsKeepTheirColumns) {
  std::string text = "y;z;comment;\n";
  std::size_t row = 0;
  for (const Position& point : wheel_points()) {
    ++row;
    text += text_of(point[0]) + ";" + (row == 20 ? "" : text_of(point[1])) + ";" +
            (row % 2 == 0 ? "seen" : "") + ";\n";
  }
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  const ReadResult read = read_profile_text(text, ProfileFormat::columns, "a.csv", options);
  EXPECT_TRUE(says(read, "1 rows without lateral or height skipped as gaps, first in line 21"));
  EXPECT_TRUE(says(read, "lateral is column 1, height column 2"));
  EXPECT_EQ(read.measured.size(), wheel_points().size() - 1);
  EXPECT_LT(distance_at(read.profile.curve, read.measured), 1e-12);
}

/// Rows with a gap in another column have the same number of words: the 5 of "1.1;;5" was a height.
TEST(Gaps, InDifferentColumnsOfRowsAreSeen) {
  std::string text;
  std::size_t row = 0;
  for (const Position& point : wheel_points()) {
    ++row;
    text += text_of(point[0]) + ";" + (row == 20 ? "" : text_of(point[1])) + ";" +
            (row == 20 ? "5" : "") + "\n";
  }
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  const ReadResult read = read_profile_text(text, ProfileFormat::columns, "a.csv", options);
  EXPECT_TRUE(says(read, "1 rows without lateral or height skipped as gaps, first in line 20"));
  EXPECT_EQ(read.measured.size(), wheel_points().size() - 1);
}

TEST(Gaps, OtherFormatsHaveThemToo) {
  const std::string rows = rows_of(wheel_points()) + "61 NaN\n";
  const std::string skipped = "1 rows without lateral or height skipped as gaps";
  EXPECT_TRUE(says(read_profile_text("spline.begin\nunits.len.f = 1000\npoint.begin\n" + rows +
                                         "point.end\nspline.end\n",
                                     ProfileFormat::simpack, "a.prw"),
                   skipped));
  EXPECT_TRUE(says(read_profile_text("ColumnDef=X,Y\n\n" + rows, ProfileFormat::miniprof, "a.whl"),
                   skipped));
}

TEST(Gaps, AHoleUnderTheContactIsAWarningAndAnErrorInStrictMode) {
  std::string text;
  for (double y = -34.0; y <= 34.0; y += 0.5)
    text += text_of(y) + ";" + (y > -3.0 && y < 3.0 ? "#N/A" : text_of(-y * y / 100.0)) + "\n";
  ReadOptions options;
  options.kind = ProfileKind::rail;
  const ReadResult read = read_profile_text(text, ProfileFormat::columns, "a.csv", options);
  ASSERT_EQ(read.profile.warnings.size(), 1U);
  EXPECT_EQ(read.profile.warnings.front().kind, WarningClass::profile_gap);
  EXPECT_TRUE(contains(read.profile.warnings.front().text, "gap of 6.00 mm between"));
  options.strict = true;
  EXPECT_TRUE(contains(refusal_of(text, ProfileFormat::columns, options), "gap of 6.00 mm"));
}

} // namespace
} // namespace wrc::test::gaps_test
