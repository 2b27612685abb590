/// Readers, format by format: grammar, processing, errors.
#include <gtest/gtest.h>

#include "samples.hpp"

namespace wrc::test::reader_formats_test {
namespace {

constexpr double rounding = 1e-12;

ReadResult read_as(ProfileFormat format, const std::string& text, std::string_view name = "sample",
                   const ReadOptions& options = {}) {
  return read_profile_text(text, format, name, options);
}

// Two columns

TEST(ColumnsReader, AcceptsCommentsSeparatorsAndPlusSigns) {
  const ReadResult read = read_as(ProfileFormat::columns,
                                  "\xEF\xBB\xBF# rail\n! old\n% older\n\n"
                                  "-20 -6\r\n-10,-1 # behind a point\r+0;+0.0\n +1e1\t-1 \n20, -6",
                                  "sample.rail");
  EXPECT_TRUE(read.corrections.empty()) << read.corrections.front();
  EXPECT_EQ(read.profile.kind, ProfileKind::rail);
  EXPECT_LT(distance_at(read.profile.curve,
                        {{-20.0, -6.0}, {-10.0, -1.0}, {0.0, 0.0}, {10.0, -1.0}, {20.0, -6.0}}),
            rounding);
}

TEST(ColumnsReader, RefusesWithLineAndText) {
  const auto refusal = [](const std::string& text) {
    return refusal_of(text, ProfileFormat::columns);
  };
  EXPECT_TRUE(contains(refusal("1 2\n3\n"), "sample:2: '3' is one column"));
  EXPECT_TRUE(contains(refusal("1 2\n3 x\n"), "sample:2: 'x' is not a number"));
  EXPECT_TRUE(contains(refusal("1 2\n-inf 3\n"), "sample:2: '-inf' is not a finite number"));
  EXPECT_TRUE(contains(refusal("1 2\n1e999 3\n"), "sample:2: '1e999' is not a finite number"));
  EXPECT_TRUE(contains(refusal("1 2\n1 2 3\n"), "sample:2: 3 columns, the rows before have 2"));
  EXPECT_TRUE(contains(refusal("1,5 2,4\n1,5 2.3,4\n"), "sample:2: '2.3.4' is not a number"));
  EXPECT_TRUE(
      contains(refusal("-20,5,6,1\n0,0,1,5\n"), "sample:1: commas between the numbers and"));
}

TEST(ColumnsReader, ExtraColumnsAreAGuessUnlessAHeadingNamesTwo) {
  std::string rows;
  for (const Position& point : wheel_points())
    rows +=
        text_of(point[0]) + " , " + text_of(point[1]) + " ; " + text_of(point[0] / 3.0) + "\r\n";
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  const ReadResult read = read_as(ProfileFormat::columns, rows, "sample", options);
  EXPECT_TRUE(says(read, "columns 3 ignored"));
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
  options.strict = true;
  EXPECT_TRUE(contains(refusal_of(rows, ProfileFormat::columns, options), "name the columns"));
  const ReadResult named =
      read_as(ProfileFormat::columns, "y z weight\n" + rows, "sample", options);
  EXPECT_TRUE(says(named, "1 lines before the first number skipped as headings, first in line 1"));
  EXPECT_TRUE(says(named, "lateral is column 1, height column 2"));
}

// Simpack

/// A file with given keys in its spline section.
std::string simpack(const std::string& rows, const std::string& keys, int type) {
  return "! comment\n header.begin\n version = 1\n type = " + std::to_string(type) +
         " ! kind\n header.end\n spline.begin\n comment = 'a ! title'\n" + keys +
         "\n point.begin\n! y z\n" + rows + " point.end\n spline.end\nafter the end\n";
}

const std::string millimetres = " units.len.f = +1.0e+03\n";

std::string wheel_rows(const std::function<Position(Position)>& change = {}) {
  return rows_of(wheel_points(), change);
}

TEST(SimpackReader, ReadsAWheel) {
  const ReadResult read =
      read_as(ProfileFormat::simpack, simpack(wheel_rows(), millimetres, 1), "a.prw");
  EXPECT_EQ(read.profile.kind, ProfileKind::wheel);
  EXPECT_EQ(read.profile.title, "a ! title");
  EXPECT_TRUE(read.corrections.empty()) << read.corrections.front();
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
}

TEST(SimpackReader, RailHeightIsDownwardsByTheFormat) {
  const std::string rows = rows_of(rail_points(), [](Position p) { return Position{p[0], -p[1]}; });
  ReadOptions options;
  options.strict = true;
  const ReadResult read =
      read_as(ProfileFormat::simpack, simpack(rows, millimetres, 0), "a.prr", options);
  EXPECT_EQ(read.profile.kind, ProfileKind::rail);
  EXPECT_LT(distance_at(read.profile.curve, rail_points()), rounding);
}

TEST(SimpackReader, HeaderWinsOverTheExtensionAndOptionsOverBoth) {
  const std::string text = simpack(wheel_rows(), millimetres, 1);
  const ReadResult read = read_as(ProfileFormat::simpack, text, "a.prr");
  EXPECT_EQ(read.profile.kind, ProfileKind::wheel);
  EXPECT_TRUE(says(read, "the header says wheel"));
  ReadOptions options;
  options.kind = ProfileKind::rail;
  const ReadResult asked = read_as(ProfileFormat::simpack, text, "a.prw", options);
  EXPECT_EQ(asked.profile.kind, ProfileKind::rail);
  EXPECT_TRUE(says(asked, "read as a rail as requested"));
}

TEST(SimpackReader, AppliesTheKeysInTheirOrder) {
  // Shift before bounds before mirror: bounds hold for shifted, not mirrored values.
  const std::string keys = millimetres +
                           " shift.y = 3\n shift.z = -2\n bound.y.min = -60\n bound.y.max = 40\n"
                           " bound.z.min = -5\n bound.z.max = 100\n mirror.y = 1\n inversion = 1\n";
  // Written so that the result is the sample again where nothing is cut.
  const std::string rows = wheel_rows([](Position p) { return Position{-p[0] - 3.0, p[1] + 2.0}; });
  const ReadResult read = read_as(ProfileFormat::simpack, simpack(rows, keys, 1));
  std::vector<Position> expected;
  for (const Position& point : wheel_points())
    if (-point[0] >= -60.0 && -point[0] <= 40.0)
      expected.push_back({point[0], std::max(point[1], -5.0)});
  EXPECT_LT(expected.size(), wheel_points().size());
  EXPECT_LT(distance_at(read.profile.curve, expected), rounding);
  EXPECT_NEAR(read.profile.curve.at(0.0).lateral, -40.0, rounding);
  EXPECT_TRUE(says(read, "shifted by shift.y = 3, shift.z = -2"));
  EXPECT_TRUE(says(read, "points outside bound.y dropped"));
  EXPECT_TRUE(says(read, "lateral mirrored as mirror.y"));
  EXPECT_TRUE(says(read, "order reversed as inversion"));
}

TEST(SimpackReader, ClipsHeights) {
  const ReadResult read =
      read_as(ProfileFormat::simpack,
              simpack(wheel_rows(), millimetres + " bound.z.min = -2\n bound.z.max = 100\n", 1));
  EXPECT_TRUE(says(read, "10 points clipped to bound.z"));
  std::vector<Position> expected = wheel_points();
  for (Position& point : expected)
    point[1] = std::max(point[1], -2.0);
  EXPECT_LT(distance_at(read.profile.curve, expected), rounding);
}

TEST(SimpackReader, ReversedBoundsAreIgnored) {
  const ReadResult read =
      read_as(ProfileFormat::simpack,
              simpack(wheel_rows(), millimetres + " bound.y.min = 1\n bound.y.max = 0\n", 1));
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
}

TEST(SimpackReader, WithoutUnitsValuesAreMetres) {
  const std::string rows = wheel_rows([](Position p) {
    return Position{p[0] / 1000.0, p[1] / 1000.0};
  });
  const ReadResult read = read_as(ProfileFormat::simpack, simpack(rows, "", 1));
  EXPECT_TRUE(says(read, "multiplied by 1000 to mm"));
  EXPECT_TRUE(says(read, "absent: metres"));
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
}

TEST(SimpackReader, DropsClosePointsAndReportsIgnoredKeys) {
  const std::string keys =
      millimetres + " point.dist.min = 3\n approx.smooth = 0.5\n strange = 1\n";
  std::string rows = wheel_rows();
  rows.insert(rows.find('\n'), "\t2.0"); // a weight
  const ReadResult read = read_as(ProfileFormat::simpack, simpack(rows, keys, 1));
  EXPECT_TRUE(says(read, "points closer than point.dist.min dropped"));
  EXPECT_TRUE(says(read, "approx.smooth = 0.5 ignored"));
  EXPECT_TRUE(says(read, "1 unknown keys ignored"));
  EXPECT_TRUE(says(read, "1 weights other than 1 ignored"));
}

TEST(SimpackReader, DuplicateKeysAreReportedAndRefusedInStrictMode) {
  const std::string keys = millimetres + " mirror.y = 1\n mirror.y = 0\n";
  const ReadResult twice = read_as(ProfileFormat::simpack, simpack(wheel_rows(), keys, 1), "a.prw");
  EXPECT_TRUE(says(twice, "mirror.y occurs again in line "));
  EXPECT_FALSE(says(twice, "lateral mirrored"));
  std::string text = simpack(wheel_rows(), millimetres, 1);
  const std::string end = "point.end";
  text.insert(text.find(end), "point.end\n point.begin\n 62 -3\n");
  const ReadResult joined = read_as(ProfileFormat::simpack, text, "a.prw");
  EXPECT_TRUE(says(joined, "points of several sections joined"));
  EXPECT_EQ(joined.profile.points.size(), wheel_points().size() + 1);
  ReadOptions strict;
  strict.strict = true;
  EXPECT_TRUE(contains(refusal_of(simpack(wheel_rows(), keys, 1), ProfileFormat::simpack, strict),
                       "occurs again"));
  EXPECT_TRUE(contains(refusal_of(text, ProfileFormat::simpack, strict), "several sections"));
}

TEST(SimpackReader, RefusesBrokenFiles) {
  const auto refusal = [](const std::string& text) {
    return refusal_of(text, ProfileFormat::simpack);
  };
  const std::string rows = wheel_rows();
  EXPECT_EQ(refusal(simpack(rows, millimetres, 1)), "accepted");
  EXPECT_TRUE(contains(refusal("header.begin\n"), "section 'header' is not ended"));
  EXPECT_TRUE(contains(refusal("header.begin\nheader.end\n"), "no section 'spline'"));
  EXPECT_TRUE(contains(refusal("header.end\n"), "sample:1: 'header' ends, but no section is open"));
  EXPECT_TRUE(contains(refusal("header.begin\nspline.end\n"),
                       "sample:2: 'spline' ends, but 'header' is open"));
  EXPECT_TRUE(contains(refusal("spline.begin\npoint.begin\n1 2\nspline.end\n"),
                       "sample:4: 'spline' ends, but 'point' is open"));
  EXPECT_TRUE(contains(refusal("what\n"), "sample:1: 'what' is neither"));
  EXPECT_TRUE(contains(refusal("header.begin\ntype = 2\n"), "must be 0 (rail) or 1 (wheel)"));
  EXPECT_TRUE(contains(refusal(simpack("1\n", "", 1)), "1 columns"));
  EXPECT_TRUE(contains(refusal(simpack("1 2 3 4\n", "", 1)), "4 columns"));
  EXPECT_TRUE(contains(refusal(simpack("1 inf\n", "", 1)), "'inf' is not a finite number"));
  EXPECT_TRUE(
      contains(refusal(simpack(rows, "mirror.y = 2\n", 1)), "mirror.y = 2, must be 0 or 1"));
  EXPECT_TRUE(contains(refusal(simpack(rows, "units.len.f = 0\n", 1)), "must be positive"));
  EXPECT_TRUE(contains(refusal(simpack(rows, "shift.y = x\n", 1)), "'x' is not a number"));
  EXPECT_TRUE(
      contains(refusal(simpack("", millimetres, 1)), "sample:13: 'spline' ends without a point"));
  std::string deep;
  for (int i = 0; i < 9; ++i)
    deep += "a.begin\n";
  EXPECT_TRUE(contains(refusal(deep), "sample:9: sections nested deeper than 8"));
}

TEST(SimpackReader, RotationInAGuessedSenseIsReported) {
  const std::string keys = millimetres + " units.ang.f = 57.29577951308232\n rotate = 1.0\n";
  const double angle = 1.0 / 57.29577951308232;
  const std::string rows = wheel_rows([angle](Position p) {
    return Position{std::cos(angle) * p[0] + std::sin(angle) * p[1],
                    std::cos(angle) * p[1] - std::sin(angle) * p[0]};
  });
  const ReadResult read = read_as(ProfileFormat::simpack, simpack(rows, keys, 1), "a.prw");
  EXPECT_TRUE(says(read, "from y towards z"));
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), 1e-9); // of the angle's digits
  ReadOptions strict;
  strict.strict = true;
  EXPECT_TRUE(
      contains(refusal_of(simpack(rows, keys, 1), ProfileFormat::simpack, strict), "rotate = 0"));
}

