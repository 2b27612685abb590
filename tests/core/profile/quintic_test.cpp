// Quintic Hermite interpolation: polynomials up to the fifth degree, ends, and its error.
#include "profile/quintic.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc::test::quintic_test {
namespace {

/// Ascending coefficients, and two derivatives, without Horner.
QuinticValues polynomial(const Quintic& c, double s) {
  QuinticValues values{};
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto n = static_cast<double>(i);
    values.value += c[i] * std::pow(s, n);
    values.first += i >= 1 ? n * c[i] * std::pow(s, n - 1.0) : 0.0;
    values.second += i >= 2 ? n * (n - 1.0) * c[i] * std::pow(s, n - 2.0) : 0.0;
  }
  return values;
}

TEST(Quintic, EvaluatesValueAndDerivatives) {
  const Quintic c{0.3, -1.2, 0.7, 0.05, -0.4, 0.11};
  for (const double s : {0.0, 0.4, 1.0, -1.7}) {
    const QuinticValues expected = polynomial(c, s);
    const QuinticValues found = evaluate(c, s);
    EXPECT_NEAR(found.value, expected.value, 1e-13);
    EXPECT_NEAR(found.first, expected.first, 1e-13);
    EXPECT_NEAR(found.second, expected.second, 1e-12);
  }
}

TEST(Quintic, ReproducesPolynomialsOfTheFifthDegree) {
  const Quintic c{0.3, -1.2, 0.7, 0.05, -0.4, 0.11};
  for (const double length : {0.2, 1.0, 2.5}) {
    const Quintic found = quintic(evaluate(c, 0.0), evaluate(c, length), length);
    for (std::size_t i = 0; i < c.size(); ++i) {
      EXPECT_NEAR(found[i], c[i], 1e-11 / std::pow(length, static_cast<double>(i))) << length;
    }
  }
}

/// h^6/46080 times the sixth derivative, in the middle.
TEST(Quintic, ErrorIsThatOfTheSixthDerivative) {
  constexpr double h = 0.5;
  const auto sine = [](double s) { return QuinticValues{std::sin(s), std::cos(s), -std::sin(s)}; };
  constexpr double begin = 1.2;
  const Quintic c = quintic(sine(begin), sine(begin + h), h);
  const double error = evaluate(c, 0.5 * h).value - std::sin(begin + 0.5 * h);
  const double expected = std::pow(h, 6) / 46080.0 * -std::sin(begin + 0.5 * h);
  EXPECT_NEAR(error, expected, 0.02 * std::abs(expected));
}

TEST(Quintic, LargePositionsLoseNoMoreThanTheirOwnRounding) {
  const QuinticValues begin{1e6 + 0.25, 0.1, 0.02};
  const QuinticValues end{1e6 + 0.3125, 0.12, -0.01};
  const Quintic c = quintic(begin, end, 0.5);
  const QuinticValues found = evaluate(c, 0.5);
  EXPECT_NEAR(found.value, end.value, 2e-10);
  EXPECT_NEAR(found.first, end.first, 1e-13);
  EXPECT_NEAR(found.second, end.second, 1e-12);
}

} // namespace
} // namespace wrc::test::quintic_test
