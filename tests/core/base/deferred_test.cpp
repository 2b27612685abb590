/// Values that are computed when they are first asked for.
#include <new>
#include <string>

#include <gtest/gtest.h>

#include "base/deferred.hpp"

namespace wrc::test::deferred_test {
namespace {

/// What is kept is the value, not a failure.
TEST(Deferred, TriesAgainAfterAFailureAndComputesOnce) {
  int calls = 0;
  const Deferred<std::string> value([&calls] {
    if (++calls == 1) {
      throw std::bad_alloc();
    }
    return std::string("computed");
  });
  const Deferred<std::string> copy = value;
  EXPECT_EQ(calls, 0);
  EXPECT_THROW((void)value.get(), std::bad_alloc);
  EXPECT_EQ(copy.get(), "computed");
  EXPECT_EQ(&value.get(), &copy.get());
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(value.valid());
  EXPECT_FALSE(Deferred<std::string>().valid());
}

} // namespace
} // namespace wrc::test::deferred_test
