#include "accuracy/model_error.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace wrc::test::model_error_test {
namespace {

TEST(ModelError, PartsOfOnePlaneTurnTogether) {
  const SurfaceTurn one{1.0, 0.1, 0.02, 0.07, 0.13};
  const SurfaceTurn other{3.0, -0.1, 0.04, -0.16, -0.03};
  const SurfaceTurn both = combined_turn(one, other);
  EXPECT_NEAR(both.mean, -0.05, 1e-15);
  EXPECT_NEAR(both.deviation,
              std::sqrt(0.25 * (0.02 * 0.02 + 0.15 * 0.15) + 0.75 * (0.04 * 0.04 + 0.05 * 0.05)),
              1e-15);
  EXPECT_NEAR(both.range(), 0.29, 1e-15);
  EXPECT_EQ(combined_turn({}, one).mean, 0.1);
}

Patch patch_with(double force, double pmax, const SurfaceTurn& turn) {
  Patch patch;
  patch.frame = tangent_frame({}, 0.5);
  patch.normal_force = force;
  patch.contact.element_count = 1;
  patch.contact.peak_pressure = pmax;
  patch.turn = turn;
  return patch;
}

/// Forces count by their share, the largest pressure by itself.
TEST(ModelError, OfAWheelIsThatOfItsPatches) {
  GridSolution solution;
  solution.patches = {patch_with(1000.0, 500.0, {1.0, 0.0, 0.1, -0.2, 0.2}),
                      patch_with(3000.0, 2000.0, {1.0, 0.05, 0.0, 0.05, 0.05})};
  const double first = 0.03 * 0.16; // more than 1e-3 / cos(0.5)
  const double second = 0.4 * 2.5e-3 / std::cos(0.5);
  EXPECT_NEAR(estimate_model_error(solution, AccuracyOf::forces), 0.25 * first + 0.75 * second,
              1e-12);
  EXPECT_NEAR(solution.patches[0].plane_error, first, 1e-12);
  EXPECT_NEAR(estimate_model_error(solution, AccuracyOf::forces, true),
              0.25 * 1.5 * first + 0.75 * second, 1e-12);
  // 0.07 of 0.16, of a pressure a quarter of the largest.
  EXPECT_NEAR(estimate_model_error(solution, AccuracyOf::pressures), 0.0112 / 4.0, 1e-12);
  EXPECT_NEAR(solution.patches[0].plane_error, 0.0112, 1e-12);
  EXPECT_NEAR(solution.patches[0].plane_force_error, first, 1e-12);
  EXPECT_NEAR(solution.patches[1].plane_error, second, 1e-12);
  GridSolution nothing;
  EXPECT_EQ(estimate_model_error(nothing, AccuracyOf::forces), 0.0);
}

/// As much as one that turns evenly with the same deviation; along a curve that has the kink, none.
TEST(ModelError, AKinkCountsByItsSquare) {
  GridSolution solution;
  solution.patches = {patch_with(1000.0, 500.0, {1.0, 0.0, 0.0, 0.0, 0.02})};
  const double smooth = estimate_model_error(solution, AccuracyOf::forces);
  EXPECT_NEAR(smooth, 0.03 * 4e-4, 1e-12);
  solution.patches[0].ridge = 0.7;
  EXPECT_NEAR(estimate_model_error(solution, AccuracyOf::forces), smooth + 0.15 * 0.49, 1e-12);
  EXPECT_NEAR(solution.patches[0].plane_force_error, smooth + 0.15 * 0.49, 1e-12);
  EXPECT_NEAR(depth_error_of_kink({1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.35}, 0.7), 0.0, 1e-12);
}

/// Force over pi E* times the distance, over the overlap, by 1.5; weighted with the forces.
TEST(ModelError, OfPatchesCountsWhatTheirInteractionLeavesOut) {
  constexpr double modulus = 1e5;
  GridSolution solution;
  solution.patches = {patch_with(2000.0, 500.0, {}), patch_with(6000.0, 500.0, {})};
  solution.patches[1].frame.origin = {0.0, 6.0, 8.0};
  for (Patch& patch : solution.patches) {
    patch.grid = {1, 1, 1.0, 1.0, 0.0, 0.0};
    patch.undeformed_distance = {-0.02};
  }
  const double by_force = 1.5 / (std::numbers::pi * modulus * 10.0 * 0.02);
  const double alone = (2000.0 * 6000.0 + 6000.0 * 2000.0) * by_force / 8000.0;
  EXPECT_NEAR(interaction_error(solution, modulus), alone, 1e-12);
  solution.interaction = PatchInteraction{{{0.0, 0.0}, {10.0, 0.0}}, {1.0, 0.8, 0.8, 1.0}};
  EXPECT_NEAR(interaction_error(solution, modulus), 0.2 * alone, 1e-12);
  solution.patches[1].contact.element_count = 0;
  EXPECT_EQ(interaction_error(solution, modulus), 0.0);
}

} // namespace
} // namespace wrc::test::model_error_test
