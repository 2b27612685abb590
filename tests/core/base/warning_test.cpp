// Names of the classes of warnings, by which programs tell them apart.
#include "base/warning.hpp"

#include <set>

#include <gtest/gtest.h>

namespace wrc::test::warning_test {
namespace {

TEST(Warning, ClassesHaveDifferentNamesOfOneWord) {
  std::set<std::string_view> names;
  for (const std::string_view name : warning_class_names) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_FALSE(name.empty());
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos)
        << name;
  }
}

/// One class of each part of the list: a name that is left out or put elsewhere shifts the others.
TEST(Warning, NamesAreInTheOrderOfTheClasses) {
  EXPECT_EQ(name_of(WarningClass::profile_dimensions), "profile_dimensions");
  EXPECT_EQ(name_of(WarningClass::flange_tip), "flange_tip");
  EXPECT_EQ(name_of(WarningClass::not_converged), "not_converged");
  EXPECT_EQ(name_of(WarningClass::element_limit), "element_limit");
  EXPECT_EQ(name_of(WarningClass::close_patches), "close_patches");
  EXPECT_EQ(name_of(WarningClass::torque_ambiguous), "torque_ambiguous");
  EXPECT_EQ(name_of(WarningClass::unused_key), "unused_key");
}

} // namespace
} // namespace wrc::test::warning_test
