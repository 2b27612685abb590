/// Readers, the common part: orientation, units, limits, options, files.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <random>
#include <sstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "measured/plausibility.hpp"
#include "measured/read_options.hpp"
#include "profile/limits.hpp"
#include "profile/profile.hpp"
#include "samples.hpp"
#include "support/errors.hpp"

namespace wrc::test::readers_test {
namespace {

/// Nodes are the points themselves; only the curve's arithmetic rounds.
constexpr double rounding = 1e-12;

ReadOptions wheel_options() {
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  return options;
}

ReadOptions rail_options() {
  ReadOptions options;
  options.kind = ProfileKind::rail;
  return options;
}

ReadResult read_rows(const std::string& rows, const ReadOptions& options) {
  return read_profile_text(rows, ProfileFormat::columns, "sample", options);
}

void expect_refused(const std::string& text, const char* part) {
  EXPECT_TRUE(contains(refusal_of(text, ProfileFormat::columns), part)) << part;
}

TEST(Readers, PointsInTheFrameAreUnchanged) {
  const ReadResult read = read_rows(rows_of(wheel_points()), wheel_options());
  EXPECT_TRUE(read.corrections.empty()) << read.corrections.front();
  EXPECT_EQ(read.profile.name, "sample");
  EXPECT_EQ(read.profile.kind, ProfileKind::wheel);
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
  EXPECT_DOUBLE_EQ(read.profile.curve.at(0.0).lateral, -70.0);
}

TEST(Readers, EveryOrientationOfAWheelComesOutTheSame) {
  for (const double lateral : {1.0, -1.0})
    for (const double height : {1.0, -1.0})
      for (const bool reversed : {false, true}) {
        std::vector<Position> points = wheel_points();
        if (reversed)
          std::reverse(points.begin(), points.end());
        const ReadResult read = read_rows(rows_of(points, lateral, height), wheel_options());
        EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
        EXPECT_DOUBLE_EQ(read.profile.curve.at(0.0).lateral, -70.0);
        EXPECT_EQ(says(read, "lateral mirrored"), lateral < 0.0);
        EXPECT_EQ(says(read, "height mirrored"), height < 0.0);
        EXPECT_EQ(says(read, "order reversed"), reversed);
      }
}

TEST(Readers, RailComesOutWithHeightUpAndItsLateralSignKept) {
  for (const double height : {1.0, -1.0}) {
    const ReadResult read = read_rows(rows_of(rail_points(), 1.0, height), rail_options());
    EXPECT_LT(distance_at(read.profile.curve, rail_points()), rounding);
    EXPECT_EQ(says(read, "height mirrored"), height < 0.0);
    EXPECT_FALSE(says(read, "lateral"));
  }
}

TEST(Readers, HalfARailHeadIsRecognisedAsUpright) {
  std::vector<Position> points = rail_points();
  std::erase_if(points, [](const Position& p) { return p[0] > 0.0; });
  const ReadResult read = read_rows(rows_of(points, 1.0, -1.0), rail_options());
  EXPECT_LT(distance_at(read.profile.curve, points), rounding);
}

TEST(Readers, StatedMirrorsReplaceTheCheckOfTheShape) {
  ReadOptions options = rail_options();
  options.mirror_lateral = true;
  options.mirror_height = false;
  const ReadResult read = read_rows(rows_of(rail_points(), -1.0, -1.0), options);
  EXPECT_TRUE(says(read, "lateral mirrored as requested"));
  EXPECT_LT(read.profile.curve.at(0.0).lateral, 0.0);
  EXPECT_GT(read.profile.curve.at(0.0).height, 10.0) << "height must stay upside down";
}

TEST(Readers, StrictReadingRefusesGuesses) {
  ReadOptions options = wheel_options();
  options.strict = true;
  EXPECT_EQ(refusal_of(rows_of(wheel_points()), ProfileFormat::columns, options), "accepted");
  EXPECT_TRUE(
      contains(refusal_of(rows_of(wheel_points(), 1.0, -1.0), ProfileFormat::columns, options),
               "state mirror_height"));
  EXPECT_TRUE(
      contains(refusal_of(rows_of(wheel_points(), 1e-3, 1e-3), ProfileFormat::columns, options),
               "state the scale"));
  options.kind.reset();
  EXPECT_TRUE(contains(refusal_of(rows_of(wheel_points()), ProfileFormat::columns, options),
                       "state the kind"));
}

TEST(Readers, KindIsGuessedFromTheShape) {
  const ReadResult wheel = read_rows(rows_of(wheel_points()), {});
  EXPECT_EQ(wheel.profile.kind, ProfileKind::wheel);
  EXPECT_TRUE(says(wheel, "treated as a wheel"));
  const ReadResult rail = read_rows(rows_of(rail_points()), {});
  EXPECT_EQ(rail.profile.kind, ProfileKind::rail);
  EXPECT_TRUE(says(rail, "treated as a rail"));
}

TEST(Readers, UnitsAreGuessedAndReported) {
  for (const double unit : {1e-3, 1e3}) {
    const ReadResult read = read_rows(rows_of(wheel_points(), unit, unit), wheel_options());
    EXPECT_TRUE(says(read, "multiplied by"));
    EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
  }
}

TEST(Readers, StatedScaleSwitchesTheGuessOff) {
  ReadOptions options = wheel_options();
  options.scale = 25.4;
  const ReadResult read = read_rows(rows_of(wheel_points(), 1.0 / 25.4, 1.0 / 25.4), options);
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
  options.scale = 2.0;
  EXPECT_TRUE(
      contains(refusal_of(rows_of(wheel_points(), 1e-3, 1e-3), ProfileFormat::columns, options),
               "mm long in total"));
  options.scale = 1.0; // stated: no guess, though the file is in metres
  EXPECT_TRUE(
      contains(refusal_of(rows_of(wheel_points(), 1e-3, 1e-3), ProfileFormat::columns, options),
               "mm long in total"));
}

std::vector<Position> points_every(const char* name, double spacing) {
  const Curve curve = standard_profile(name).curve;
  std::vector<Position> points;
  for (double arc = 0.0; arc <= curve.length(); arc += spacing) {
    const CurvePoint at = curve.at(arc);
    points.push_back({at.lateral, at.height});
  }
  return points;
}

void expect_same_points(const ReadResult& read, const std::vector<Position>& points) {
  ASSERT_EQ(read.measured.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(read.measured[i], points[i]) << i;
  }
}

/// From the tread outwards, then from there to the flange.
TEST(Readers, ScansOneBehindTheOtherArePutInOrder) {
  const std::vector<Position> whole = points_every("S1002", 0.5);
  std::vector<Position> blocks(whole.begin() + 250, whole.end());
  blocks.insert(blocks.end(), whole.rend() - 250, whole.rend());
  const ReadResult read = read_profile_text(rows_of(blocks), ProfileFormat::columns, "a.wheel");
  EXPECT_TRUE(says(read, "points put in order"));
  expect_same_points(read, whole);
  EXPECT_TRUE(read.profile.warnings.empty());
}

/// A rail with a lip on its gauge face.
TEST(Readers, ALipSortedByLateralIsPutInOrder) {
  std::vector<Position> whole = points_every("60E1", 0.25);
  for (Position& point : whole) {
    if (point[0] < 0.0) {
      point[0] -= 1.2 * std::exp(-std::pow((point[1] + 9.0) / 1.5, 2));
    }
  }
  std::vector<Position> sorted = whole;
  std::ranges::stable_sort(sorted, {}, [](const Position& point) { return point[0]; });
  ReadOptions options;
  options.smoothing_wavelength = 0.0;
  const ReadResult read =
      read_profile_text(rows_of(sorted), ProfileFormat::columns, "a.rail", options);
  EXPECT_TRUE(says(read, "points put in order"));
  EXPECT_FALSE(says(read, "outlier"));
  expect_same_points(read, whole);
}

/// Points with a gap stay as they are.
TEST(Readers, AGapIsNoDisorder) {
  std::vector<Position> points = points_every("S1002", 0.5);
  points.erase(points.begin() + 250, points.begin() + 300);
  const ReadResult read = read_profile_text(rows_of(points), ProfileFormat::columns, "a.wheel");
  EXPECT_FALSE(says(read, "order"));
  expect_same_points(read, points);
}

TEST(Readers, ColumnsOfWholeMillimetresAreNoCount) {
  const std::vector<Position> points = points_every("S1002", 0.05);
  std::string text;
  for (int lateral = 0; lateral < 120; ++lateral) {
    const auto at = std::ranges::find_if(
        points, [&](const Position& point) { return point[0] >= lateral - 54.0; });
    text += std::to_string(lateral) + ' ' + text_of((*at)[1]) + ' ' +
            text_of(0.001 * (lateral % 7)) + '\n';
  }
  const ReadResult read = read_profile_text(text, ProfileFormat::columns, "a.wheel");
  EXPECT_TRUE(says(read, "columns 3 ignored"));
  EXPECT_FALSE(says(read, "counts the rows"));
  EXPECT_NEAR(read.measured.back()[0] - read.measured.front()[0], 119.0, 1.1);
}

/// As Fortran writes two equal numbers.
TEST(Readers, ARepeatedNumberIsTwo) {
  std::string text = rows_of(wheel_points());
  const ReadResult plain =
      read_profile_text(text + "62.0 62.0\n", ProfileFormat::columns, "w.wheel");
  const ReadResult repeated =
      read_profile_text(text + "2*62.0\n", ProfileFormat::columns, "w.wheel");
  EXPECT_EQ(plain.measured, repeated.measured);
}

TEST(Readers, DuplicatesAreDroppedAndReported) {
  std::vector<Position> points = wheel_points();
  points.insert(points.begin() + 10, 3, points[10]);
  const ReadResult read = read_rows(rows_of(points), wheel_options());
  EXPECT_TRUE(says(read, "3 points closer than 0.01 mm"));
  EXPECT_LT(distance_at(read.profile.curve, wheel_points()), rounding);
}

TEST(Readers, RefusesTooFewPointsAndWrongLengths) {
  expect_refused("", "is empty");
  expect_refused("\n\n# nothing\n", "no row of two numbers");
  expect_refused("a profile\n\nnothing\nat all\n", "the last line is 'at all' in line 4");
  expect_refused("0 0\n10 1\n20 2\n30 3\n", "4 points, the last in line 4");
  expect_refused("0 0\n10 1\n10 1\n20 2\n30 3\n", "4 different points");
  expect_refused("0 0\n1 0\n2 0\n3 0\n4 0\n", "mm long in total");
  expect_refused("# heights\n0 1\n10 1.5\n\n20 2\n30 8275142\n40 3\n",
                 "from (20.000, 2.000) in line 5 to (30.000, 8275142.000) in line 6");
  expect_refused("1e300 0\n-1e300 1\n1e300 2\n3 3\n4 4\n", "mm long in total");
  expect_refused("1e9 0\n1000000010 1\n1000000020 2\n1000000030 3\n1000000040 4\n",
                 "at most 1e+05 mm");
}

TEST(Readers, APointThatIsNotFiniteIsNamedWithItsCoordinate) {
  std::vector<Position> points = wheel_points();
  points[40][1] = std::numeric_limits<double>::quiet_NaN();
  test::expect_error(
      ErrorCode::invalid_argument,
      [&] { (void)profile_through(points, "points", wheel_options()); },
      "points: point 40: height = nan, must be finite");
  points[40][1] = 0.0;
  points[7][0] = -std::numeric_limits<double>::infinity();
  test::expect_error(
      ErrorCode::invalid_argument,
      [&] { (void)profile_through(points, "points", wheel_options()); },
      "points: point 7: lateral = -inf, must be finite");
}

TEST(Readers, ANumberOfASliceIsRefusedWithAFileOfOneProfile) {
  ReadOptions options = wheel_options();
  options.slice = 3;
  for (const ProfileFormat format : {ProfileFormat::columns, ProfileFormat::miniprof}) {
    EXPECT_TRUE(contains(refusal_of(rows_of(wheel_points()), format, options),
                         "slice = 3, allowed with a slices file"));
  }
}

/// Rows of S1002 every 0.25 mm with so many digits.
std::string wheel_rows_with(int digits) {
  std::string rows;
  const Curve curve = standard_profile("S1002").curve;
  for (double arc = 0.0; arc < curve.length(); arc += 0.25) {
    const CurvePoint at = curve.at(arc);
    std::ostringstream row;
    row << std::fixed << std::setprecision(digits) << at.lateral << ' ' << at.height << '\n';
    rows += row.str();
  }
  return rows;
}

bool warns_of_noise(const ReadResult& read, const std::string& text) {
  return std::ranges::any_of(read.profile.warnings, [&text](const Warning& warning) {
    return warning.kind == WarningClass::profile_noise && contains(warning.text, text);
  });
}

/// pmax in the default scene is 2605, 1062 and 903 MPa instead of 898 with 2, 3 and 4 digits.
TEST(Readers, ScatterThatMattersIsSmoothed) {
  for (const int digits : {2, 3, 4}) {
    const std::string rows = wheel_rows_with(digits);
    const ReadResult read = read_rows(rows, wheel_options());
    ReadOptions none = wheel_options();
    none.smoothing_wavelength = 0.0;
    const ReadResult raw = read_rows(rows, none);
    const bool noisy = digits < 4;
    EXPECT_EQ(warns_of_noise(read, "MPa to flatten: smoothed automatically"), noisy) << digits;
    EXPECT_EQ(warns_of_noise(raw, "not smoothed, pressures are those of the scatter"), noisy);
    EXPECT_EQ(says(read, "smoothed automatically: waves of "), noisy) << digits;
    ASSERT_TRUE(read.profile.doubt.valid()) << digits;
    EXPECT_EQ(read.profile.doubt.get().is_of_waves, !noisy) << digits;
    EXPECT_EQ(read.profile.doubt.get().smoothed.size(), smoothed_waves.size()) << digits;
    EXPECT_EQ(read.profile.points == raw.profile.points, !noisy) << digits;
    EXPECT_EQ(raw.profile.points, raw.measured) << digits; // to the bit
    EXPECT_EQ(read.measured, raw.measured) << digits;
  }
}

/// A wave 3 mm long, 0.02 mm high, by 12 points each: as rough as noise, but shape.
TEST(Readers, WavesThatPointsAgreeUponStay) {
  std::string rows;
  for (double y = -30.0; y <= 60.0; y += 0.25) {
    rows += std::to_string(y) + ' ' + std::to_string(0.02 * std::cos(2.0 * y)) + '\n';
  }
  ReadOptions options = wheel_options();
  const ReadResult read = read_rows(rows, options);
  EXPECT_TRUE(reading::scatter_of(read.measured).matters());
  EXPECT_FALSE(warns_of_noise(read, ""));
  EXPECT_EQ(read.profile.points, read.measured);
}

TEST(Readers, StrictModeWantsTheSmoothingOfNoiseStated) {
  const std::string rows = wheel_rows_with(2);
  ReadOptions options = wheel_options();
  options.strict = true;
  EXPECT_TRUE(contains(refusal_of(rows, ProfileFormat::columns, options), "state the smoothing"));
  for (const double stated : {automatic_smoothing, 0.0, 5.0}) {
    options.smoothing_wavelength = stated;
    EXPECT_EQ(refusal_of(rows, ProfileFormat::columns, options), "accepted") << stated;
  }
}

TEST(Readers, PointsLeftOutAtTheEndsAreReported) {
  const ReadResult read = read_rows("-73.6 9.45\n" + wheel_rows_with(2), wheel_options());
  EXPECT_TRUE(std::ranges::any_of(read.corrections, [](const std::string& text) {
    return contains(text, "left out at the ends, far from the others: 1");
  }));
}

/// Eight points with a gap in the middle scatter, but are too few for the noise to be found.
TEST(Readers, NoiseThatCannotBeFoundIsReported) {
  const std::string rows = "-8 0\n-6.5 0.3\n-5 0\n-3.5 0.3\n8 0\n9.5 0.3\n11 0\n12.5 0.3\n";
  ReadOptions options = wheel_options();
  EXPECT_TRUE(warns_of_noise(read_rows(rows, options), "not smoothed"));
  options.smoothing_wavelength = 5.0;
  EXPECT_TRUE(warns_of_noise(read_rows(rows, options), "smoothing halves 5 mm"));
}

/// A wavelength that leaves noise is reported, with those that would not.
TEST(Readers, TooShortASmoothingIsReported) {
  const std::string rows = wheel_rows_with(2);
  ReadOptions options = wheel_options();
  options.smoothing_wavelength = 2.0;
  EXPECT_TRUE(warns_of_noise(read_rows(rows, options), "to be halved, smoothing halves 2 mm"));
  options.smoothing_wavelength = 15.0;
  const ReadResult long_waves = read_rows(rows, options);
  EXPECT_FALSE(warns_of_noise(long_waves, ""));
  EXPECT_TRUE(long_waves.profile.doubt.valid());
}

TEST(Readers, RefusesPointsThatTurnBack) {
  expect_refused("0 0\n10 0\n20 0\n30 0\n20 0\n10 0\n5 0\n", "turn back on themselves");
  expect_refused("0 0\n10 0\n20 0\n30 0\n20 0\n10 0\n0 0\n", "a closed outline");
}

TEST(Readers, RefusesMorePointsThanTheLimit) {
  std::string rows;
  for (std::size_t i = 0; i <= ReadLimits::max_points; ++i)
    rows += text_of(static_cast<double>(i) * 1e-3) + " 0\n";
  expect_refused(rows, "sample:200001: more than 200000");
}

TEST(Readers, RefusesLongLinesAndBinaryContent) {
  expect_refused(std::string(5000, '7'), "sample:1: line of 5000 bytes");
  expect_refused(std::string("1 2\n\0\x01", 6), "sample:2: byte 0");
}

TEST(Readers, SurvivesGarbage) {
  // Seeded, so that a failure can be repeated. Words that the parsers know make it go deep.
  std::mt19937 random(20240607);
  std::istringstream list(
      "header.begin|header.end|spline.begin|spline.end|point.begin|point.end|type = 1|"
      "=|\n|\n|\n\n| |1.5|-3e2|nan|inf|1e999|+|+-1|\"|!|%|#|'|ColumnDef=Y,X|"
      "XYPoints=1e18|units.len.f = 0|\t|,|\r|\xEF\xBB\xBF|\x80|mirror.y = 1|"
      "bound.y.min = -1e308|shift.y = 1e308|0.001|7 8\n9 10\n11 30\n");
  std::vector<std::string> words;
  for (std::string each; std::getline(list, each, '|');)
    words.push_back(each);
  std::uniform_int_distribution<std::size_t> word(0, words.size() - 1);
  std::uniform_int_distribution<int> count(0, 60);
  std::size_t refused = 0;
  constexpr int trials = 3000;
  for (int trial = 0; trial < trials; ++trial) {
    std::string text = trial % 2 == 0 ? "" : "header.begin\nheader.end\nspline.begin\n";
    for (int i = count(random); i > 0; --i)
      text += words[word(random)];
    for (const ProfileFormat format :
         {ProfileFormat::columns, ProfileFormat::simpack, ProfileFormat::miniprof}) {
      const std::string found = refusal_of(text, format);
      EXPECT_FALSE(contains(found, "unexpected")) << found << "\n" << text;
      refused += found != "accepted" ? 1U : 0U;
    }
  }
  EXPECT_GT(refused, 2U * trials);
}

TEST(Readers, RefusesOptionsOutOfRange) {
  const auto code_of = [](const ReadOptions& options) {
    try {
      (void)read_profile_text(rows_of(wheel_points()), ProfileFormat::columns, "sample", options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::internal;
  };
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    ReadOptions options;
    options.scale = bad;
    EXPECT_EQ(code_of(options), ErrorCode::invalid_argument);
    options = {};
    options.least_point_distance = bad;
    EXPECT_EQ(code_of(options), ErrorCode::invalid_argument);
  }
  for (const double bad : {-0.5, std::nan(""), 501.0}) {
    ReadOptions options;
    options.smoothing_wavelength = bad;
    EXPECT_EQ(code_of(options), ErrorCode::invalid_argument);
  }
}

TEST(Readers, SmoothingIsDoneAndReported) {
  ReadOptions options = wheel_options();
  options.smoothing_wavelength = 20.0;
  const ReadResult read = read_rows(rows_of(wheel_points()), options);
  EXPECT_TRUE(says(read, "smoothed"));
  EXPECT_GT(distance_at(read.profile.curve, wheel_points()), 0.01);
}

TEST(Readers, FormatGoesByTheExtension) {
  EXPECT_EQ(type_of("a/b.prr").format, ProfileFormat::simpack);
  EXPECT_EQ(type_of("b.PRW").format, ProfileFormat::simpack);
  EXPECT_EQ(type_of("b.ban").format, ProfileFormat::miniprof);
  EXPECT_EQ(type_of("b.whl").format, ProfileFormat::miniprof);
  EXPECT_EQ(type_of("b.txt").format, ProfileFormat::columns);
  EXPECT_EQ(type_of("b").format, ProfileFormat::columns);
}

TEST(Readers, RefusesDirectoriesDevicesAndMissingFiles) {
  const auto code_of = [](const std::filesystem::path& path) {
    try {
      (void)read_profile(path);
    } catch (const Error& error) {
      EXPECT_TRUE(contains(error.what(), path.string()));
      return error.code();
    }
    return ErrorCode::internal;
  };
  EXPECT_EQ(code_of("no/such/file.txt"), ErrorCode::file_unreadable);
  EXPECT_EQ(code_of(std::filesystem::temp_directory_path()), ErrorCode::file_unreadable);
  EXPECT_EQ(code_of("/dev/zero"), ErrorCode::file_unreadable);
}

TEST(Readers, RefusesAFileThatIsTooLarge) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) /
      ("wrcontact_large_profile_" + std::to_string(getpid()) + ".txt");
  std::ofstream(path) << "1 2\n";
  std::filesystem::resize_file(path, ReadLimits::file_bytes + 1); // sparse
  test::expect_error(
      ErrorCode::file_unreadable, [&] { (void)read_profile(path); }, "is larger than");
  std::filesystem::remove(path);
}

} // namespace
} // namespace wrc::test::readers_test
