// The wheelset's rotation as a matrix product, its signs, and the mirror.
#include "geometry/frames.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test::frames_test {
namespace {

constexpr Pose pose{3.0, 0.02, -0.013};
constexpr double rounding = 1e-13; ///< of coordinates of the order of 100

void expect_near(const Vector3& found, const Vector3& expected) {
  EXPECT_NEAR(found.x, expected.x, rounding);
  EXPECT_NEAR(found.y, expected.y, rounding);
  EXPECT_NEAR(found.z, expected.z, rounding);
}

TEST(Frames, RotationIsRollAndThenYaw) {
  const Rotation rotation(pose);
  for (const Vector3& v : {Vector3{100.0, 0.0, 0.0}, Vector3{0.0, 100.0, 0.0},
                           Vector3{0.0, 0.0, 100.0}, Vector3{30.0, -70.0, 45.0}}) {
    const Vector3 rolled{v.x, std::cos(pose.roll) * v.y - std::sin(pose.roll) * v.z,
                         std::sin(pose.roll) * v.y + std::cos(pose.roll) * v.z};
    expect_near(rotation.to_track(v),
                {std::cos(pose.yaw) * rolled.x - std::sin(pose.yaw) * rolled.y,
                 std::sin(pose.yaw) * rolled.x + std::cos(pose.yaw) * rolled.y, rolled.z});
    expect_near(rotation.to_body(rotation.to_track(v)), v);
  }
}

TEST(Frames, PositiveRollLiftsTheLeftWheelAndPositiveYawTurnsItBack) {
  const Vector3 left_wheel{0.0, 750.0, 0.0};
  EXPECT_GT(Rotation({0.0, 0.0, 0.01}).to_track(left_wheel).z, 7.0);
  EXPECT_LT(Rotation({0.0, 0.01, 0.0}).to_track(left_wheel).x, -7.0);
}

TEST(Frames, MirroredPoseTurnsTheMirrorImageAlike) {
  const Vector3 v{30.0, -70.0, 45.0};
  const Vector3 turned = Rotation(pose).to_track(v);
  const Vector3 seen = Rotation(mirrored(pose)).to_track({v.x, -v.y, v.z});
  EXPECT_EQ(seen.x, turned.x);
  EXPECT_EQ(seen.y, -turned.y);
  EXPECT_EQ(seen.z, turned.z);
  EXPECT_EQ(mirrored(pose).lateral, -pose.lateral);
}

TEST(Frames, ProductsOfVectorsAreRightHanded) {
  const Vector3 a{1.0, 2.0, -0.5};
  const Vector3 b{-3.0, 0.25, 4.0};
  const Vector3 product = cross(a, b);
  EXPECT_NEAR(dot(product, a), 0.0, rounding);
  EXPECT_NEAR(dot(product, b), 0.0, rounding);
  EXPECT_NEAR(dot(product, product), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 1e-10);
  expect_near(cross(Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}), {0.0, 0.0, 1.0});
  expect_near(2.0 * (a + b) - a - b, a + b);
}

} // namespace
} // namespace wrc::test::frames_test
