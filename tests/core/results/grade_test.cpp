/// The rule by which warnings become a grade.
#include "results/grade.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc {
namespace {

Grade of_error(double excess) {
  return grade_of(Warning{WarningClass::accuracy, "not reached", excess});
}

TEST(Grade, IsThatOfTheErrorEstimate) {
  EXPECT_EQ(of_error(1.02), Grade::slightly_over);
  EXPECT_EQ(of_error(2.0), Grade::slightly_over) << "up to twice the accuracy";
  EXPECT_EQ(of_error(2.001), Grade::do_not_use);
  EXPECT_EQ(of_error(INFINITY), Grade::do_not_use) << "no estimate";
  EXPECT_EQ(of_error(NAN), Grade::do_not_use);
  EXPECT_EQ(of_error(0.9), Grade::fine) << "the wheel's error is within the accuracy";
}

TEST(Grade, OfClassesWithoutAnErrorIsFineUnlessTheySpoilNumbers) {
  EXPECT_EQ(grade_of(Warning{WarningClass::unused_key, ""}), Grade::fine);
  EXPECT_EQ(grade_of(Warning{WarningClass::element_limit, ""}), Grade::fine);
  EXPECT_EQ(grade_of(Warning{WarningClass::pressure, ""}), Grade::do_not_use);
  EXPECT_EQ(grade_of(Warning{WarningClass::profile_signs, ""}), Grade::do_not_use);
}

TEST(Grade, OfManyIsTheWorst) {
  const Warning note{WarningClass::unused_key, ""};
  const Warning over{WarningClass::creep_accuracy, "", 1.5};
  const Warning bad{WarningClass::not_converged, ""};
  EXPECT_EQ(grade_of(Warnings{}), Grade::fine);
  EXPECT_EQ(grade_of(Warnings{note}), Grade::fine);
  EXPECT_EQ(grade_of(Warnings{note, over}), Grade::slightly_over);
  EXPECT_EQ(grade_of(Warnings{bad, over, note}), Grade::do_not_use);
}

TEST(Grade, HasNames) {
  EXPECT_EQ(name_of(Grade::fine), "fine");
  EXPECT_EQ(name_of(Grade::slightly_over), "a little over");
  EXPECT_EQ(name_of(Grade::do_not_use), "do not use");
}

} // namespace
} // namespace wrc
