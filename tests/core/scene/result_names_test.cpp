#include "scene/result_names.hpp"

#include <gtest/gtest.h>

namespace wrc::test::result_names_test {
namespace {

TEST(ResultNames, PrefixIsTakenOffOnlyIfItIsThere) {
  std::string_view name = "left.pmax";
  EXPECT_FALSE(strip_prefix(name, "right."));
  EXPECT_EQ(name, "left.pmax");
  EXPECT_TRUE(strip_prefix(name, "left."));
  EXPECT_EQ(name, "pmax");
}

TEST(ResultNames, IndexBelowTheCount) {
  std::size_t index = 99;
  std::string_view name = "12.pmax";
  EXPECT_TRUE(strip_index(name, 13, index));
  EXPECT_EQ(index, 12U);
  EXPECT_EQ(name, "pmax");
  for (const std::string_view wrong : {"12.pmax", "-1.pmax", "x.pmax", ".pmax", "", "3", "3x"}) {
    std::string_view rest = wrong;
    EXPECT_FALSE(strip_index(rest, 12, index)) << wrong;
  }
}

} // namespace
} // namespace wrc::test::result_names_test
