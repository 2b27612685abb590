/// What is said of a surface of slices.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "scene/profile_surface.hpp"
#include "support/errors.hpp"

namespace wrc::test::profile_surface_test {
namespace {

class ProfileSurfaceFile : public ::testing::Test {
protected:
  ProfileSurfaceFile()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ("wrcontact_surface_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    std::string rows;
    std::string tent;
    for (int y = -30; y <= 30; ++y) {
      rows += std::to_string(y) + " " + std::to_string(-y * y / 600.0) + "\n";
      tent += std::to_string(y) + " " + std::to_string(-2.0 * std::abs(y)) + "\n";
    }
    (void)write("a.txt", rows);
    (void)write("tent.txt", tent);
  }
  ~ProfileSurfaceFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

private:
  std::filesystem::path folder_;
};

TEST_F(ProfileSurfaceFile, BlamesTheCallerForTheLengthThatHeGives) {
  const auto path = write("three.slcs", "0 1\n3\n0\n1\n0 'a.txt'\n1 'tent.txt'\n2 'a.txt'\n");
  expect_error(
      ErrorCode::invalid_argument, [&] { (void)ProfileSurface(path, {}, 1e6); },
      "smoothing length");
}

TEST_F(ProfileSurfaceFile, SaysItsSlicesFeaturesAndSheets) {
  const auto path = write("rail.slcs", "0 10\n4\n3\n2\n0 'a.txt'\n1 'a.txt'\n2 'a.txt'\n4 'a.txt'\n"
                                       "0 -1 20 999\n1 0 20 999\n2 0 20 999\n4 0 20 -1\n");
  const ProfileSurface surface(path, {}, {});
  const std::vector<std::string> lines = surface.summary();
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[0], "rail with 4 slices along the track, 0 to 40 mm, 10 to 20 mm apart");
  EXPECT_EQ(lines[1], "smoothed along the track: waves of 40 mm are halved");
  EXPECT_EQ(lines[2], "3 features");
  EXPECT_EQ(lines[3], "feature 1 absent from slice 1");
  EXPECT_EQ(lines[4], "feature 3 absent from slice 4");
  EXPECT_TRUE(lines[5].starts_with("surface 1: features 1 to 2, slices 2 to 4, 10 to 40 mm, "));
  EXPECT_TRUE(lines[6].starts_with("surface 2: features 2 to 3, slices 1 to 3, 0 to 20 mm, "));
  EXPECT_EQ(lines[7], "between slices the surface is nowhere above or below both");
  EXPECT_EQ(surface.sheets().size(), 2U);
  EXPECT_EQ(surface.profile().name, "rail");
}

TEST_F(ProfileSurfaceFile, SaysThatAWheelIsClosed) {
  const auto path = write("wheel.slcw", "0 1\n2\n0\n1\n0 'a.txt'\n1 'a.txt'\n");
  const std::vector<std::string> lines = ProfileSurface(path, {}, 0.0).summary();
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "wheel with 2 slices around the wheel, 0 to 1 rad, 1 rad apart");
  EXPECT_TRUE(lines[3].starts_with("surface 1: slices 1 to 2, closed around the wheel, "));
}

TEST_F(ProfileSurfaceFile, RefusesAFoldWithTheFile) {
  const auto path = write("fold.slcs", "0 10\n2\n3\n1\n0 'tent.txt'\n1 'tent.txt'\n"
                                       "0 0 30 999\n1 0 110 999\n");
  test::expect_error(
      ErrorCode::file_malformed, [&] { ProfileSurface(path, {}, {}); }, path.string(),
      "the surface folds between slices 1 and 2");
}

} // namespace
} // namespace wrc::test::profile_surface_test