TEST(SimpackReader, SignsThatTheFormatStatesAreNotOverruledByTheShape) {
  std::vector<Position> convex;
  for (double y = -50.0; y <= 50.0; y += 0.5)
    convex.push_back({y, std::sqrt(1e4 - y * y) - 100.0});
  const ReadResult wheel =
      read_as(ProfileFormat::simpack, simpack(rows_of(convex), millimetres, 1), "a.prw");
  EXPECT_LT(distance_at(wheel.profile.curve, convex), rounding);
  EXPECT_TRUE(wheel.profile.warnings.empty());
  EXPECT_TRUE(
      says(wheel, "a disc without flange or rail head, 100.00 mm wide, a circle of radius"));
  const ReadResult down =
      read_as(ProfileFormat::simpack, simpack(rows_of(rail_points()), millimetres, 0), "a.prr");
  EXPECT_LT(distance_at(down.profile.curve, rail_points()), 100.0);
  EXPECT_GT(down.profile.curve.at(0.0).height, 10.0) << "must stay upside down";
  ASSERT_FALSE(down.profile.warnings.empty());
  EXPECT_TRUE(contains(down.profile.warnings.front().text, "the head points down"));
}

TEST(SimpackReader, ReadsTheNamedUnitOfOldFiles) {
  const ReadResult read =
      read_as(ProfileFormat::simpack, simpack(wheel_rows(), " units.len = mm\n", 1), "a.prw");
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
  EXPECT_TRUE(
      contains(refusal_of(simpack(wheel_rows(), " units.len = feet\n", 1), ProfileFormat::simpack),
               "units.len = feet, must be m, cm or mm"));
}

