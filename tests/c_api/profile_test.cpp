/// Profiles through the C interface.
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "owned_handles.hpp"

namespace profile_test {
namespace {

/// Coordinates of profiles are some 10 mm; their arithmetic rounds here.
constexpr double rounding = 1e-11;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

wrc_read_options plain_options() {
  wrc_read_options options{};
  options.struct_size = sizeof options;
  return options;
}

TEST(ProfileHandle, EveryFunctionRefusesANullHandle) {
  std::int32_t kind = 0;
  std::int64_t count = 0;
  double value = 0.0;
  const char* text = nullptr;
  EXPECT_EQ(wrc_profile_create(nullptr), WRC_INVALID_ARGUMENT);
  wrc_profile_destroy(nullptr);
  EXPECT_EQ(wrc_profile_load_standard(nullptr, "S1002"), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_load_file(nullptr, "a", nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_write(nullptr, "a", 1.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_kind(nullptr, &kind), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_text(nullptr, "name", &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_correction(nullptr, 0), nullptr);
  EXPECT_EQ(wrc_profile_length(nullptr, &value), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_nodes(nullptr, &value, 1, &count), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_at(nullptr, 0.0, &value, &value, &value, &value), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_load_surface(nullptr, "a.slcs", nullptr, 0.0, &count),
            WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_surface_line(nullptr, 0), nullptr);
  EXPECT_EQ(wrc_profile_surface_at(nullptr, 0, 0.0, 0.0, &value, &value, &value),
            WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_profile_error(nullptr), "NULL"));
}

TEST(ProfileHandle, AnEmptyHandleHasNoResult) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  std::int32_t kind = 0;
  std::int64_t count = 0;
  double value = 0.0;
  const char* text = nullptr;
  EXPECT_EQ(wrc_profile_kind(p, &kind), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_text(p, "name", &text), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_length(p, &value), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_nodes(p, &value, 1, &count), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_at(p, 0.0, &value, nullptr, nullptr, nullptr), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_write(p, "a.txt", 1.0), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_correction(p, 0), nullptr);
  EXPECT_TRUE(contains(wrc_profile_error(p), "no profile"));
  EXPECT_EQ(wrc_profile_surface_at(p, 0, 0.0, 0.0, &value, &value, &value), WRC_NO_RESULT);
  EXPECT_EQ(wrc_profile_surface_line(p, 0), nullptr);
}

TEST(ProfileHandle, NullArgumentsAreNamed) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  double value = 0.0;
  const char* text = nullptr;
  expect_null_told(p, wrc_profile_load_standard(p, nullptr), "name");
  expect_null_told(p, wrc_profile_load_file(p, nullptr, nullptr), "path");
  ASSERT_EQ(wrc_profile_load_standard(p, "S1002"), WRC_OK);
  expect_null_told(p, wrc_profile_write(p, nullptr, 1.0), "path");
  expect_null_told(p, wrc_profile_kind(p, nullptr), "kind");
  expect_null_told(p, wrc_profile_text(p, nullptr, &text), "name");
  expect_null_told(p, wrc_profile_text(p, "name", nullptr), "value");
  expect_null_told(p, wrc_profile_length(p, nullptr), "length");
  expect_null_told(p, wrc_profile_nodes(p, &value, 1, nullptr), "count");
}

TEST(StandardProfiles, AllNamesLoadAsTheirKind) {
  const ProfilePointer profile = make_profile();
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    std::int64_t count = 0;
    while (const char* name = wrc_profile_standard_name(kind, count)) {
      ASSERT_EQ(wrc_profile_load_standard(profile.get(), name), WRC_OK) << name;
      std::int32_t loaded = -1;
      EXPECT_EQ(wrc_profile_kind(profile.get(), &loaded), WRC_OK);
      EXPECT_EQ(loaded, kind) << name;
      for (const char* text_name : {"name", "title", "source", "confidence"}) {
        const char* text = nullptr;
        ASSERT_EQ(wrc_profile_text(profile.get(), text_name, &text), WRC_OK);
        EXPECT_STRNE(text, "") << name << ' ' << text_name;
      }
      ++count;
    }
    EXPECT_EQ(count, kind == WRC_WHEEL ? 4 : 10);
    EXPECT_EQ(wrc_profile_standard_name(kind, -1), nullptr);
  }
  EXPECT_EQ(wrc_profile_standard_name(2, 0), nullptr);
  EXPECT_EQ(wrc_profile_standard_name(-1, 0), nullptr);
}

TEST(StandardProfiles, AnUnknownNameLeavesTheProfileUnchanged) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  ASSERT_EQ(wrc_profile_load_standard(p, "S1002"), WRC_OK);
  expect_error(p, wrc_profile_load_standard(p, "S1003"), WRC_UNKNOWN_NAME, "S1003");
  const char* text = nullptr;
  ASSERT_EQ(wrc_profile_text(p, "name", &text), WRC_OK);
  EXPECT_STREQ(text, "S1002");
  EXPECT_EQ(wrc_profile_text(p, "colour", &text), WRC_UNKNOWN_NAME);
}

