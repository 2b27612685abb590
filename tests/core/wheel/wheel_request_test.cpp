// Which of the three is prescribed: a vertical load, a normal load, a position.
#include "records/wheel_request.hpp"

#include <gtest/gtest.h>

namespace wrc::test::wheel_request_test {
namespace {

TEST(WheelRequest, UsesTheLoadThatIsSet) {
  WheelRequest request;
  request.vertical_load = 8e4;
  EXPECT_EQ(request.load(), 8e4);
  EXPECT_FALSE(request.position_is_prescribed());
  request.vertical_load.reset();
  request.normal_load = 5e4;
  EXPECT_EQ(request.load(), 5e4);
  request.normal_load.reset();
  request.vertical = 459.9;
  EXPECT_EQ(request.load(), 0.0);
  EXPECT_TRUE(request.position_is_prescribed());
}

} // namespace
} // namespace wrc::test::wheel_request_test