// MiniProf

/// Rail points as MiniProf has them: gauge side to the right, height upwards.
std::string miniprof_rows() {
  return rows_of(rail_points(), [](Position p) { return Position{-p[0], p[1]}; });
}

TEST(MiniprofReader, ReadsARailInNativeSigns) {
  ReadOptions options;
  options.strict = true;
  const ReadResult read = read_as(
      ProfileFormat::miniprof, "Filename=a\nColumnDef=X,Y\n\n" + miniprof_rows(), "a.ban", options);
  EXPECT_EQ(read.profile.kind, ProfileKind::rail);
  EXPECT_TRUE(says(read, "lateral mirrored, the format"));
  EXPECT_LT(distance_at(read.profile.curve, rail_points()), rounding);
}

/// A wheel as MiniProf has it: X from the flange back, 1 mm before the first point.
std::string miniprof_wheel(const std::string& header = "ColumnDef=X,Y\n\n") {
  return header + wheel_rows([](Position p) { return Position{p[0] + 71.0, p[1]}; });
}

/// The sample with its flange back 71 mm from the origin, and the taping line so far from it.
std::vector<Position> wheel_points_from(double tape_offset) {
  std::vector<Position> points = wheel_points();
  for (Position& point : points)
    point[0] += 71.0 - tape_offset;
  return points;
}

