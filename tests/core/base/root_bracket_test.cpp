#include "base/root_bracket.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace wrc::test::root_bracket_test {
namespace {

/// Steps taken to narrow the bracket of a function's root between two places.
template <class Function>
int steps_to_narrow(RootBracket& bracket, double tolerance, const Function& function) {
  int steps = 0;
  bracket.narrow(tolerance, [&](double x) {
    ++steps;
    return function(x);
  });
  return steps;
}

template <class Function> RootBracket bracket_of(double one, double other, Function function) {
  return {{one, function(one)}, {other, function(other)}};
}

TEST(RootBracket, SmoothRootsTakeFewSteps) {
  const auto cosine = [](double x) { return std::cos(x); };
  RootBracket bracket = bracket_of(0.3, 2.0, cosine);
  EXPECT_LE(steps_to_narrow(bracket, 1e-12, cosine), 10);
  EXPECT_NEAR(bracket.middle(), 0.5 * std::numbers::pi, 1e-12);
  EXPECT_LE(bracket.one(), bracket.other());
}

TEST(RootBracket, OneSidedFunctionsConvergeQuickly) {
  // Plain regula falsi would take thousands of steps here.
  const auto steep = [](double x) { return std::pow(x, 9) - 1e-6; };
  RootBracket bracket = bracket_of(2.0, 0.0, steep);
  EXPECT_LE(steps_to_narrow(bracket, 1e-12, steep), 80);
  EXPECT_NEAR(bracket.middle(), std::pow(1e-6, 1.0 / 9.0), 1e-12);
  EXPECT_GE(bracket.one(), bracket.other()); // the ends keep their sides
}

TEST(RootBracket, JumpsAreEnclosed) {
  const auto jump = [](double x) { return x < 0.7 ? -1.0 : 1e6; };
  RootBracket bracket = bracket_of(0.0, 1.0, jump);
  steps_to_narrow(bracket, 1e-10, jump);
  EXPECT_LE(bracket.width(), 1e-10);
  EXPECT_LE(bracket.one(), 0.7);
  EXPECT_GE(bracket.other(), 0.7);
}

TEST(RootBracket, InfiniteValuesBisect) {
  const auto logarithm = [](double x) { return std::log(x / 3.0); };
  RootBracket bracket = bracket_of(0.0, 10.0, logarithm); // -infinity at 0
  steps_to_narrow(bracket, 1e-12, logarithm);
  EXPECT_NEAR(bracket.middle(), 3.0, 1e-12);
}

TEST(RootBracket, EndsMeetAtAZeroAndStayWhenStopped) {
  RootBracket zero({-1.0, -1.0}, {1.0, 1.0});
  zero.narrow(0.0, [](double x) { return x; });
  EXPECT_EQ(zero.one(), 0.0);
  EXPECT_EQ(zero.width(), 0.0);
  RootBracket stopped({-1.0, -1.0}, {2.0, 1.0});
  stopped.narrow(0.0, [](double) { return std::optional<double>(); });
  EXPECT_EQ(stopped.width(), 3.0);
}

} // namespace
} // namespace wrc::test::root_bracket_test
