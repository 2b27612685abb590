// First touches on flange tip and chamfer raise warnings, those on tread, root and flank do not.
#include "geometry/first_touch.hpp"

#include <string>

#include <gtest/gtest.h>

#include "profile/profile.hpp"

namespace wrc::test::first_touch_test {
namespace {

const WheelSurface& wheel() {
  static const WheelSurface surface(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  return surface;
}

std::optional<Warning> touch_at(double lateral) {
  ContactCandidate touch;
  touch.wheel.lateral = lateral;
  touch.wheel.height = wheel().graph().at_lateral(lateral).height;
  return warning_of_touch(wheel(), touch);
}

TEST(FirstTouch, OnTreadRootAndFlankRaisesNoWarning) {
  for (const double lateral : {0.0, 20.0, -20.0, -35.0, -38.0, -42.0}) {
    EXPECT_FALSE(touch_at(lateral)) << lateral;
  }
}

TEST(FirstTouch, OnTheFlangeTipRaisesAWarning) {
  // The tip of S1002 is 55 mm from the taping line.
  for (const double lateral : {-53.5, -55.0, -57.0}) {
    const std::optional<Warning> warning = touch_at(lateral);
    ASSERT_TRUE(warning) << lateral;
    EXPECT_EQ(warning->kind, WarningClass::flange_tip);
  }
}

TEST(FirstTouch, OnTheChamferRaisesAWarningWithThePlace) {
  // 5 mm at 45 degrees up to the field side, which is 65 mm from the taping line.
  const std::optional<Warning> warning = touch_at(62.0);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, WarningClass::chamfer);
  EXPECT_NE(warning->text.find("s_wheel 62 mm"), std::string::npos) << warning->text;
}

} // namespace
} // namespace wrc::test::first_touch_test
