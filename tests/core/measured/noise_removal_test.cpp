/// Profiles with noise: what is left of it, what stays, and what the likely lines say.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "measured/constants.hpp"
#include "measured/noise_removal.hpp"
#include "measured/noisy_points.hpp"
#include "profile/spline.hpp"
#include "profile/standard_profiles.hpp"

namespace wrc::test::noise_removal_test {
namespace {

const Curve& wheel() {
  static const Curve curve = standard_profile("S1002").curve;
  return curve;
}

/// The place of a curve at a lateral position.
CurvePoint at_lateral(const Curve& curve, double lateral) {
  double low = 0.0;
  double high = curve.length();
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (curve.at(middle).lateral < lateral ? low : high) = middle;
  }
  return curve.at(low);
}

struct Errors {
  double height = 0.0;
  double curvature = 0.0;
};

/// Root mean squares over the tread from -20 to 30 mm.
Errors errors_of(const Curve& curve) {
  Errors sum;
  int count = 0;
  for (double lateral = -20.0; lateral <= 30.0; lateral += 0.5) {
    const CurvePoint is = at_lateral(curve, lateral);
    const CurvePoint ought = at_lateral(wheel(), lateral);
    sum.height += std::pow(is.height - ought.height, 2);
    sum.curvature += std::pow(is.curvature() - ought.curvature(), 2);
    ++count;
  }
  return {std::sqrt(sum.height / count), std::sqrt(sum.curvature / count)};
}

/// Curvatures of the tread are 0.003 per mm; by the points themselves they would be off by 0.8 at
/// 0.25 mm.
TEST(NoiseRemoval, CurvaturesOfTheTreadRemain) {
  for (const double spacing : {0.1, 0.25, 1.0}) {
    const NoiseRemoval clean = remove_noise(noisy_points(wheel(), {0.02, spacing, 0.0, 1}));
    const Errors errors = errors_of(curve_through(clean.points));
    EXPECT_LT(errors.height, 0.02 * 0.8 * std::sqrt(spacing)) << spacing;
    EXPECT_LT(errors.curvature, 0.0015) << spacing;
    EXPECT_NEAR(clean.deviation, 0.02, 0.003) << spacing;
    EXPECT_GT(clean.long_wave, 8.0) << spacing;
    EXPECT_LT(clean.short_wave, 0.6 * clean.long_wave) << spacing;
  }
}

/// The flange root of 13 mm radius and the flange tip of 12 mm stay where they are.
TEST(NoiseRemoval, FlangeAndRootStay) {
  const Curve curve =
      curve_through(remove_noise(noisy_points(wheel(), {0.02, 0.25, 0.0, 1})).points);
  double tip = 0.0;
  for (double arc = 0.0; arc < curve.length(); arc += 0.1)
    tip = std::max(tip, curve.at(arc).height);
  EXPECT_NEAR(tip, 28.0, 0.02);
  const double root = at_lateral(wheel(), -31.0).height;
  EXPECT_NEAR(at_lateral(curve, -31.0).height, root, 0.02);
}

TEST(NoiseRemoval, PointsWithoutNoiseStay) {
  const Errors errors =
      errors_of(curve_through(remove_noise(noisy_points(wheel(), {1e-6, 0.25, 0.0, 1})).points));
  EXPECT_LT(errors.height, 2e-5);
  EXPECT_LT(errors.curvature, 2e-4);
}

/// Curvatures of a wavelength average: the truth is as far from the result as the likely lines are.
TEST(NoiseRemoval, LikelyLinesScatterAsTheResult) {
  double off_truth = 0.0;
  double off_likely = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const NoiseRemoval clean = remove_noise(noisy_points(wheel(), {0.02, 0.25, 0.0, seed}));
    ASSERT_EQ(clean.likely.size(), likely_lines);
    const Curve result = curve_through(clean.points);
    off_truth += std::pow(errors_of(result).height, 2);
    for (const std::vector<Position>& line : clean.likely) {
      const Curve likely = curve_through(line);
      double sum = 0.0;
      int count = 0;
      for (double lateral = -20.0; lateral <= 30.0; lateral += 0.5, ++count)
        sum += std::pow(at_lateral(likely, lateral).height - at_lateral(result, lateral).height, 2);
      off_likely += sum / count / static_cast<double>(likely_lines);
    }
  }
  EXPECT_GT(off_likely, 0.5 * off_truth);
  EXPECT_LT(off_likely, 3.0 * off_truth);
}

/// An instrument's filter: curvatures of the tread would be off by 0.02 by the points themselves.
TEST(NoiseRemoval, FindsFilteredNoise) {
  for (const double cutoff : {0.8, 2.5}) {
    Noise noise{0.02, 0.25, 0.0, 1};
    noise.cutoff = cutoff;
    const std::vector<Position> points = noisy_points(wheel(), noise);
    const NoiseRemoval found = remove_noise(points);
    EXPECT_GE(found.distance, 0.5) << cutoff;
    EXPECT_LT(errors_of(curve_through(found.points)).curvature, 0.004) << cutoff;
  }
}

/// The points of independent noise are all used.
TEST(NoiseRemoval, IndependentNoiseIsNotTakenForFiltered) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    EXPECT_EQ(remove_noise(noisy_points(wheel(), {0.01, 0.25, 0.0, seed})).distance, 0.0);
}

TEST(NoiseRemoval, IsTheSameEachTime) {
  const std::vector<Position> points = noisy_points(wheel(), {0.02, 0.5, 0.0, 1});
  const NoiseRemoval first = remove_noise(points);
  const NoiseRemoval second = remove_noise(points);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.likely, second.likely);
}

/// As an averaged rail of the collection has one, 3.6 mm off its side face.
TEST(NoiseRemoval, APointFarFromItsEndIsLeftOut) {
  std::vector<Position> points = noisy_points(wheel(), {0.005, 0.25, 0.0, 1});
  points.insert(points.begin(), {points.front()[0] - 3.6, points.front()[1] - 0.1});
  const NoiseRemoval clean = remove_noise(points);
  EXPECT_NEAR(clean.deviation, 0.005, 0.001);
  EXPECT_NEAR(clean.points.front()[0], -70.0, 0.1);
  EXPECT_EQ(clean.lone_ends, 1U);
}

} // namespace
} // namespace wrc::test::noise_removal_test
