/// Writing profiles, and reading them back.
#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

#include <gtest/gtest.h>

#include "measured/nearest.hpp"
#include "measured/samples.hpp"
#include "profile/writers.hpp"
#include "support/errors.hpp"

namespace wrc::test::writers_test {
namespace {

/// Digits are written in full; what is left is the arithmetic of the curve.
constexpr double rounding = 1e-12;

class Writers : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("wrcontact_writers_") + test->name() + '_' + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(Writers, EveryFormatCanBeReadBackWithoutAGuess) {
  for (const auto& [name, file] : {std::pair{"S1002", "a.txt"}, std::pair{"S1002", "a.prw"},
                                   std::pair{"60E1", "b.txt"}, std::pair{"60E1", "b.prr"}}) {
    SCOPED_TRACE(file);
    const Profile profile = standard_profile(name);
    write_profile(profile, folder_ / file, 0.5);
    EXPECT_FALSE(std::filesystem::exists(folder_ / (std::string(file) + ".partial")));
    ReadOptions options;
    options.kind = profile.kind;
    options.strict = true;
    const Profile read = read_profile(folder_ / file, options).profile;
    EXPECT_EQ(read.kind, profile.kind);
    const auto count = static_cast<std::size_t>(std::ceil(profile.curve.length() / 0.5));
    std::vector<Position> expected;
    for (std::size_t i = 0; i <= count; ++i) {
      const CurvePoint point = profile.curve.at(profile.curve.length() * static_cast<double>(i) /
                                                static_cast<double>(count));
      expected.push_back({point.lateral, point.height});
    }
    EXPECT_LT(distance_at(read.curve, expected), rounding);
    // Between the points the spline rings at jumps of curvature and, worst, at the kink of the
    // chamfer (a few hundredths); elsewhere on the tread it is close.
    for (const double lateral : {-10.0, 0.0, 10.0})
      for (double s = 0.0; s < read.curve.length(); s += 0.1)
        if (std::abs(read.curve.at(s).lateral - lateral) < 0.1) {
          const CurvePoint point = read.curve.at(s);
          EXPECT_LT(distance_from(profile.curve, {point.lateral, point.height}), 1e-4);
        }
  }
}

TEST_F(Writers, SimpackTitleSurvives) {
  Profile profile = standard_profile("LM");
  profile.title = "it's a\nreconstruction";
  write_profile(profile, folder_ / "lm.prw", 1.0);
  EXPECT_EQ(read_profile(folder_ / "lm.prw").profile.title, "it s a reconstruction");
}

TEST_F(Writers, RefusesBadArguments) {
  const Profile wheel = standard_profile("S1002");
  for (const double spacing : {0.0, -1.0, 1e-6, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(write_profile(wheel, folder_ / "a.txt", spacing), Error) << spacing;
  EXPECT_THROW(write_profile(wheel, folder_ / "a.prr", 1.0), Error);
  EXPECT_THROW(write_profile(wheel, folder_ / "a.whl", 1.0), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Writers, AFailureLeavesOnlyTheOldFile) {
  // The target is a folder that is not empty: writing aside works, renaming does not.
  std::filesystem::create_directories(folder_ / "taken.txt" / "inside");
  test::expect_error(ErrorCode::file_unreadable,
                     [&] { write_profile(standard_profile("S1002"), folder_ / "taken.txt", 1.0); });
  EXPECT_TRUE(std::filesystem::exists(folder_ / "taken.txt" / "inside"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "taken.txt.partial"));
  EXPECT_THROW(write_profile(standard_profile("S1002"), folder_ / "no" / "a.txt", 1.0), Error);
}

} // namespace
} // namespace wrc::test::writers_test