TEST(ProfileCurve, HasLengthNodesAndPoints) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  ASSERT_EQ(wrc_profile_load_standard(p, "S1002"), WRC_OK);
  double length = 0.0;
  ASSERT_EQ(wrc_profile_length(p, &length), WRC_OK);
  std::int64_t count = 0;
  ASSERT_EQ(wrc_profile_nodes(p, nullptr, 0, &count), WRC_OK);
  std::vector<double> arcs(static_cast<std::size_t>(count), -1.0);
  EXPECT_EQ(wrc_profile_nodes(p, arcs.data(), count - 1, &count), WRC_TOO_SMALL);
  EXPECT_EQ(arcs, std::vector<double>(arcs.size(), -1.0));
  EXPECT_EQ(wrc_profile_nodes(p, nullptr, count, &count), WRC_INVALID_ARGUMENT);
  ASSERT_EQ(wrc_profile_nodes(p, arcs.data(), count, &count), WRC_OK);
  EXPECT_EQ(arcs.front(), 0.0);
  EXPECT_EQ(arcs.back(), length);
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    EXPECT_LT(arcs[i - 1], arcs[i]);
  }
  // The flange back of the standard: an arc of radius 20.5 that starts upright at (-70, 9.519).
  double lateral = 0.0;
  double height = 0.0;
  double angle = 0.0;
  double curvature = 0.0;
  ASSERT_EQ(wrc_profile_at(p, 0.0, &lateral, &height, &angle, &curvature), WRC_OK);
  EXPECT_NEAR(lateral, -70.0, rounding);
  EXPECT_NEAR(height, 9.519259302, rounding);
  EXPECT_NEAR(angle, 0.5 * std::numbers::pi, rounding);
  EXPECT_NEAR(curvature, -1.0 / 20.5, rounding);
  double clamped = 0.0;
  ASSERT_EQ(wrc_profile_at(p, -5.0, &clamped, nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_EQ(clamped, lateral);
  ASSERT_EQ(wrc_profile_at(p, length + 5.0, &clamped, nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_NEAR(clamped, 65.0, rounding);
  EXPECT_EQ(wrc_profile_at(p, 1.0, nullptr, nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_EQ(wrc_profile_at(p, nan, &clamped, nullptr, nullptr, nullptr), WRC_INVALID_ARGUMENT);
}

class ProfileFiles : public WithFolder {};

TEST_F(ProfileFiles, UnreadableAndMalformedFilesLeaveTheProfileUnchanged) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  ASSERT_EQ(wrc_profile_load_standard(p, "60E1"), WRC_OK);
  expect_error(p, wrc_profile_load_file(p, path("missing.txt").c_str(), nullptr),
               WRC_FILE_UNREADABLE, "missing.txt");
  expect_error(p, wrc_profile_load_file(p, write("a.txt", "1 2\n3 oops\n").c_str(), nullptr),
               WRC_FILE_MALFORMED, "a.txt:2: 'oops'");
  const char* text = nullptr;
  ASSERT_EQ(wrc_profile_text(p, "name", &text), WRC_OK);
  EXPECT_STREQ(text, "60E1");
}

TEST_F(ProfileFiles, WrittenFilesReadBack) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  ASSERT_EQ(wrc_profile_load_standard(p, "S1002"), WRC_OK);
  const std::string file = path("wheel.prw");
  ASSERT_EQ(wrc_profile_write(p, file.c_str(), 0.5), WRC_OK);
  const ProfilePointer again = make_profile();
  wrc_read_options options = plain_options();
  options.strict = 1;
  ASSERT_EQ(wrc_profile_load_file(again.get(), file.c_str(), &options), WRC_OK)
      << wrc_profile_error(again.get());
  double lateral = 0.0;
  ASSERT_EQ(wrc_profile_at(again.get(), 0.0, &lateral, nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_NEAR(lateral, -70.0, rounding);
  EXPECT_EQ(wrc_profile_write(p, path("no/folder.txt").c_str(), 0.5), WRC_FILE_UNREADABLE);
  EXPECT_EQ(wrc_profile_write(p, path("a.prr").c_str(), 0.5), WRC_INVALID_ARGUMENT);
  for (const double spacing : {0.0, -1.0, nan, 1e-12}) {
    EXPECT_EQ(wrc_profile_write(p, path("b.txt").c_str(), spacing), WRC_INVALID_ARGUMENT);
  }
  EXPECT_FALSE(std::filesystem::exists(path("b.txt")));
}

/// A rail head that bulges down: needs a correction.
const char* const upside_down = "-30 20\n-27.5 15\n-25 11\n-20 5\n-15 2.5\n-10 1\n-5 0.2\n0 0\n5 "
                                "0.2\n10 1\n15 2.5\n20 5\n25 11\n27.5 15\n30 20\n";

TEST_F(ProfileFiles, CorrectionsAreReportedAndRefusedInStrictMode) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  const std::string file = write("a.rail", upside_down);
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), nullptr), WRC_OK);
  ASSERT_NE(wrc_profile_correction(p, 0), nullptr);
  EXPECT_TRUE(contains(wrc_profile_correction(p, 0), "height mirrored"));
  EXPECT_EQ(wrc_profile_correction(p, 1), nullptr);
  EXPECT_EQ(wrc_profile_correction(p, -1), nullptr);
  wrc_read_options options = plain_options();
  options.strict = 1;
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_FILE_MALFORMED);
  EXPECT_NE(wrc_profile_correction(p, 0), nullptr);
  options.mirror_height = 1;
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK);
  ASSERT_EQ(wrc_profile_load_standard(p, "60E1"), WRC_OK);
  EXPECT_EQ(wrc_profile_correction(p, 0), nullptr);
}

