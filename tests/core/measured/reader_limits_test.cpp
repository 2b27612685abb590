/// Readers against files that are far too large: refused with the reason, before much memory is
/// taken. Files are sparse where their content does not matter.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "counting_allocator.hpp"
#include "profile/limits.hpp"
#include "samples.hpp"

namespace wrc::test::reader_limits_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr std::size_t most_memory = 200 * megabyte;

class ReaderLimits : public ::testing::TestWithParam<const char*> {
protected:
  ReaderLimits()
      : path_(fs::path(::testing::TempDir()) / ("wrcontact_limits_" + std::to_string(getpid()) +
                                                '_' + (GetParam() + 1) + GetParam())) {}
  ~ReaderLimits() override { fs::remove(path_); }

  void write(const std::string& text, std::size_t size) const {
    std::ofstream(path_) << text;
    fs::resize_file(path_, size);
  }
  /// The text of the refusal, without the file's name; checks the memory it took.
  [[nodiscard]] std::string refusal() const {
    reset_peak_memory();
    const std::size_t before = memory_in_use();
    std::string text = "accepted";
    try {
      (void)read_profile(path_);
    } catch (const Error& error) {
      text = error.what();
      EXPECT_TRUE(text.starts_with(path_.string()));
      text.erase(0, path_.string().size());
    }
    EXPECT_LT(peak_memory() - before, most_memory) << text;
    return text;
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

TEST_P(ReaderLimits, RefuseAGigabyte) {
  write("garbage", 1024 * megabyte);
  EXPECT_TRUE(contains(refusal(), ": is larger than 67108864 bytes"));
}

TEST_P(ReaderLimits, RefuseLinesLongerThanTheLimit) {
  write("1 2", 100 * megabyte);
  EXPECT_TRUE(contains(refusal(), ": is larger than"));
  write("1 2", 60 * megabyte);
  EXPECT_TRUE(contains(refusal(), ":1: line of 62914560 bytes"));
}

TEST_P(ReaderLimits, RefuseTenMillionPoints) {
  const std::string extension = GetParam();
  std::string text = extension == ".prw"   ? "spline.begin\npoint.begin\n"
                     : extension == ".whl" ? "ColumnDef=X,Y\n\n"
                                           : "";
  constexpr std::size_t points = 10000000;
  {
    std::ofstream file(path());
    file << text;
    text.clear();
    for (int i = 0; i < 1000; ++i)
      text += "1 2\n";
    for (std::size_t written = 0; written < points; written += 1000)
      file << text;
  }
  EXPECT_TRUE(contains(refusal(), ": more than 200000 points"));
}

INSTANTIATE_TEST_SUITE_P(Formats, ReaderLimits, ::testing::Values(".txt", ".prw", ".whl"),
                         [](const auto& format) { return std::string(format.param + 1); });

TEST(PointLimits, RefuseTenMillionPointsFromAProgram) {
  const std::vector<Position> points(10000000, Position{1.0, 2.0});
  reset_peak_memory();
  const std::size_t before = memory_in_use();
  EXPECT_THROW((void)profile_through(points, "points", {}), Error);
  EXPECT_LT(peak_memory() - before, most_memory);
}

TEST(PointLimits, TheMostPointsAllowedAreRead) {
  std::string rows;
  for (std::size_t i = 0; i < ReadLimits::max_points; ++i) {
    const double y = 140.0 * static_cast<double>(i) / ReadLimits::max_points - 70.0;
    rows += text_of(y) + ' ' + text_of(28.0 * std::exp(-0.01 * (y + 50.0) * (y + 50.0))) + '\n';
  }
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  options.least_point_distance = 1e-6;
  reset_peak_memory();
  const std::size_t before = memory_in_use();
  const ReadResult read = read_profile_text(rows, ProfileFormat::columns, "sample", options);
  EXPECT_EQ(read.profile.points.size(), ReadLimits::max_points);
  EXPECT_LT(peak_memory() - before, most_memory);
}

} // namespace
} // namespace wrc::test::reader_limits_test
