// Letters of ASCII become small ones, and nothing else changes.
#include "base/lower_case.hpp"

#include <gtest/gtest.h>

namespace wrc::test::lower_case_test {
namespace {

TEST(LowerCase, ChangesLettersOfAsciiAlone) {
  EXPECT_EQ(lower_case("AZaz [@`{ 09.PRR"), "azaz [@`{ 09.prr");
  EXPECT_EQ(lower_case("\xC3\x84"), "\xC3\x84"); // a letter of UTF-8
  EXPECT_EQ(lower_case(""), "");
}

} // namespace
} // namespace wrc::test::lower_case_test
