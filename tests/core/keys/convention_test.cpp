#include "keys/convention.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test::convention_test {
namespace {

using namespace dimensions;

constexpr Convention si_right_down{Units::si, TrackFrame::right_down};

TEST(Convention, ScalesOfSi) {
  constexpr Convention si{Units::si, TrackFrame::left_up};
  EXPECT_EQ(to_caller(1435.0, si, length), 1.435);
  EXPECT_EQ(to_caller(120.0, si, surface), 120e-6);
  EXPECT_EQ(to_caller(1000.0, si, stress), 1e9);
  EXPECT_EQ(to_caller(2000.0, si, moment), 2.0);
  EXPECT_EQ(to_caller(3.0, si, stiffness), 3000.0);
  EXPECT_EQ(to_caller(0.4, si, pure), 0.4);
}

TEST(Convention, OnlyRotatedComponentsChangeSign) {
  constexpr Convention right_down{Units::mm, TrackFrame::right_down};
  EXPECT_EQ(to_caller(2.0, right_down, turning_length), -2.0);
  EXPECT_EQ(to_caller(2.0, right_down, turning_moment), -2.0);
  EXPECT_EQ(to_caller(2.0, right_down, length), 2.0);
  EXPECT_FALSE(std::signbit(to_caller(0.0, right_down, turning_angle)));
}

TEST(Convention, ConversionsAreInvertible) {
  for (const Dimension& dimension :
       {pure, turning_angle, length, turning_length, surface, stress, moment, stiffness}) {
    for (const double value : {0.1, -7.3, 80000.0}) {
      EXPECT_DOUBLE_EQ(
          from_caller(to_caller(value, si_right_down, dimension), si_right_down, dimension), value);
    }
  }
}

} // namespace
} // namespace wrc::test::convention_test
