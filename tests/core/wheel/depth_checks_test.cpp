#include "wheel/depth_checks.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"
#include "wheel/constants.hpp"

namespace wrc::test::depth_checks_test {
namespace {

WheelRequest loaded(double load) {
  WheelRequest request;
  request.vertical_load = load;
  return request;
}

/// One patch of one element under pressure, overlapping by so much.
GridSolution solution_with(double overlap) {
  GridSolution solution;
  Patch& patch = solution.patches.emplace_back();
  patch.grid = {1, 1, 1.0, 1.0, 0.0, 0.0};
  patch.undeformed_distance = {-overlap};
  patch.pressure = {1.0};
  patch.contact = summarise_pressure(patch.grid, patch.pressure);
  return solution;
}

TEST(DepthChecks, ADepthOfBodiesThatDoNotFaceEachOtherIsRefused) {
  for (const double depth : {1002.5, 50.0, -50.0, -1002.5}) {
    expect_error(
        ErrorCode::no_contact, [&] { check_found_depth(loaded(7e3), depth); }, "7000 N",
        "must be less than 50 mm");
  }
  EXPECT_NO_THROW(check_found_depth(loaded(7e3), 49.9));
  WheelRequest prescribed;
  prescribed.vertical = 400.0;
  EXPECT_NO_THROW(check_found_depth(prescribed, 1002.5));
}

TEST(DepthChecks, AnAbandonedSolutionIsNotConverged) {
  Warnings warnings;
  GridSolution solution = solution_with(0.1);
  mark_unsettled(solution, 21, warnings);
  EXPECT_EQ(solution.stop_reason, StopReason::iteration_limit);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].text.find("not settled"), std::string::npos);
  EXPECT_NE(warnings[0].text.find("21 solutions"), std::string::npos);
}

/// What is warned about one square element, which overlaps by much, under a pressure.
struct RoundedElement {
  double side = 1e-5;
  double pressure = 1.0;
  double radius = 460.0;
  double angle = 0.0;
  double overlap = 1.0;
  double left = 1e-3; ///< of the accuracy, for rounding
  AccuracyOf accuracy_of = AccuracyOf::forces;

  [[nodiscard]] Warnings warnings() const {
    GridSolution solution = solution_with(overlap);
    Patch& patch = solution.patches.front();
    patch.frame = tangent_frame({0.0, 750.0, 0.0}, angle);
    patch.grid = {1, 1, side, side, 0.0, 0.0};
    patch.pressure = {pressure};
    patch.contact = summarise_pressure(patch.grid, patch.pressure);
    WheelRequest request;
    request.combined_modulus = 1e5;
    request.accuracy = left / warned_rounding;
    request.accuracy_of = accuracy_of;
    Warnings warnings;
    warn_of_rounding(solution, request, radius, warnings);
    return warnings;
  }
  [[nodiscard]] bool warned() const { return !warnings().empty(); }
};

TEST(DepthChecks, PressuresOnSmallElementsAreSensitiveToRounding) {
  // 2 * 0.9069 * 1e5 MPa * eps / 2 * 460 mm * sqrt(2) / 1e-5 mm = 1.310e-3 MPa.
  EXPECT_TRUE((RoundedElement{.pressure = 1.30}.warned()));
  EXPECT_FALSE((RoundedElement{.pressure = 1.32}.warned()));
  EXPECT_TRUE((RoundedElement{.pressure = 13.0, .left = 1e-4}.warned()));
  EXPECT_FALSE((RoundedElement{.pressure = 13.2, .left = 1e-4}.warned()));
  EXPECT_TRUE((RoundedElement{.side = 1e-6, .pressure = 13.0}.warned()));
  EXPECT_FALSE((RoundedElement{.side = 1e-6, .pressure = 13.2}.warned()));
  EXPECT_TRUE((RoundedElement{.pressure = 14.1, .radius = 5000.0}.warned()));
  EXPECT_FALSE((RoundedElement{.pressure = 14.3, .radius = 5000.0}.warned()));
}

TEST(DepthChecks, StripsOfASectionAreMoreSensitiveToRounding) {
  // As above, but sqrt(1 + 64^2) in place of sqrt(2): at least 64 strips, here in one row.
  const AccuracyOf pressures = AccuracyOf::pressures;
  EXPECT_TRUE((RoundedElement{.pressure = 59.2, .accuracy_of = pressures}.warned()));
  EXPECT_FALSE((RoundedElement{.pressure = 59.4, .accuracy_of = pressures}.warned()));
}

TEST(DepthChecks, SteepContactIsSensitiveToRoundingOfLateralPositions) {
  // At 1.5 rad 0.0707 of the radius, along and across, and 0.997 of the 750 mm across.
  EXPECT_TRUE((RoundedElement{.pressure = 1.50, .angle = 1.5}.warned()));
  EXPECT_FALSE((RoundedElement{.pressure = 1.52, .angle = 1.5}.warned()));
  EXPECT_TRUE((RoundedElement{.pressure = 1.50, .angle = -1.5}.warned()));
}

TEST(DepthChecks, AnOverlapBelowTheTableToleranceIsReported) {
  EXPECT_FALSE((RoundedElement{.pressure = 1e9, .overlap = 2.1e-9}.warned()));
  const auto warnings = RoundedElement{.pressure = 1e9, .overlap = 1.0e-9}.warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].text.find("overlap by only 1e-09 mm: below 2e-09 mm"), std::string::npos)
      << warnings[0].text;
  EXPECT_NE(warnings[0].text.find("accuracy of " + text_of(1e-3 / warned_rounding)),
            std::string::npos)
      << warnings[0].text;
}

} // namespace
} // namespace wrc::test::depth_checks_test