/// A wheel that counts from its flange back, 1 mm apart; with a spike.
std::string wheel_from_flange_back(bool spike) {
  std::ostringstream rows;
  for (int y = 0; y <= 130; ++y) {
    const double tread = -(y - 70.0) / 40.0;
    const double flange = 28.0 * std::exp(-std::pow((y - 16.0) / 11.0, 2));
    rows << y << ' ' << tread + flange + (spike && y == 80 ? 30.0 : 0.0) << '\n';
  }
  return rows.str();
}

TEST_F(ProfileFiles, AWheelIsShiftedToItsTapingLine) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  const std::string file = write("a.wheel", wheel_from_flange_back(false));
  const auto start = [p] {
    double lateral = 0.0;
    EXPECT_EQ(wrc_profile_at(p, 0.0, &lateral, nullptr, nullptr, nullptr), WRC_OK);
    return lateral;
  };
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), nullptr), WRC_OK);
  EXPECT_DOUBLE_EQ(start(), -70.0) << "by the shape";
  EXPECT_EQ(wrc_profile_warning(p, 0), nullptr);
  wrc_read_options options = plain_options();
  options.origin = WRC_ORIGIN_FLANGE_BACK;
  options.tape_offset = 66.0;
  options.strict = 1;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK) << wrc_profile_error(p);
  EXPECT_DOUBLE_EQ(start(), -66.0);
  options.origin = 0;
  options.lateral_shift = -71.5;
  options.tape_offset = 0.0;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK) << wrc_profile_error(p);
  EXPECT_DOUBLE_EQ(start(), -71.5);
  options = plain_options();
  options.origin = WRC_ORIGIN_TAPE;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK);
  EXPECT_DOUBLE_EQ(start(), 0.0);
  ASSERT_NE(wrc_profile_warning(p, 0), nullptr);
  EXPECT_TRUE(contains(wrc_profile_warning(p, 0), "the taping line, at 0, is not inside"));
  EXPECT_EQ(wrc_profile_warning(p, 99), nullptr);
  EXPECT_EQ(wrc_profile_warning(nullptr, 0), nullptr);
  options.strict = 1;
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_FILE_MALFORMED);
  for (const std::int32_t origin : {-1, 3}) {
    options.origin = origin;
    EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_INVALID_ARGUMENT);
  }
  options = plain_options();
  options.tape_offset = 5.0;
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_INVALID_ARGUMENT);
  options = plain_options();
  options.lateral_shift = 1000.0;
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_INVALID_ARGUMENT);
}

