/// Slices read together: one rule for all of them, features as arc lengths, limits and faults.
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "measured/sliced_profile_reader.hpp"
#include "measured/slices.hpp"
#include "samples.hpp"
#include "support/errors.hpp"

namespace wrc::test::sliced_profile_test {
namespace {

class SlicedProfileFile : public ::testing::Test {
protected:
  SlicedProfileFile()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ("wrcontact_sliced_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    (void)write("a.txt", rows_of(rail_points()));
    (void)write("down.txt", rows_of(rail_points(), 0.001, -0.001));
    (void)write("flat.txt", rows_of(rail_points(), 1.0, 0.0));
  }
  ~SlicedProfileFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// A list of the same file at 0, 10, 20 ...
  [[nodiscard]] std::filesystem::path list(const std::string& file, int count,
                                           const std::string& features,
                                           const std::string& name = "list.slcs") const {
    std::string text = "0 10\n" + std::to_string(count) + "\n3 0 0\n2\n";
    for (int i = 0; i < count; ++i)
      text += std::to_string(i) + " '" + file + "'\n";
    return write(name, text + features);
  }
  void refuses(const std::filesystem::path& path, const std::string& part,
               const ReadOptions& options = {}) const {
    test::expect_error(
        ErrorCode::file_malformed, [&] { (void)read_sliced_profile(path, options); }, path.string(),
        part);
  }

private:
  std::filesystem::path folder_;
};

TEST_F(SlicedProfileFile, HasItsSlicesAsCurves) {
  const SlicedProfile profile = read_sliced_profile(list("a.txt", 2, "0 0 20 99\n1 -1 20 999\n"));
  EXPECT_EQ(profile.name, "list");
  EXPECT_EQ(profile.kind, ProfileKind::rail);
  EXPECT_TRUE(profile.is_smoothed);
  EXPECT_TRUE(profile.corrections.empty());
  ASSERT_EQ(profile.slices.size(), 2U);
  EXPECT_EQ(profile.slices[1].place, 10.0);
  EXPECT_LT(distance_at(profile.slices[1].curve, rail_points()), 1e-12);
  const double length = profile.slices[0].curve.length();
  EXPECT_EQ(profile.slices[0].features[0], 0.0);
  EXPECT_NEAR(*profile.slices[0].features[1], 20.0, 0.01); // chords are shorter than arcs
  EXPECT_EQ(profile.slices[0].features[2], length);
  EXPECT_FALSE(profile.slices[1].features[0]);
}

TEST_F(SlicedProfileFile, SettlesUnitsAndHeightsOnceForAllSlices) {
  const SlicedProfile profile =
      read_sliced_profile(list("down.txt", 3, "0 0 20 99\n1 0 20 99\n2 0 20 99\n"));
  ASSERT_EQ(profile.corrections.size(), 2U);
  EXPECT_TRUE(profile.corrections[0].starts_with("points of all slices multiplied by 1000"));
  EXPECT_TRUE(profile.corrections[1].starts_with("heights of all slices mirrored"));
  EXPECT_LT(distance_at(profile.slices[2].curve, rail_points()), 1e-9);
  ReadOptions stated;
  stated.scale = 1.0;
  stated.mirror_height = false;
  stated.mirror_lateral = true;
  const SlicedProfile other =
      read_sliced_profile(list("a.txt", 2, "0 0 20 99\n1 0 20 99\n"), stated);
  EXPECT_LT(other.slices[0].curve.at(0.0).lateral, -33.0); // put in order again
  EXPECT_GT(other.slices[0].curve.at(0.0).height, other.slices[0].curve.at(1e9).height - 1.0);
}

TEST_F(SlicedProfileFile, FeaturesOfAWheelCountFromItsFieldSide) {
  const SlicedProfile profile =
      read_sliced_profile(list("flat.txt", 2, "0 0 20 -1\n1 0 20 -1\n", "wheel.slcw"));
  ASSERT_EQ(profile.kind, ProfileKind::wheel);
  const ProfileSlice& slice = profile.slices[0];
  EXPECT_FALSE(slice.features[0]);
  EXPECT_NEAR(slice.curve.at(*slice.features[1]).lateral, 34.0 - 20.0, 1e-9);
  EXPECT_NEAR(slice.curve.at(*slice.features[2]).lateral, 34.0, 1e-9);
  EXPECT_EQ(slice.curve.at(30.0).height, 0.0); // no column is skipped as constant
}

TEST_F(SlicedProfileFile, FindsFeaturesOfAListWithoutThem) {
  const std::string rows = rows_of(rail_points());
  (void)write("half.txt", rows.substr(rows.find('\n', rows.size() / 2) + 1));
  const SlicedProfile profile =
      read_sliced_profile(write("cut.slcs", "0 10\n3\n0\n1\n0 'a.txt'\n1 'a.txt'\n2 'half.txt'\n"));
  EXPECT_EQ(profile.slices[0].features.size(), 3U);
  EXPECT_FALSE(profile.slices[2].features[0]);
  EXPECT_EQ(profile.slices[2].features[1], 0.0);
  ASSERT_EQ(profile.corrections.size(), 2U);
  EXPECT_TRUE(profile.corrections[1].starts_with("between slices 2 and 3: the first "));
}

TEST_F(SlicedProfileFile, SmoothsOnRequestOnly) {
  ReadOptions options;
  options.smoothing_wavelength = 20.0;
  const auto path = list("a.txt", 2, "0 0 20 99\n1 0 20 99\n");
  EXPECT_GT(distance_at(read_sliced_profile(path, options).slices[0].curve, rail_points()), 1e-3);
}

TEST_F(SlicedProfileFile, RefusesFaultsWithFileSliceAndLine) {
  const std::string good = "0 0 20 99\n1 0 20 99\n";
  refuses(list("a.txt", 2, good, "list.txt"), "is no slices file");
  (void)write("one.txt", "1 2\n3\n");
  refuses(list("one.txt", 2, good), "slice 1 '");
  refuses(list("one.txt", 2, good), "one.txt':2: one number");
  (void)write("word.txt", "1 2\n3 x\n");
  refuses(list("word.txt", 2, good), "word.txt':2: 'x' is not a number");
  (void)write("short.txt", "1 2\n3 4\n");
  refuses(list("short.txt", 2, good), "2 points, at least 5 are needed");
  (void)write("small.txt", "0 0\n.1 0\n.2 0\n.3 0\n.4 0\n");
  ReadOptions millimetres;
  millimetres.scale = 1.0;
  ReadOptions enlarged;
  enlarged.scale = 1e4;
  refuses(list("small.txt", 2, good), "the points are 4000 mm long", enlarged);
  refuses(list("small.txt", 2, good), "the points are 0.4 mm long", millimetres);
  (void)write("far.txt", "200000 0\n200010 0\n200020 0\n200030 0\n200040 0\n");
  refuses(list("far.txt", 2, good), "at most 1e+05 mm", millimetres);
  (void)write("cusp.txt", "0 0\n10 0\n20 0\n10 0\n0 0\n");
  refuses(list("cusp.txt", 2, good), "turn back on themselves");
  (void)write("book.txt", "PK\x03\x04");
  refuses(list("book.txt", 2, good), "is an Excel workbook");
  refuses(list("list.slcs", 2, good), "is no profile in columns");
  refuses(list("a.ban", 2, good), "is no profile in columns");
  test::expect_error(
      ErrorCode::file_unreadable, [&] { (void)read_sliced_profile(list("none.txt", 2, good)); },
      "none.txt");
}

TEST_F(SlicedProfileFile, RefusesMorePointsThanTheLimitOfAllSlices) {
  std::string rows;
  for (std::size_t i = 0; i < 190000; ++i)
    rows += std::to_string(static_cast<double>(i) * 5e-4) + " 0\n";
  (void)write("many.txt", rows);
  std::string features;
  for (int i = 0; i < 12; ++i)
    features += std::to_string(i) + " 0 20 99\n";
  refuses(list("many.txt", 12, features), "more than 2000000 points up to slice 11");
}

} // namespace
} // namespace wrc::test::sliced_profile_test
