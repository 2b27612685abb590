/// The limit of an accuracy; the warning of a limit names the elements needed, the key and its
/// value.
#include "accuracy/element_limit.hpp"

#include <gtest/gtest.h>

namespace wrc::test::element_limit_test {
namespace {

TEST(ElementLimit, AnAccuracyTakesMoreTheFinerItIs) {
  EXPECT_DOUBLE_EQ(limit_by_accuracy(1e-2), 16000.0);
  EXPECT_DOUBLE_EQ(limit_by_accuracy(1e-1), 16000.0); // which is solved as 1e-2
  EXPECT_NEAR(limit_by_accuracy(1e-3), 50596.4, 0.1);
  EXPECT_DOUBLE_EQ(limit_by_accuracy(1e-5), 1e5);
}

TEST(ElementLimit, TextNamesNeedAndLimit) {
  const std::string text = text_of_limit(250000.0, 1e5);
  EXPECT_NE(text.find("the accuracy needs 2.5e+05 elements"), std::string::npos) << text;
  EXPECT_NE(text.find("solve.element_limit = 100000 permits fewer"), std::string::npos) << text;
}

} // namespace
} // namespace wrc::test::element_limit_test
