#include "patches/contact_frame.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test::contact_frame_test {
namespace {

constexpr double rounding = 1e-13;

void expect_equal(const Vector3& one, const Vector3& other) {
  EXPECT_NEAR(one.x, other.x, rounding);
  EXPECT_NEAR(one.y, other.y, rounding);
  EXPECT_NEAR(one.z, other.z, rounding);
}

TEST(ContactFrame, TangentAxesRiseToTheFieldSideByTheAngle) {
  const ContactFrame frame = tangent_frame({1.0, 2.0, 3.0}, 0.3);
  EXPECT_NEAR(frame.angle(), 0.3, rounding);
  EXPECT_GT(frame.lateral.z, 0.0);
  expect_equal(cross(frame.longitudinal, frame.lateral), frame.normal);
  expect_equal(frame.to_track(5.0, 0.0, 0.0), {6.0, 2.0, 3.0});
  expect_equal(frame.to_track(0.0, 2.0, 0.0),
               {1.0, 2.0 + 2.0 * std::cos(0.3), 3.0 + 2.0 * std::sin(0.3)});
  expect_equal(frame.to_track(0.0, 0.0, 2.0),
               {1.0, 2.0 - 2.0 * std::sin(0.3), 3.0 + 2.0 * std::cos(0.3)});
}

TEST(ContactFrame, VerticalAxesAreThoseOfTheWheelset) {
  const Pose pose{0.0, 0.02, -0.01};
  const ContactFrame frame = vertical_frame({}, Rotation(pose));
  EXPECT_NEAR(frame.angle(), pose.roll, rounding);
  EXPECT_NEAR(std::atan2(frame.longitudinal.y, frame.longitudinal.x), pose.yaw, rounding);
  expect_equal(cross(frame.longitudinal, frame.lateral), frame.normal);
}

} // namespace
} // namespace wrc::test::contact_frame_test
