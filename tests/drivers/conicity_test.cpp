/// Equivalent conicity against motions known in closed form.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "reports/conicity.hpp"

namespace conicity_test {
namespace {

using driver::RadiusDifference;

double conicity_of(const RadiusDifference& samples, double amplitude) {
  return driver::equivalent_conicity(samples, amplitude).value;
}

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
      EXPECT_NEAR(conicity_of(samples, amplitude) / slope, 1.0, rounding) << amplitude;
    }
  }
}

TEST(Conicity, DoesNotDependOnThePositionOfRest) {
  constexpr double rounding = 1e-12;
  const auto samples = sample(10.0, 400, [](double y) { return 0.1 * (y - 0.333); });
  EXPECT_NEAR(conicity_of(samples, 3.0) / 0.05, 1.0, rounding);
}

TEST(Conicity, OfTwoSlopesCombinesTwoHalfWaves) {
  // Each side swings as its own cone; energy makes the turning points y1, y2 with g1 y1^2 = g2
  // y2^2, and half the wave of each is added.
  constexpr double g1 = 0.3;
  constexpr double g2 = 0.05;
  const auto samples = sample(10.0, 2000, [=](double y) { return 2.0 * (y < 0.0 ? g1 : g2) * y; });
  constexpr double rate_sum = 0.5; // mean of both
  const double root = rate_sum * (1.0 / std::sqrt(g1) + 1.0 / std::sqrt(g2));
  constexpr double rounding = 1e-10;
  for (const double amplitude : {0.5, 3.0}) {
    EXPECT_NEAR(conicity_of(samples, amplitude) * root * root, 1.0, rounding);
  }
}

