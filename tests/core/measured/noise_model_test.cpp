/// The fit of noise: its level and correlation are found, waves are short where curvature changes.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "measured/noise_model.hpp"
#include "measured/noisy_points.hpp"

namespace wrc::test::noise_model_test {
namespace {

constexpr double length = 100.0;

/// Offsets from a straight reference of a line that is straight up to the middle and has an arc of
/// 20 mm radius and 10 mm length there, which turns by half a radian; small enough for offsets.
double shape(double arc) {
  const double past = std::clamp(arc - 50.0, 0.0, 10.0);
  return past * past / 40.0 + (arc > 60.0 ? (arc - 60.0) * 0.5 : 0.0);
}

OffsetData sample(const Noise& noise) {
  OffsetData data;
  for (double arc = 0.0; arc <= length; arc += noise.spacing)
    data.arc.push_back(arc);
  data.offset = noise_values(noise, noise.spacing, static_cast<int>(data.arc.size()));
  for (std::size_t i = 0; i < data.arc.size(); ++i)
    data.offset[i] += shape(data.arc[i]);
  data.weight.assign(data.arc.size(), 1.0);
  return data;
}

NoiseFit fit_of(OffsetData data) {
  const SplineBasis basis{length, 400};
  return fit_noise(basis, data, std::vector<double>(basis.intervals + 1, 0.0));
}

double rms_error(const NoiseFit& fit, double from, double to) {
  double sum = 0.0;
  int count = 0;
  for (double arc = from; arc < to; arc += 0.1) {
    sum += std::pow(fit.basis.value(fit.coefficients, arc) - shape(arc), 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(NoiseModel, FindsTheLevelAtAnySpacing) {
  for (const double spacing : {0.05, 0.25, 1.0}) {
    const NoiseFit fit = fit_of(sample({0.02, spacing, 0.0, 3}));
    // A deviation of n numbers is known to 1 / sqrt(2 n), here 7 % at most; twice that.
    EXPECT_NEAR(fit.deviation, 0.02, 0.02 * 0.14) << spacing;
    EXPECT_EQ(fit.distance, 0.0) << spacing;
  }
}

/// Of filtered noise neighbours seem to be a line; points that are far enough apart show it.
TEST(NoiseModel, FindsFilteredNoiseAtADistance) {
  Noise noise{0.02, 0.25, 0.0, 5};
  noise.width = 0.35;
  const OffsetData data = sample(noise);
  const SplineBasis basis{length, 400};
  const std::vector<double> straight(basis.intervals + 1, 0.0);
  EXPECT_LT(fit_of(data).deviation, 0.002);
  const NoiseFit fit = fit_apart(basis, data, straight, 1.0);
  EXPECT_NEAR(fit.deviation, 0.02, 0.006);
  EXPECT_LT(fit.correlation, 0.3);
  const NoiseFit again = fit_again(basis, data, straight, fit);
  EXPECT_EQ(again.distance, 1.0);
  EXPECT_LT(rms_error(again, 5.0, 40.0), 0.5 * 0.02);
  const std::vector<double> alike{1.0, 1.0, 1.0, 1.0};
  const std::vector<double> by_turns{1.0, -1.0, 1.0, -1.0};
  EXPECT_NEAR(correlation_of(alike), 1.0, 1e-12);
  EXPECT_NEAR(correlation_of(by_turns), -1.0, 1e-12);
}

/// Half of the noise is left at most where the line is straight, and the arc is kept.
TEST(NoiseModel, SmoothsLongOnLinesAndShortAtArcs) {
  const NoiseFit fit = fit_of(sample({0.02, 0.25, 0.0, 1}));
  const double on_line = fit.wavelength[80];     // 20 mm
  const double at_arc = fit.wavelength[200 - 2]; // begin of the arc
  EXPECT_GT(on_line, 1.5 * at_arc);
  EXPECT_LT(rms_error(fit, 5.0, 40.0), 0.25 * 0.02);
  EXPECT_LT(rms_error(fit, 45.0, 65.0), 0.75 * 0.02);
}

TEST(NoiseModel, OutliersLoseTheirWeight) {
  OffsetData data = sample({0.001, 0.25, 0.0, 1});
  for (const std::size_t i : {60U, 80U, 100U, 120U, 140U})
    data.offset[i] += 0.02;
  const NoiseFit fit = fit_of(data);
  EXPECT_LT(fit.deviation, 0.0016);             // 0.0024 with weights of 1
  EXPECT_LT(rms_error(fit, 15.0, 25.0), 0.005); // a quarter of the outlier among them
  const std::vector<double> weights = weights_of(std::vector<double>{0.1, -0.1, 0.1, 100.0, -0.1});
  EXPECT_EQ(weights[0], 1.0);
  EXPECT_NEAR(weights[3], std::sqrt(0.1 * 3.0 * 1.4826 / 100.0), 1e-12);
}

/// Drawn lines scatter about the fit as the fit about the truth.
TEST(NoiseModel, DrawnLinesAreAsFarOffAsTheTruth) {
  double off_truth = 0.0;
  double off_drawn = 0.0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const NoiseFit fit = fit_of(sample({0.02, 0.25, 0.0, seed}));
    NormalSource normal(seed + 100);
    const std::vector<double> drawn = fit.draw(std::ref(normal));
    for (double arc = 5.0; arc < 95.0; arc += 0.5) {
      const double fitted = fit.basis.value(fit.coefficients, arc);
      off_truth += std::pow(fitted - shape(arc), 2);
      off_drawn += std::pow(fit.basis.value(drawn, arc) - fitted, 2);
    }
  }
  EXPECT_GT(off_drawn, 0.5 * off_truth);
  EXPECT_LT(off_drawn, 2.0 * off_truth);
}

TEST(NoiseModel, BeginningWithAFitChangesLittle) {
  const OffsetData data = sample({0.02, 0.25, 0.0, 1});
  const NoiseFit fit = fit_of(data);
  const NoiseFit again =
      fit_again(fit.basis, data, std::vector<double>(fit.basis.intervals + 1, 0.0), fit);
  EXPECT_NEAR(again.deviation, fit.deviation, 0.02 * fit.deviation);
  const std::vector<double> residuals = again.residuals(data);
  EXPECT_NEAR(residuals[40], data.offset[40] - again.basis.value(again.coefficients, data.arc[40]),
              1e-15);
}

} // namespace
} // namespace wrc::test::noise_model_test
