#include "base/smoothstep.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace wrc::test::smoothstep_test {
namespace {

TEST(Smoothstep, RisesFromZeroToOneAndIsOddAboutTheMiddle) {
  EXPECT_EQ(smooth_rise(0.0), 0.0);
  EXPECT_EQ(smooth_rise(0.5), 0.5);
  EXPECT_EQ(smooth_rise(1.0), 1.0);
  EXPECT_EQ(smooth_rise(0.25), 0.15625); // 3/16 - 2/64
  for (double t = 0.0; t <= 1.0; t += 0.0625) {
    EXPECT_EQ(smooth_rise(t) + smooth_rise(1.0 - t), 1.0) << t;
    EXPECT_EQ(smoothstep(t), smooth_rise(t)) << t;
  }
}

TEST(Smoothstep, StaysAtItsEndsBeyondThem) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double beyond : {1e-300, 0.5, 1e300, infinity}) {
    EXPECT_EQ(smoothstep(-beyond), 0.0);
    EXPECT_EQ(smoothstep(1.0 + beyond), 1.0);
  }
}

} // namespace
} // namespace wrc::test::smoothstep_test
