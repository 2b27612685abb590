/// Equivalent conicity against motions known in closed form.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "wrc_sweep/conicity.hpp"

namespace conicity_test {
namespace {

using driver::equivalent_conicity;
using driver::RadiusDifference;

template <class Function> RadiusDifference sample(double end, int count, Function difference) {
  RadiusDifference samples;
  for (int i = 0; i <= count; ++i) {
    const double y = -end + 2.0 * end * i / count;
    samples.lateral.push_back(y);
    samples.difference.push_back(difference(y));
  }
  return samples;
}

TEST(Conicity, OfAConeIsItsSlope) {
  constexpr double rounding = 1e-12;
  for (const double slope : {0.001, 0.05, 0.4}) {
    const auto samples = sample(10.0, 37, [=](double y) { return 2.0 * slope * y; });
    for (const double amplitude : {0.01, 1.0, 3.0, 9.9}) {
      EXPECT_NEAR(equivalent_conicity(samples, amplitude) / slope, 1.0, rounding) << amplitude;
    }
  }
}

TEST(Conicity, DoesNotDependOnWhereTheWheelsetRests) {
  constexpr double rounding = 1e-12;
  const auto samples = sample(10.0, 400, [](double y) { return 0.1 * (y - 0.333); });
  EXPECT_NEAR(equivalent_conicity(samples, 3.0) / 0.05, 1.0, rounding);
}

TEST(Conicity, OfTwoSlopesIsThatOfTwoHalfWaves) {
  // Each side swings as its own cone; energy makes the turning points y1, y2 with g1 y1^2 = g2
  // y2^2, and half the wave of each is added.
  constexpr double g1 = 0.3;
  constexpr double g2 = 0.05;
  const auto samples = sample(10.0, 2000, [=](double y) { return 2.0 * (y < 0.0 ? g1 : g2) * y; });
  constexpr double rate_sum = 0.5; // mean of both
  const double root = rate_sum * (1.0 / std::sqrt(g1) + 1.0 / std::sqrt(g2));
  constexpr double rounding = 1e-10;
  for (const double amplitude : {0.5, 3.0}) {
    EXPECT_NEAR(equivalent_conicity(samples, amplitude) * root * root, 1.0, rounding);
  }
}

TEST(Conicity, OfACubicForceIsGausssLemniscate) {
  // y'' = -y^3 with amplitude A has the period 4 K(1/2)^(1/2) / A, K(1/2) = 1.85407467730137.
  constexpr double complete_elliptic = 1.854074677301372;
  const auto samples = sample(5.0, 4000, [](double y) { return 2.0 * y * y * y; });
  for (const double amplitude : {1.0, 3.0}) {
    const double wave = 4.0 * complete_elliptic / amplitude;
    const double exact = std::pow(2.0 * std::numbers::pi / wave, 2);
    constexpr double chords = 1e-5; // of steps of 0.0025 mm over 1 mm
    EXPECT_NEAR(equivalent_conicity(samples, amplitude) / exact, 1.0, chords) << amplitude;
  }
}

TEST(Conicity, GoesThroughJumpsAndFallingParts) {
  // A constant force with a jump in the middle: half a wave is 2 sqrt(2 A / f) long.
  constexpr double force = 0.25;
  RadiusDifference samples;
  samples.lateral = {-10.0, -1e-9, 1e-9, 10.0};
  samples.difference = {-2.0 * force, -2.0 * force, 2.0 * force, 2.0 * force};
  constexpr double amplitude = 2.0;
  const double wave = 4.0 * std::sqrt(2.0 * amplitude / force);
  constexpr double width = 1e-8; // of the jump
  EXPECT_NEAR(equivalent_conicity(samples, amplitude) *
                  std::pow(wave / (2.0 * std::numbers::pi), 2),
              1.0, width);
  // Falling outwards: a force f - c y with a closed form by the hyperbolic cosine.
  constexpr double fall = 0.02;
  samples.difference = {-2.0 * (force - fall * 10.0), -2.0 * force, 2.0 * force,
                        2.0 * (force - fall * 10.0)};
  const double centre = force / fall;
  const double rate = std::sqrt(fall);
  const double quarter = std::acosh(centre / (centre - amplitude)) / rate;
  EXPECT_NEAR(equivalent_conicity(samples, amplitude) *
                  std::pow(4.0 * quarter / (2.0 * std::numbers::pi), 2),
              1.0, width);
}

TEST(Conicity, IsUnknownWhereTheSamplesEndOrLeadAway) {
  const auto samples = sample(5.0, 100, [](double y) { return 0.1 * y; });
  EXPECT_TRUE(std::isnan(equivalent_conicity(samples, 5.5)));
  EXPECT_TRUE(std::isnan(equivalent_conicity(samples, 0.0)));
  EXPECT_TRUE(std::isnan(equivalent_conicity({}, 1.0)));
  const auto away = sample(5.0, 100, [](double y) { return -0.1 * y; });
  EXPECT_TRUE(std::isnan(equivalent_conicity(away, 1.0)));
  const auto turning = sample(5.0, 1000, [](double y) { return std::sin(2.0 * y); });
  EXPECT_FALSE(std::isnan(equivalent_conicity(turning, 1.0)));
  EXPECT_TRUE(std::isnan(equivalent_conicity(turning, 3.0)));
}

} // namespace
} // namespace conicity_test