TEST_F(ProfileFiles, ReadAndDroppedPointsAreAvailable) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  const std::string file = write("a.wheel", wheel_from_flange_back(true));
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), nullptr), WRC_OK);
  std::int64_t count = 0;
  ASSERT_EQ(wrc_profile_points(p, WRC_POINTS_READ, nullptr, nullptr, 0, &count), WRC_OK);
  EXPECT_EQ(count, 130);
  ASSERT_EQ(wrc_profile_points(p, WRC_POINTS_DROPPED, nullptr, nullptr, 0, &count), WRC_OK);
  ASSERT_EQ(count, 1);
  double lateral = 0.0;
  double height = 0.0;
  ASSERT_EQ(wrc_profile_points(p, WRC_POINTS_DROPPED, &lateral, &height, 1, &count), WRC_OK);
  EXPECT_DOUBLE_EQ(lateral, 10.0);
  EXPECT_NEAR(height, 29.75, 1e-3); // the height was shifted to 0 at the taping line
  EXPECT_EQ(wrc_profile_points(p, WRC_POINTS_READ, &lateral, &height, 1, &count), WRC_TOO_SMALL);
  std::vector<double> laterals(200);
  EXPECT_EQ(wrc_profile_points(p, WRC_POINTS_READ, laterals.data(), nullptr, 200, &count),
            WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_points(p, 2, nullptr, nullptr, 0, &count), WRC_INVALID_ARGUMENT);
  ASSERT_EQ(wrc_profile_load_standard(p, "S1002"), WRC_OK);
  ASSERT_EQ(wrc_profile_points(p, WRC_POINTS_READ, nullptr, nullptr, 0, &count), WRC_OK);
  EXPECT_EQ(count, 0);
}

