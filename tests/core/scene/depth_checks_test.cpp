#include "scene/depth_checks.hpp"

#include <gtest/gtest.h>

#include "error.hpp"

namespace wrc::test {
namespace {

SideRequest loaded(double load) {
  SideRequest request;
  request.vertical_load = load;
  return request;
}

/// One patch of one element under pressure, overlapping by so much.
Trial trial_with(double overlap) {
  Trial trial;
  PatchTrial& patch = trial.patches.emplace_back();
  patch.grid = {1, 1, 1.0, 1.0, 0.0, 0.0};
  patch.share = 1.0;
  patch.distance = {-overlap};
  patch.pressure = {1.0};
  patch.contact = summarise_pressure(patch.grid, patch.pressure);
  return trial;
}

TEST(DepthChecks, ADepthOfBodiesThatDoNotFaceEachOtherIsRefused) {
  for (const double depth : {1002.5, 50.0, -50.0, -1002.5}) {
    try {
      check_depth_found(loaded(7e3), depth);
      ADD_FAILURE() << depth;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::no_contact);
      const std::string text = error.what();
      EXPECT_NE(text.find("7000 N"), std::string::npos) << text;
      EXPECT_NE(text.find("allowed is less than 50 mm"), std::string::npos) << text;
    }
  }
  EXPECT_NO_THROW(check_depth_found(loaded(7e3), 49.9));
  SideRequest prescribed;
  prescribed.vertical = 400.0;
  EXPECT_NO_THROW(check_depth_found(prescribed, 1002.5));
}

TEST(DepthChecks, OnlyTrialsInContactAreUnsettled) {
  std::vector<std::string> warnings;
  Trial trial = trial_with(0.1);
  mark_unsettled(trial, 21, warnings);
  EXPECT_EQ(trial.stop_reason, StopReason::iteration_limit);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("not settled"), std::string::npos);
  EXPECT_NE(warnings[0].find("21 solutions"), std::string::npos);
}

TEST(DepthChecks, RoundingIsFeltBelow30000RoundingsOfTheRadius) {
  // 3e4 eps 460 mm = 3.06e-9 mm.
  const auto warnings_at = [](double overlap, double radius) {
    std::vector<std::string> warnings;
    warn_of_rounding(trial_with(overlap), radius, warnings);
    return warnings.size();
  };
  EXPECT_EQ(warnings_at(3.0e-9, 460.0), 1U);
  EXPECT_EQ(warnings_at(3.1e-9, 460.0), 0U);
  EXPECT_EQ(warnings_at(3.1e-9, 5000.0), 1U);
  EXPECT_EQ(warnings_at(3.4e-8, 5000.0), 0U);
}

} // namespace
} // namespace wrc::test
