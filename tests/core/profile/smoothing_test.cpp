/// Smoothing splines: what passes, what is halved, what is refused.
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/smoothing.hpp"

namespace wrc::test::smoothing_test {
namespace {

/// Abscissae over 200 mm with alternating spacing, to show that it does not matter.
std::vector<double> uneven_abscissae() {
  std::vector<double> u = {0.0};
  while (u.back() < 200.0)
    u.push_back(u.back() + (u.size() % 2 == 0 ? 0.3 : 0.1));
  return u;
}

std::vector<double> sine(const std::vector<double>& u, double wavelength) {
  std::vector<double> z;
  for (const double x : u)
    z.push_back(std::sin(2.0 * std::numbers::pi * x / wavelength));
  return z;
}

/// Amplitude of a wave in the middle half, away from the ends, by projection.
double amplitude(const std::vector<double>& u, const std::vector<double>& z, double wavelength) {
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 1; i < u.size(); ++i)
    if (u[i] > 50.0 && u[i] < 150.0) {
      const double wave = std::sin(2.0 * std::numbers::pi * u[i] / wavelength);
      product += wave * z[i] * (u[i] - u[i - 1]);
      square += wave * wave * (u[i] - u[i - 1]);
    }
  return product / square;
}

TEST(Smoothing, PassesWavesByTheLaw) {
  const std::vector<double> u = uneven_abscissae();
  const double wavelength = 10.0;
  for (const double wave : {5.0, 10.0, 20.0, 50.0}) {
    const double law = 1.0 / (1.0 + std::pow(wavelength / wave, 4));
    // Discretisation with 0.1 / 0.3 mm: (spacing k)^2 / 12 of the wave.
    EXPECT_NEAR(amplitude(u, smooth_values(u, sine(u, wave), wavelength), wave), law, 0.01)
        << "wave " << wave;
  }
}

TEST(Smoothing, HalvesTheRequestedWavelength) {
  const std::vector<double> u = uneven_abscissae();
  for (const double wavelength : {4.0, 10.0, 25.0})
    EXPECT_NEAR(amplitude(u, smooth_values(u, sine(u, wavelength), wavelength), wavelength), 0.5,
                0.005);
}

TEST(Smoothing, ReducesWhiteNoise) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> u;
  std::vector<double> z;
  for (int i = 0; i < 4000; ++i) {
    u.push_back(0.05 * i);
    z.push_back(normal(random));
  }
  double square = 0.0;
  for (const double value : smooth_values(u, z, 10.0))
    square += value * value;
  // Variance left: spacing / pi * integral of 1 / (1 + (k / kc)^4)^2 = spacing kc 3 / (4 sqrt 8)
  // * 2 / 2 = 0.265 spacing kc; kc = 2 pi / 10.
  const double law = 0.05 * (2.0 * std::numbers::pi / 10.0) * 3.0 / (8.0 * std::numbers::sqrt2);
  EXPECT_NEAR(square / 4000.0, law, 0.4 * law); // about 40 independent samples
}

TEST(Smoothing, KeepsStraightLinesExactly) {
  const std::vector<double> u = uneven_abscissae();
  std::vector<double> z;
  for (const double x : u)
    z.push_back(3.0 - 0.7 * x);
  const std::vector<double> smoothed = smooth_values(u, z, 20.0);
  for (std::size_t i = 0; i < u.size(); ++i)
    EXPECT_NEAR(smoothed[i], z[i], 1e-9); // conditioning of the banded system
}

TEST(Smoothing, SmoothsSteepLinesAsFlatOnes) {
  // The same ripple across a line, flat and turned to 80 degrees.
  const double angle = 80.0 * std::numbers::pi / 180.0;
  std::vector<Position> flat;
  std::vector<Position> steep;
  for (double x = 0.0; x <= 100.0; x += 0.25) {
    const double z = 0.1 * std::sin(2.0 * std::numbers::pi * x / 3.0);
    flat.push_back({x, z});
    steep.push_back(
        {std::cos(angle) * x - std::sin(angle) * z, std::sin(angle) * x + std::cos(angle) * z});
  }
  const std::vector<Position> a = smooth_points(flat, 10.0);
  const std::vector<Position> b = smooth_points(steep, 10.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(b[i][0], std::cos(angle) * a[i][0] - std::sin(angle) * a[i][1], 1e-9);
    EXPECT_NEAR(b[i][1], std::sin(angle) * a[i][0] + std::cos(angle) * a[i][1], 1e-9);
  }
  for (std::size_t i = 100; i < 300; ++i)
    EXPECT_LT(std::abs(a[i][1]), 0.1 * 0.02); // the law leaves 0.8 %, the ripple lengthens it
}

TEST(Smoothing, RefusesBadInput) {
  const std::vector<double> u = {0.0, 1.0, 2.0, 3.0};
  const std::vector<double> z = {0.0, 1.0, 0.0, 1.0};
  EXPECT_NO_THROW((void)smooth_values(u, z, 1.0));
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW((void)smooth_values(u, z, bad), Error) << bad;
  EXPECT_THROW((void)smooth_values(u, std::vector{1.0, 2.0, 3.0}, 1.0), Error);
  EXPECT_THROW((void)smooth_values(std::vector{0.0, 1.0}, std::vector{0.0, 1.0}, 1.0), Error);
  EXPECT_THROW((void)smooth_values(std::vector{0.0, 1.0, 1.0, 2.0}, z, 1.0), Error);
  EXPECT_THROW((void)smooth_values(u, std::vector{0.0, std::nan(""), 0.0, 1.0}, 1.0), Error);
}

} // namespace
} // namespace wrc::test::smoothing_test