TEST_F(ProfileFiles, SlicesMakeASurface) {
  std::string rows;
  for (int y = -30; y <= 30; ++y) {
    rows += std::to_string(y) + ' ' + std::to_string(-y * y / 600.0) + '\n';
  }
  (void)write("a.txt", rows);
  const std::string file = write("rail.slcs", "0 10\n3\n2\n1\n0 'a.txt'\n1 'a.txt'\n2 'a.txt'\n"
                                              "0 -1 -1\n1 0 999\n2 0 999\n");
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  std::int64_t sheets = 0;
  ASSERT_EQ(wrc_profile_load_surface(p, file.c_str(), nullptr, -1.0, &sheets), WRC_OK);
  EXPECT_EQ(sheets, 1);
  EXPECT_TRUE(contains(wrc_profile_surface_line(p, 0), "rail with 3 slices along the track"));
  double place = 0.0;
  double lateral = 0.0;
  double height = 0.0;
  ASSERT_EQ(wrc_profile_surface_at(p, 0, 0.5, 0.5, &place, &lateral, &height), WRC_OK);
  EXPECT_EQ(place, 15.0); // of 10 to 20 mm
  EXPECT_NEAR(lateral, 0.0, 1e-9);
  EXPECT_NEAR(height, 0.0, 1e-6);
  ASSERT_EQ(wrc_profile_surface_at(p, 0, 0.0, 0.0, nullptr, &lateral, nullptr), WRC_OK);
  EXPECT_NEAR(lateral, -30.0, 1e-9);
  EXPECT_EQ(wrc_profile_surface_at(p, 1, 0.0, 0.0, &place, nullptr, nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_surface_at(p, 0, 0.0, 1.1, &place, nullptr, nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_load_surface(p, file.c_str(), nullptr, NAN, &sheets), WRC_INVALID_ARGUMENT);
  expect_null_told(p, wrc_profile_load_surface(p, nullptr, nullptr, 0.0, &sheets), "path");
  expect_null_told(p, wrc_profile_load_surface(p, file.c_str(), nullptr, 0.0, nullptr), "sheets");
  EXPECT_EQ(wrc_profile_load_surface(p, "none.slcs", nullptr, 0.0, &sheets), WRC_FILE_UNREADABLE);
}

TEST_F(ProfileFiles, OneSliceIsAProfile) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  (void)write("a.wheel", wheel_from_flange_back(false));
  (void)write("b.wheel", wheel_from_flange_back(true));
  const std::string file = write("flat.slcw", "% a wheel\n 0.0 1.0 % offset, scale\n 2\n 1\n 1\n"
                                              " 0.00 'a.wheel'\n 0.25 'b.wheel'\n");
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), nullptr), WRC_FILE_MALFORMED);
  EXPECT_TRUE(contains(wrc_profile_error(p), "2 slices: 1 at 0 rad 'a.wheel', 2 at 0.25 rad"));
  wrc_read_options options{};
  options.struct_size = sizeof options;
  options.slice = 2;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK) << wrc_profile_error(p);
  ASSERT_NE(wrc_profile_correction(p, 0), nullptr);
  EXPECT_TRUE(contains(wrc_profile_correction(p, 0), "slice 2 of 2, at 0.25 rad"));
  options.slice = 3;
  EXPECT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_FILE_MALFORMED);
}

/// Members that an older caller does not have are not read; half a pointer is none.
TEST_F(ProfileFiles, ARotationAndANominalProfileAreApplied) {
  const ProfilePointer straight = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(straight.get(), "S1002"), WRC_OK);
  const std::string path = write("turned.wheel", "");
  ASSERT_EQ(wrc_profile_write(straight.get(), path.c_str(), 0.5), WRC_OK);
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  wrc_read_options options = plain_options();
  options.rotation_given = 1;
  options.rotation = 0.02;
  const auto height_of_end = [&] {
    EXPECT_EQ(wrc_profile_load_file(p, path.c_str(), &options), WRC_OK) << wrc_profile_error(p);
    double length = 0.0;
    double height = 0.0;
    EXPECT_EQ(wrc_profile_length(p, &length), WRC_OK);
    EXPECT_EQ(wrc_profile_at(p, length, nullptr, &height, nullptr, nullptr), WRC_OK);
    return height;
  };
  const double turned = height_of_end();
  options.rotation_given = 0;
  const double plain = height_of_end();
  EXPECT_NEAR(turned - plain, 0.02 * 65.0, 0.01);
  options.rotation_given = 1;
  options.align_to = "S1002";
  EXPECT_NEAR(height_of_end(), plain, 0.01);
  options.struct_size = offsetof(wrc_read_options, align_to) + 4;
  EXPECT_NEAR(height_of_end(), turned, 1e-12);
  options.rotation = 1.0;
  EXPECT_EQ(wrc_profile_load_file(p, path.c_str(), &options), WRC_INVALID_ARGUMENT);
}

