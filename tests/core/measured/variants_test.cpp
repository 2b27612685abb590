/// Files of 60E1 and S1002 as people have them: each is read right, or what is wrong is
/// told; none is wrong in silence.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "extent.hpp"
#include "measured/profile_shape.hpp"
#include "nearest.hpp"
#include "variants.hpp"

namespace wrc::test::variants_test {
namespace {

namespace fs = std::filesystem;

class ProfileVariants : public ::testing::Test {
protected:
  ProfileVariants()
      : folder_(fs::path(::testing::TempDir()) /
                ("wrcontact_variants_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~ProfileVariants() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path written(const Variant& variant) const {
    fs::path path = folder_ / variant.name;
    std::ofstream(path, std::ios::binary) << variant.bytes;
    return path;
  }

private:
  fs::path folder_;
};

/// Whether the points are those of the standard, from its one end to the other.
bool is_right(const ReadResult& read, const Variant& variant, double tolerance) {
  const Curve standard =
      standard_profile(variant.kind == ProfileKind::wheel ? "S1002" : "60E1").curve;
  if (read.profile.kind != variant.kind)
    return false;
  for (const Position& point : read.measured)
    if (!(distance_from(standard, point) <= tolerance))
      return false;
  const std::vector<Position> points = standard_points(variant.kind);
  for (std::size_t i = 0; i < 2; ++i) {
    const Position found = reading::extent_of(read.measured, i);
    const Position expected = reading::extent_of(points, i);
    if (std::abs(found[0] - expected[0]) > tolerance ||
        std::abs(found[1] - expected[1]) > tolerance)
      return false;
  }
  return true;
}

std::string all_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    text += line + '\n';
  return text;
}

std::vector<std::string> texts_of(const Warnings& warnings) {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings)
    texts.push_back(warning.text);
  return texts;
}

void expect_lines(const std::vector<std::string>& found, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(all_lines(found).find(part), std::string::npos) << "\"" << part << "\" is not in\n"
                                                              << all_lines(found);
}

TEST_F(ProfileVariants, AreReadCorrectlyOrReported) {
  const std::vector<Variant> variants = all_variants();
  EXPECT_GE(variants.size(), 150U);
  std::set<std::string> names;
  for (const Variant& variant : some_of(variants, 40)) {
    SCOPED_TRACE(variant.name);
    EXPECT_TRUE(names.insert(variant.name).second) << "twice";
    try {
      const ReadResult read = read_profile(written(variant), variant.options);
      EXPECT_TRUE(variant.refusal.empty()) << "accepted";
      expect_lines(read.corrections, variant.corrections);
      expect_lines(texts_of(read.profile.warnings), variant.warnings);
      const bool expected_right = variant.tolerance > 0.0;
      EXPECT_EQ(expected_right, is_right(read, variant, expected_right ? variant.tolerance : 0.1))
          << all_lines(read.corrections) << all_lines(texts_of(read.profile.warnings));
      EXPECT_EQ(read.profile.warnings.empty(), expected_right && variant.warnings.empty())
          << all_lines(texts_of(read.profile.warnings));
    } catch (const Error& error) {
      EXPECT_FALSE(variant.refusal.empty()) << error.what();
      EXPECT_NE(std::string(error.what()).find(variant.refusal), std::string::npos) << error.what();
    }
  }
  RecordProperty("variants", static_cast<int>(variants.size()));
}

TEST_F(ProfileVariants, OnlyPlainFilesPassStrictReading) {
  for (const Variant& variant : some_of(all_variants(), 40)) {
    SCOPED_TRACE(variant.name);
    ReadOptions options = variant.options;
    options.strict = true;
    try {
      const ReadResult read = read_profile(written(variant), options);
      EXPECT_TRUE(variant.is_plain);
      EXPECT_TRUE(std::ranges::all_of(read.profile.warnings, [](const Warning& warning) {
        return warning.kind == WarningClass::profile_noise;
      }));
    } catch (const Error& error) {
      EXPECT_FALSE(variant.is_plain) << error.what();
    }
  }
}

} // namespace
} // namespace wrc::test::variants_test