TEST(Conicity, OfACubicDifferenceHasTheClosedForm) {
  // y'' = -y^3 with amplitude A has the period 4 K(1/2)^(1/2) / A, K(1/2) = 1.85407467730137.
  constexpr double complete_elliptic = 1.854074677301372;
  const auto samples = sample(5.0, 4000, [](double y) { return 2.0 * y * y * y; });
  for (const double amplitude : {1.0, 3.0}) {
    const double wave = 4.0 * complete_elliptic / amplitude;
    const double exact = std::pow(2.0 * std::numbers::pi / wave, 2);
    constexpr double chords = 1e-5; // of steps of 0.0025 mm over 1 mm
    EXPECT_NEAR(conicity_of(samples, amplitude) / exact, 1.0, chords) << amplitude;
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
  EXPECT_NEAR(conicity_of(samples, amplitude) * std::pow(wave / (2.0 * std::numbers::pi), 2), 1.0,
              width);
  // Falling outwards: a force f - c y with a closed form by the hyperbolic cosine.
  constexpr double fall = 0.02;
  samples.difference = {-2.0 * (force - fall * 10.0), -2.0 * force, 2.0 * force,
                        2.0 * (force - fall * 10.0)};
  const double centre = force / fall;
  const double rate = std::sqrt(fall);
  const double quarter = std::acosh(centre / (centre - amplitude)) / rate;
  EXPECT_NEAR(conicity_of(samples, amplitude) *
                  std::pow(4.0 * quarter / (2.0 * std::numbers::pi), 2),
              1.0, width);
}

TEST(Conicity, IsUndefinedBeyondTheSamplesAndWithoutARestoringDifference) {
  const auto samples = sample(5.0, 100, [](double y) { return 0.1 * y; });
  EXPECT_TRUE(std::isnan(conicity_of(samples, 5.5)));
  EXPECT_TRUE(std::isnan(conicity_of(samples, 0.0)));
  EXPECT_TRUE(std::isnan(conicity_of({}, 1.0)));
  const auto away = sample(5.0, 100, [](double y) { return -0.1 * y; });
  EXPECT_TRUE(std::isnan(conicity_of(away, 1.0)));
  const auto turning = sample(5.0, 1000, [](double y) { return std::sin(2.0 * y); });
  EXPECT_FALSE(std::isnan(conicity_of(turning, 1.0)));
  EXPECT_TRUE(std::isnan(conicity_of(turning, 3.0)));
}

/// A force that is 0 up to a half width w, then grows at a rate k: half a sine, and twice w at the
/// speed with which it begins.
TEST(Conicity, IsZeroWithinPlayAndGrowsBeyond) {
  constexpr double w = 2.0;
  constexpr double k = 0.05;
  const auto band = [](double noise) {
    int i = 0;
    return sample(10.0, 200, [&i, noise](double y) {
      const double sign = ++i % 3 == 0 ? -1.0 : i % 3 - 1.0; // also 0
      const double beyond = std::abs(y) - w;
      return beyond > 1e-9 ? 2.0 * k * std::copysign(beyond, y) : sign * noise;
    });
  };
  for (const double noise : {0.0, 1e-13, 1e-10}) { // of a cylinder: 4e-13 mm
    const auto samples = band(noise);
    for (const double amplitude : {0.5, 1.0, 1.9}) {
      const auto conicity = driver::equivalent_conicity(samples, amplitude);
      EXPECT_EQ(conicity.value, 0.0) << noise << ' ' << amplitude << conicity.reason;
    }
    for (const double amplitude : {2.001, 2.1, 3.0, 9.0}) {
      const double half_wave =
          std::numbers::pi / std::sqrt(k) + 2.0 * w / (std::sqrt(k) * (amplitude - w));
      const double exact = std::pow(std::numbers::pi / half_wave, 2);
      constexpr double rounding = 1e-6; // of the difference to the band's end
      EXPECT_NEAR(conicity_of(samples, amplitude) / exact, 1.0, rounding)
          << noise << ' ' << amplitude;
    }
    EXPECT_TRUE(driver::equivalent_conicity(samples, 10.5)
                    .reason.starts_with("the rolling radius difference is not known beyond"));
  }
  // A cylinder all along.
  const auto flat = sample(5.0, 10, [](double y) { return 1e-13 * y; });
  EXPECT_EQ(conicity_of(flat, 4.9), 0.0);
  EXPECT_TRUE(std::isnan(conicity_of(flat, 5.1)));
}

/// Led away from the centre by a force F up to 1 mm and back beyond: narrow motions about a rest at
/// 1 mm, wide ones over both, whose parts are as long as a speed changes by F.
TEST(Conicity, CoversMotionsAcrossTwoPositionsOfRest) {
  constexpr double force = 0.25;
  RadiusDifference samples;
  samples.lateral = {-10.0, -1.0 - 1e-9, -1.0 + 1e-9, -1e-9, 1e-9, 1.0 - 1e-9, 1.0 + 1e-9, 10.0};
  for (const double sign : {-1.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0}) {
    samples.difference.push_back(2.0 * force * sign);
  }
  constexpr double width = 1e-7; // of the jumps
  for (const double amplitude : {2.5, 4.0, 9.0}) {
    const double half_wave = 2.0 *
                             (2.0 * std::sqrt(2.0 * force * (amplitude - 1.0)) -
                              std::sqrt(2.0 * force * (amplitude - 2.0))) /
                             force;
    EXPECT_NEAR(conicity_of(samples, amplitude) * std::pow(half_wave / std::numbers::pi, 2), 1.0,
                width)
        << amplitude;
  }
  constexpr double narrow = 0.5;
  EXPECT_NEAR(conicity_of(samples, narrow) * 32.0 * narrow / force /
                  std::pow(2.0 * std::numbers::pi, 2),
              1.0, width);
  const auto between = driver::equivalent_conicity(samples, 1.5);
  EXPECT_TRUE(std::isnan(between.value));
  EXPECT_NE(between.reason.find("runs away to another position of rest"), std::string::npos)
      << between.reason;
}

TEST(Conicity, IsUndefinedBeyondAnUnknownDifference) {
  auto samples = sample(10.0, 20, [](double y) { return 0.1 * y; });
  samples.difference[14] = std::numeric_limits<double>::quiet_NaN(); // y = 4
  constexpr double rounding = 1e-12;
  EXPECT_NEAR(conicity_of(samples, 2.9), 0.05, rounding);
  const auto beyond = driver::equivalent_conicity(samples, 3.1);
  EXPECT_TRUE(std::isnan(beyond.value));
  EXPECT_EQ(beyond.reason, "the rolling radius difference is not known beyond y = 3 mm");
  samples.difference[3] = samples.difference[14]; // y = -7
  samples.difference[14] = 0.4;
  EXPECT_EQ(driver::equivalent_conicity(samples, 6.5).reason,
            "the rolling radius difference is not known beyond y = -6 mm");
  // A sign that changes within the rounding of a position.
  RadiusDifference steep{{-5.0, 1.0, std::nextafter(1.0, 2.0), 7.0}, {-0.6, -2e-9, 0.5, 0.6}};
  EXPECT_GT(conicity_of(steep, 3.0), 0.0);
  // Turning points at the last samples, whatever their rounding.
  for (const int count : {7, 11, 13, 17, 19}) {
    const auto up_to_ends = sample(1.9, count, [](double y) { return 0.1 * y + 0.3 * y * y * y; });
    EXPECT_FALSE(std::isnan(conicity_of(up_to_ends, 1.9))) << count;
  }
  const auto away = sample(5.0, 100, [](double y) { return -0.1 * y; });
  EXPECT_EQ(driver::equivalent_conicity(away, 1.0).reason,
            "the wheelset is led back to no position between y = -5 and 5 mm");
}

/// Of cones: their slopes are their conicities.
TEST(Conicity, HasTheSpreadOfLikelyAndSmoothedCurves) {
  const auto cone = [](double slope) {
    return sample(5.0, 20, [slope](double y) { return 2.0 * slope * y; });
  };
  std::vector<RadiusDifference> likely;
  for (int i = 0; i < 7; ++i) {
    likely.push_back(cone(i % 2 == 0 ? 0.13 : 0.07));
  }
  constexpr double deviations = 2.228;
  constexpr double rounding = 1e-9;
  const auto spread = [&](const std::vector<RadiusDifference>& smoothed) {
    return driver::conicity_spread(cone(0.1), likely, smoothed, 3.0);
  };
  EXPECT_NEAR(spread({}), deviations * 0.03, rounding);
  EXPECT_NEAR(spread({cone(0.1), cone(0.14)}), deviations * 0.05, rounding);
  EXPECT_TRUE(std::isnan(spread({cone(-0.1)})));
  likely.pop_back();
  EXPECT_TRUE(std::isnan(spread({})));
}

} // namespace
} // namespace conicity_test
