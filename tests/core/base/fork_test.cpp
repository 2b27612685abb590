// Functions that are called around a fork.
#include "base/fork.hpp"

#include <array>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace wrc::test::fork_functions_test {
namespace {

std::array<int, 3> calls{};

TEST(Fork, IsPrecededAndFollowedInBothProcesses) {
  ASSERT_TRUE(call_around_forks([] { ++calls[0]; }, [] { ++calls[1]; }, [] { ++calls[2]; }));
  const pid_t child = fork();
  if (child == 0) {
    _exit(calls == std::array<int, 3>{1, 0, 1} ? 0 : 1);
  }
  ASSERT_GT(child, 0);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(calls, (std::array<int, 3>{1, 1, 0}));
}

} // namespace
} // namespace wrc::test::fork_functions_test
