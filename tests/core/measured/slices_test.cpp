/// Slices files: what is listed, and what is refused.
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "measured/slices.hpp"
#include "samples.hpp"
#include "support/errors.hpp"

namespace wrc::test::slices_test {
namespace {

const std::string two_slices =
    "% a switch\n 100.0  1000.0 % offset, scale\n 2 % slices\n 1 0 0\n 2\n"
    " 0.5 'a.prr'\n 1.25, \"sub/b.prr\" % the tongue\n";

TEST(Slices, AreListedWithTheirPositions) {
  const std::vector<Slice> slices = read_slices(two_slices, "track/switch.slcs");
  ASSERT_EQ(slices.size(), 2U);
  EXPECT_DOUBLE_EQ(slices[0].place, 100500.0);
  EXPECT_DOUBLE_EQ(slices[1].place, 101250.0);
  EXPECT_EQ(slices[1].file, std::filesystem::path("track/sub/b.prr"));
  EXPECT_EQ(slices_text(slices, ProfileKind::rail),
            "2 slices: 1 at 100500 mm 'a.prr', 2 at 101250 mm 'b.prr'");
}

TEST(Slices, RefuseMalformedFiles) {
  const auto refuses = [](const std::string& text, const char* part) {
    test::expect_error(
        ErrorCode::file_malformed, [&] { (void)read_slices(text, "a.slcs"); }, part);
  };
  refuses("", "a.slcs: ends before offset and scale");
  refuses("0 1\n2\n", "ends before the number of features");
  refuses("0\n", "a.slcs:1: offset and scale of the places expected");
  refuses("0 1\n0\n", "0 slices, must be between 1 and 4999");
  refuses("0 1\n1.5\n", "1.5 slices, must be between 1 and 4999");
  refuses("0 1\n1\n1\n1\n0 a.prr\n",
          "a.slcs:5: '0 a.prr', expected a position and a file in quotes");
  refuses("0 1\n2\n1\n1\n0 'a'\n0 'b'\n", "place 0 after 0, places must ascend");
  refuses("x 1\n", "'x' is not a number");
  refuses("0 1\n1\n1\n3\n0 'a'\n", "interpolation 3, must be 1 or 2");
  refuses("0 1\n1 % slices\n1\n1\n0 'a'\n\n1 'b'\n2 'c'\n",
          "a.slcs:7: '1 'b'' after slice 1, the last of 1 that line 2 states");
  refuses("0 1e10\n2\n1\n1\n0 'a'\n1 'b'\n", "place 1e+10, must be between -1e+09 and 1e+09");
}

TEST(Slices, HaveFeaturesThatMayBeAbsent) {
  const SliceList list =
      read_slice_list("100 1000\n2\n3 0 0 NFEAT, NKINK, NACCEL\n1\n0.5 'a.prr'\n1.25 'b.prr'\n"
                      " 0.5 0.0 12.5 999. % the end\n 1.25 -1 13 40\n",
                      "a.slcs");
  EXPECT_FALSE(list.is_smoothed);
  ASSERT_EQ(list.slices.size(), 2U);
  ASSERT_EQ(list.slices[0].features.size(), 3U);
  EXPECT_EQ(list.slices[0].features[1], 12.5);
  EXPECT_EQ(list.slices[0].features[2], 999.0);
  EXPECT_FALSE(list.slices[1].features[0]);
  EXPECT_TRUE(read_slice_list(two_slices, "a.slcs").is_smoothed);
  EXPECT_TRUE(read_slice_list(two_slices, "a.slcs").slices[0].features.empty());
}

TEST(Slices, RefuseMalformedFeatures) {
  const auto refuses = [](const std::string& head, const std::string& features, const char* part) {
    test::expect_error(
        ErrorCode::file_malformed,
        [&] {
          (void)read_slice_list("0 1\n2\n" + head + "\n1\n0 'a'\n5 'b'\n" + features, "a.slcs");
        },
        part);
  };
  refuses("3", "0 0 1 2\n", "a.slcs: ends before the features of slice 2");
  refuses("3", "0 0 1 2\n5 0 1\n", "a.slcs:8: 3 numbers, slice 2 has its place and 3 features");
  refuses("3", "0 0 1 2\n6 0 1 2\n", "a.slcs:8: features at 6, slice 2 is at 5");
  refuses("3", "0 0 2 2\n", "a.slcs:7: feature 3 of slice 1 at 2 mm, features must ascend from 0");
  refuses("3", "0 -2 2 3\n", "feature 1 of slice 1 at -2 mm");
  refuses("3", "x 1 2 3\n", "a.slcs:7: the features of slice 1 expected");
  refuses("3", "0 nan 2 3\n", "'nan'");
  refuses("2", "0 0 1\n5 0 1\n6 0 1\n",
          "a.slcs:9: '6 0 1' after the features of slice 2, the last of 2 that line 2 states");
  refuses("0", "% features\nmore\n", "a.slcs:8: 'more' after slice 2, the last of 2");
  refuses("201", "", "201 features, must be between 0 and 200");
  refuses("1.5", "", "1.5 features");
  refuses("-1", "", "-1 features");
  refuses("3 1 0", "", "has kinks or accelerations");
  refuses("3 0 2", "", "has kinks or accelerations");
}

class SlicesFile : public ::testing::Test {
protected:
  SlicesFile()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ("wrcontact_slices_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~SlicesFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

private:
  std::filesystem::path folder_;
};

TEST_F(SlicesFile, OneSliceIsReadAsAProfile) {
  (void)write("a.txt", rows_of(rail_points()));
  const auto path = write("a.slcs", "0 1\n2\n1\n1\n0 'a.txt'\n5 'b.slcs'\n");
  ReadOptions options;
  options.slice = 1;
  const ReadResult read = read_profile(path, options);
  EXPECT_EQ(read.profile.kind, ProfileKind::rail);
  EXPECT_LT(distance_at(read.profile.curve, rail_points()), 1e-12);
  EXPECT_TRUE(says(read, "slice 1 of 2, at 0 mm, as a profile that is the same everywhere"));
  const auto refuses = [&](int slice, const char* part) {
    options.slice = slice;
    test::expect_error(
        ErrorCode::file_malformed, [&] { (void)read_profile(path, options); }, part);
  };
  refuses(0, "slice = 0, must be between 1 and 2 of its 2 slices: 1 at 0 mm 'a.txt'");
  refuses(3, "slice = 3");
  refuses(2, "a slice is itself a slices file");
}

} // namespace
} // namespace wrc::test::slices_test