TEST_F(ProfileFiles, OptionsAreApplied) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  const std::string file = write("a.rail", upside_down);
  const auto height_at_start = [p] {
    double height = 0.0;
    EXPECT_EQ(wrc_profile_at(p, 0.0, nullptr, &height, nullptr, nullptr), WRC_OK);
    return height;
  };
  wrc_read_options options = plain_options();
  options.mirror_height = -1;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK);
  EXPECT_NEAR(height_at_start(), 20.0, rounding);
  options.mirror_height = 1;
  options.scale = 2.0;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK);
  EXPECT_NEAR(height_at_start(), -40.0, rounding);
  options.kind_given = 1;
  options.kind = WRC_WHEEL;
  ASSERT_EQ(wrc_profile_load_file(p, file.c_str(), &options), WRC_OK);
  std::int32_t kind = WRC_RAIL;
  ASSERT_EQ(wrc_profile_kind(p, &kind), WRC_OK);
  EXPECT_EQ(kind, WRC_WHEEL);
}

TEST_F(ProfileFiles, BadOptionsAreRefused) {
  const ProfilePointer profile = make_profile();
  wrc_profile* p = profile.get();
  const std::string file = write("a.rail", upside_down);
  const auto status_with = [&](auto change) {
    wrc_read_options options = plain_options();
    change(options);
    return wrc_profile_load_file(p, file.c_str(), &options);
  };
  EXPECT_EQ(status_with([](auto& o) { o.struct_size = 0; }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_with([](auto& o) { o.mirror_lateral = 2; }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_with([](auto& o) { o.mirror_height = -2; }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_with([](auto& o) { o.kind_given = 1, o.kind = 3; }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_with([](auto& o) { o.scale = -1.0; }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_with([](auto& o) { o.scale = nan; }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_with([](auto& o) { o.smoothing_wavelength = -0.5; }), WRC_INVALID_ARGUMENT);
}

TEST_F(ProfileFiles, AnOlderCallersSmallerStructIsNotReadBeyondItsSize) {
  const ProfilePointer profile = make_profile();
  const std::string file = write("a.rail", upside_down);
  // What lies behind the caller's struct would be refused if it were read.
  std::vector<unsigned char> bytes(sizeof(wrc_read_options), 0xFF);
  constexpr std::uint64_t known_to_caller = offsetof(wrc_read_options, mirror_lateral);
  std::memset(bytes.data(), 0, known_to_caller);
  std::memcpy(bytes.data(), &known_to_caller, sizeof known_to_caller);
  wrc_read_options options{};
  std::memcpy(&options, bytes.data(), sizeof options);
  EXPECT_EQ(wrc_profile_load_file(profile.get(), file.c_str(), &options), WRC_OK)
      << wrc_profile_error(profile.get());
  // The same bytes, claimed as known, are refused.
  options.struct_size = sizeof options;
  EXPECT_EQ(wrc_profile_load_file(profile.get(), file.c_str(), &options), WRC_INVALID_ARGUMENT);
  // A newer caller's larger struct: only what the library knows is read.
  struct {
    wrc_read_options known;
    double unknown;
  } larger{plain_options(), nan};
  larger.known.struct_size = sizeof larger;
  EXPECT_EQ(wrc_profile_load_file(profile.get(), file.c_str(), &larger.known), WRC_OK);
}

} // namespace
} // namespace profile_test