TEST(MiniprofReader, ReadsAWheelInNativeSigns) {
  ReadOptions options;
  options.strict = true;
  const ReadResult read = read_as(ProfileFormat::miniprof, miniprof_wheel(), "a.whl", options);
  EXPECT_EQ(read.profile.kind, ProfileKind::wheel);
  EXPECT_TRUE(says(read, "lateral counted from the flange back, where it begins at 1.00 mm"));
  // The sample is straight there: its height is that of the line.
  std::vector<Position> expected = wheel_points_from(70.0);
  for (Position& point : expected)
    point[1] -= 1.0 / 20.0;
  EXPECT_NEAR(read.profile.curve.at(0.0).lateral, -69.0, rounding);
  EXPECT_LT(distance_at(read.profile.curve, expected), 1e-6);
}

TEST(MiniprofReader, TakesTheTapingLineOfTheHeaderOrTheOptions) {
  const std::string text = miniprof_wheel("WheelDiameterTaperline=65.0\nColumnDef=X,Y\n\n");
  const ReadResult read = read_as(ProfileFormat::miniprof, text, "a.whl");
  EXPECT_NEAR(read.profile.curve.at(0.0).lateral, -64.0, rounding);
  ReadOptions options;
  options.tape_offset = 71.0;
  const ReadResult stated = read_as(ProfileFormat::miniprof, text, "a.whl", options);
  EXPECT_LT(distance_at(stated.profile.curve, wheel_points()), 1e-9);
  options = {};
  options.origin = WheelOrigin::tape;
  const ReadResult kept = read_as(ProfileFormat::miniprof, text, "a.whl", options);
  EXPECT_NEAR(kept.profile.curve.at(0.0).lateral, 1.0, rounding);
  EXPECT_TRUE(std::ranges::any_of(kept.profile.warnings, [](const Warning& warning) {
    return contains(warning.text, "the taping line, at 0, is not inside");
  }));
}

