// Warnings of a wheel: each appears from its limit on, and says of which patch it is.
#include "wheel/wheel_warnings.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "patches/constants.hpp"
#include "wheel/constants.hpp"

namespace wrc::test::wheel_warnings_test {
namespace {

bool has(const Warnings& warnings, WarningClass kind) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [kind](const Warning& warning) { return warning.kind == kind; });
}

TEST(WheelWarnings, SeveralPatchesAreNumbered) {
  WheelResult wheel;
  wheel.patches.resize(1);
  EXPECT_EQ(of_patch(wheel, 0), "");
  wheel.patches.resize(2);
  EXPECT_EQ(of_patch(wheel, 1), "patch 1: ");
}

TEST(WheelWarnings, PressuresBeyondSteelAreReportedWithTheirPatch) {
  WheelResult wheel;
  wheel.details.request.combined_modulus = 115e3;
  wheel.patches.resize(2);
  wheel.patches[1].pmax = wheel.pmax = 0.999 * hardest_steel;
  warn_of_pressure(wheel);
  EXPECT_TRUE(wheel.warnings.empty());
  wheel.patches[1].pmax = wheel.pmax = 1.001 * hardest_steel;
  warn_of_pressure(wheel);
  ASSERT_EQ(wheel.warnings.size(), 1U);
  EXPECT_EQ(wheel.warnings.front().kind, WarningClass::pressure);
  EXPECT_TRUE(wheel.warnings.front().text.starts_with("patch 1: "));
  wheel.warnings.clear();
  wheel.details.request.combined_modulus = 1.001 * stiffest_steel;
  warn_of_pressure(wheel);
  EXPECT_TRUE(wheel.warnings.empty()) << "stiffer than steel";
}

TEST(WheelWarnings, ContactAtABoundaryDiffersFromContactAtTheGridEdge) {
  Patch patch;
  patch.penetration.y_first = 0.0;
  patch.penetration.y_last = 10.0;
  patch.contact.touches_edge.lateral_last = true;
  EXPECT_FALSE(reaches_neighbour(patch)) << "there is no neighbour";
  patch.penetration.limit_last = 10.0 + 0.9 * penetration_margin * 10.0;
  EXPECT_TRUE(reaches_neighbour(patch));
  patch.penetration.limit_last = 10.0 + 1.1 * penetration_margin * 10.0;
  EXPECT_FALSE(reaches_neighbour(patch));
  patch.penetration.limit_last = 10.0;
  patch.contact.touches_edge = {};
  patch.contact.touches_edge.lateral_first = true;
  EXPECT_FALSE(reaches_neighbour(patch)) << "of the other side";
}

TEST(WheelWarnings, ErrorsOfPlanesAboveTheAccuracyAreReported) {
  WheelRequest request;
  request.accuracy = 1e-2;
  WheelSolution solution;
  solution.patches.resize(1);
  Patch& patch = solution.patches.front();
  patch.plane_error = 0.99e-2;
  warn_of_patches(request, solution);
  EXPECT_TRUE(solution.warnings.empty());
  patch.plane_error = 1.01e-2;
  warn_of_patches(request, solution);
  EXPECT_TRUE(has(solution.warnings, WarningClass::patch_turn));
  solution.warnings.clear();
  request.gap = GapConvention::vertical;
  patch.penetration.angle_unturned = 1.01 * vertical_convention_limit;
  warn_of_patches(request, solution);
  ASSERT_EQ(solution.warnings.size(), 1U);
  EXPECT_EQ(solution.warnings.front().kind, WarningClass::vertical_angle);
}

TEST(WheelWarnings, MissedAccuraciesAreReported) {
  WheelRequest request;
  request.accuracy = 1e-2;
  GridSolution grid;
  WheelSolution solution;
  solution.discretisation_error = 0.9e-2;
  solution.model_error = 0.1e-2;
  warn_of_solution(grid, request, 460.0, {0.0, 0.0}, solution);
  EXPECT_FALSE(has(solution.warnings, WarningClass::accuracy));
  solution.discretisation_error = 1.1e-2;
  warn_of_solution(grid, request, 460.0, {2e-2, 0.0}, solution);
  EXPECT_TRUE(has(solution.warnings, WarningClass::accuracy));
  EXPECT_TRUE(has(solution.warnings, WarningClass::ridge));
  EXPECT_FALSE(has(solution.warnings, WarningClass::no_interaction));
  warn_of_solution(grid, request, 460.0, {0.0, 2e-2}, solution);
  EXPECT_TRUE(has(solution.warnings, WarningClass::no_interaction));
  solution.warnings.clear();
  solution.discretisation_error = 0.9e-2;
  solution.model_error = 1.1e-2;
  warn_of_solution(grid, request, 460.0, {0.0, 0.0}, solution);
  EXPECT_FALSE(has(solution.warnings, WarningClass::accuracy)) << "the warning is of the patch";
  solution.model_error = 0.9e-2;
  warn_of_solution(grid, request, 460.0, {0.0, 0.0}, solution);
  EXPECT_TRUE(has(solution.warnings, WarningClass::accuracy)) << "both together";
  solution.warnings.clear();
  solution.discretisation_error = 1.1e-2;
  request.grid = {{20, 20}};
  grid.stop_reason = StopReason::iteration_limit;
  warn_of_solution(grid, request, 460.0, {0.0, 0.0}, solution);
  EXPECT_FALSE(has(solution.warnings, WarningClass::accuracy)) << "of a grid by hand";
  EXPECT_TRUE(has(solution.warnings, WarningClass::not_converged));
}

} // namespace
} // namespace wrc::test::wheel_warnings_test
