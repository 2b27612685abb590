/// An optional value on the heap behaves as std::optional does.
#include "base/heap_optional.hpp"

#include <string>

#include <gtest/gtest.h>

namespace wrc::test::heap_optional_test {
namespace {

TEST(HeapOptional, IsEmptyUntilItHasAValue) {
  HeapOptional<std::string> text;
  EXPECT_FALSE(text.has_value());
  EXPECT_THROW((void)text.value(), std::bad_optional_access);
  text.emplace(3, 'a');
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "aaa");
  EXPECT_EQ(text->size(), 3);
  text = std::nullopt;
  EXPECT_FALSE(text);
  EXPECT_FALSE(HeapOptional<std::string>(std::optional<std::string>()));
  EXPECT_EQ(HeapOptional<std::string>(std::optional<std::string>("b")).value(), "b");
}

TEST(HeapOptional, CopiesAreIndependent) {
  HeapOptional<std::string> first(std::string("a"));
  HeapOptional<std::string> second(first);
  *second = "b";
  EXPECT_EQ(*first, "a");
  second = first;
  second->append("c");
  EXPECT_EQ(*first, "a");
  const HeapOptional<std::string> third(std::move(second));
  EXPECT_EQ(*third, "ac");
}

} // namespace
} // namespace wrc::test::heap_optional_test