TEST(MiniprofReader, RailsOfTheInstrumentsOwnProgramAreHalfTurned) {
  ReadOptions options;
  options.strict = true;
  const std::string rows = rows_of(rail_points(), [](Position p) { return Position{p[0], -p[1]}; });
  const ReadResult read =
      read_as(ProfileFormat::miniprof, "ProgramName=MiniProf for Windows\nColumnDef=X,Y\n" + rows,
              "a.ban", options);
  EXPECT_LT(distance_at(read.profile.curve, rail_points()), rounding);
}

TEST(MiniprofReader, TakesColumnsOffsetsQuotesAndOldHeaders) {
  std::string rows;
  for (const Position& point : rail_points())
    rows += "0.1 " + text_of(point[1] - 2.0) + " 0 " + text_of(-point[0] - 1.0) + "\n";
  const ReadResult read = read_as(
      ProfileFormat::miniprof,
      "old free text\nColumnDef=\"A,Y,C,X\"\n\"XOffset\"=1\nYOffset=2.0\nGauge=1435\n\n" + rows,
      "a.ban");
  EXPECT_TRUE(says(read, "XOffset and YOffset added"));
  EXPECT_LT(distance_at(read.profile.curve, rail_points()), rounding);
}

TEST(MiniprofReader, ReportsSkippedRows) {
  const ReadResult read =
      read_as(ProfileFormat::miniprof,
              "ColumnDef=X,Y\nXYPoints=99\n\n\" 1 2\n7\n" + miniprof_rows() + "! 3 4\n", "a.ban");
  EXPECT_TRUE(says(read, "2 rows after the header skipped as comments, first in line 4"));
  EXPECT_TRUE(says(read, "1 rows with fewer columns than ColumnDef skipped, first in line 5"));
  EXPECT_TRUE(says(read, "XYPoints in the header differs from the 35 points found"));
}

TEST(MiniprofReader, IgnoredColumnsAndDuplicateKeysAreReported) {
  std::string rows;
  for (const Position& point : rail_points())
    rows += text_of(-point[0]) + " " + text_of(point[1]) + " 0.1 7\n";
  const ReadResult named =
      read_as(ProfileFormat::miniprof, "ColumnDef=X,Y,A,N\n\n" + rows, "a.ban");
  EXPECT_TRUE(says(named, "columns ignored: A, N"));
  const std::string unnamed = "ColumnDef=X,Y\n\n" + rows;
  const ReadResult read = read_as(ProfileFormat::miniprof, unnamed, "a.ban");
  EXPECT_TRUE(says(read, "35 rows have more columns than X and Y, which were ignored, first in "
                         "line 3"));
  const std::string twice = "XOffset=1\nXOffset=0\n\n" + miniprof_rows();
  EXPECT_TRUE(says(read_as(ProfileFormat::miniprof, twice, "a.ban"),
                   "XOffset occurs again in line 2 with another value, the last one is used"));
  ReadOptions strict;
  strict.strict = true;
  const std::string quoted = "\"XOffset=1\"\nXOffset=0\nXYPoints=35\nXYPoints=35\n\n";
  EXPECT_NO_THROW(
      (void)read_as(ProfileFormat::miniprof, quoted + miniprof_rows(), "a.ban", strict));
  EXPECT_TRUE(contains(refusal_of(twice, ProfileFormat::miniprof, strict), "occurs again"));
}

