/// The names that differ least from a word.
#include "base/nearest_names.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::nearest_names_test {
namespace {

const std::vector<std::string> names{"left.pmax", "left.patches.0.pmax", "right.pmax", "roll"};

TEST(NearestNames, CountLettersAndLeaveOutGroups) {
  EXPECT_EQ(nearest_names("left.pmx", names), "left.pmax");
  EXPECT_EQ(nearest_names("left_pmax", names), "left.pmax");
  EXPECT_EQ(nearest_names("rol", names), "roll");
  EXPECT_EQ(nearest_names("pmx", names), "left.pmax left.patches.0.pmax right.pmax");
  EXPECT_EQ(nearest_names("patches.pmax", names), "left.patches.0.pmax");
}

TEST(NearestNames, AtMostFour) {
  const std::vector<std::string> many{"a1", "a2", "a3", "a4", "a5"};
  EXPECT_EQ(nearest_names("a", many), "a1 a2 a3 a4");
  EXPECT_EQ(nearest_names("a", {}), "");
}

} // namespace
} // namespace wrc::test::nearest_names_test
