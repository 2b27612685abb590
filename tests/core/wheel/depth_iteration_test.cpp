// The secant method for the depth.
#include "wheel/depth_iteration.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test::depth_iteration_test {
namespace {

TEST(DepthIteration, EndsWhereLittleChanges) {
  DepthIteration iteration;
  EXPECT_FALSE(iteration.next(0.1, 0.11, 1.0));
  EXPECT_TRUE(iteration.next(0.1, 0.11, 1.001));
}

/// Steps begin from nothing at the limit, so that depths have no jump there.
TEST(DepthIteration, CountsAStepByHowFarItExceedsTheLimit) {
  EXPECT_NEAR(*DepthIteration().next(0.1, 0.11, 1.0 + 1e-6), 0.1, 1e-7);
  EXPECT_NEAR(*DepthIteration().next(0.1, 0.11, 4.0 / 3.0), 0.105, 1e-12);
  EXPECT_NEAR(*DepthIteration().next(0.1, 0.11, 2.0), 0.11, 1e-12);
  EXPECT_NEAR(*DepthIteration().next(0.1, 0.11, 50.0), 0.11, 1e-12);
}

/// What solutions ask for halves its distance to the answer only: the secant finds it at once.
TEST(DepthIteration, FindsTheAnswerOfALinearLawByItsSecondStep) {
  const auto asked = [](double depth) { return 0.2 + 0.5 * (depth - 0.2); };
  DepthIteration iteration;
  double depth = 0.1;
  for (int step = 0; step < 2; ++step) {
    depth = *iteration.next(depth, asked(depth), 10.0);
  }
  EXPECT_NEAR(depth, 0.2, 1e-12);
}

TEST(DepthIteration, NeverLeavesTheTouch) {
  const double depth = *DepthIteration().next(1.0, -5.0, 10.0);
  EXPECT_NEAR(depth, min_depth_ratio, 1e-15);
}

} // namespace
} // namespace wrc::test::depth_iteration_test