TEST(MiniprofReader, RefusesBrokenFiles) {
  const auto refusal = [](const std::string& text) {
    return refusal_of(text, ProfileFormat::miniprof);
  };
  EXPECT_TRUE(
      contains(refusal("ColumnDef=X,Y\n1 2\n"), "1 points, the last in line 2, at least 5"));
  EXPECT_TRUE(contains(refusal("ColumnDef=X,Y\n\n\n"), "sample:3: the file ends without a row"));
  EXPECT_TRUE(
      contains(refusal("ColumnDef=X\n\n1 2\n"), "sample:1: ColumnDef=X, it must name X and Y"));
  EXPECT_TRUE(
      contains(refusal("ColumnDef=X,Y\nXOffset=a\n\n1 2\n"), "sample:2: 'a' is not a number"));
  EXPECT_TRUE(contains(refusal("XYPoints=1e18\n\n1 2\n"), "1 points"));
  EXPECT_TRUE(contains(refusal("a\n\n1 inf\n"), "sample:3: 'inf' is not a finite number"));
}

/// Two profiles with a key for each point, a third with plain rows.
std::string miniprof_project(int profiles) {
  std::string text = "[MiniProf]\nProgramVer=3\nColumnDef=X,Y\n";
  for (int profile = 1; profile <= profiles; ++profile) {
    const std::string name = "Profile" + std::to_string(profile);
    text += "[" + name + "]\nXOffset=" + std::to_string(profile) + "\n[" + name +
            "Points]\nXYPoints=35\n";
    std::size_t row = 0;
    for (const Position& point : rail_points()) {
      if (profile < 3)
        text += "XYPoint" + std::to_string(++row) + "=";
      text += text_of(-point[0] - profile) + "," + text_of(point[1] - 0.1 * profile) + "\n";
    }
  }
  return text;
}

TEST(MiniprofReader, ReadsTheProfilesOfAProjectFile) {
  ReadOptions options;
  options.kind = ProfileKind::rail;
  for (int profile = 1; profile <= 3; ++profile) {
    options.slice = profile;
    const ReadResult read = read_as(ProfileFormat::miniprof, miniprof_project(3), "a.mpt", options);
    std::vector<Position> expected = rail_points();
    for (Position& point : expected)
      point[1] -= 0.1 * profile;
    EXPECT_LT(distance_at(read.profile.curve, expected), rounding) << profile;
    EXPECT_TRUE(says(read, "points of the section [Profile" + std::to_string(profile) + "Points]"));
    EXPECT_EQ(read.measured.size(), 35U);
  }
  options.slice = 0;
  EXPECT_NO_THROW((void)read_as(ProfileFormat::miniprof, miniprof_project(1), "a.mpt", options));
  EXPECT_TRUE(contains(
      refusal_of(miniprof_project(2), ProfileFormat::miniprof, options),
      "slice = 0, must be between 1 and 2 of its 2 profiles: 1 [Profile1Points] of 35 points, "
      "2 [Profile2Points] of 35 points"));
  options.slice = 4;
  EXPECT_TRUE(contains(refusal_of(miniprof_project(3), ProfileFormat::miniprof, options),
                       "slice = 4, must be between 1 and 3"));
}

TEST(MiniprofReader, SectionsSayWhichBodyTheyAre) {
  std::string text = miniprof_project(1);
  text.replace(text.find("[Profile1Points]"), 16, "[Rail1Points]");
  EXPECT_EQ(read_as(ProfileFormat::miniprof, text, "a").profile.kind, ProfileKind::rail);
}

} // namespace
} // namespace wrc::test::reader_formats_test
