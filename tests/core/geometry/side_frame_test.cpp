/// Signs of the mirror, against vectors and moments that are mirrored one by one.
#include "geometry/side_frame.hpp"

#include <gtest/gtest.h>

namespace wrc::test::side_frame_test {
namespace {

class SideFrames : public testing::TestWithParam<double> {};

TEST_P(SideFrames, MomentsAreThoseOfMirroredForcesAtMirroredPlaces) {
  const double mirror = GetParam();
  const SideFrame frame(mirror);
  EXPECT_EQ(frame.mirror(), mirror);
  const Vector3 force{3.0, 5.0, 7.0};
  const Vector3 arm{11.0, 13.0, 17.0};
  const Vector3 moment = frame.mirrored_moment(cross(arm, force));
  const Vector3 expected = cross(frame.mirrored(arm), frame.mirrored(force));
  EXPECT_EQ(frame.mirrored(force).x, 3.0);
  EXPECT_EQ(frame.mirrored(force).y, mirror * 5.0);
  EXPECT_EQ(frame.mirrored(force).z, 7.0);
  EXPECT_EQ(frame.mirrored_lateral(5.0), frame.mirrored(force).y);
  EXPECT_EQ(moment.x, expected.x);
  EXPECT_EQ(moment.y, expected.y);
  EXPECT_EQ(moment.z, expected.z);
}

INSTANTIATE_TEST_SUITE_P(Both, SideFrames, testing::Values(1.0, -1.0));

} // namespace
} // namespace wrc::test::side_frame_test
