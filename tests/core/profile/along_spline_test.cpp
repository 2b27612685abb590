/// The spline along: what it reproduces, its order, what it smooths, what it refuses.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "profile/along_spline.hpp"
#include "support/errors.hpp"

namespace wrc::test::along_spline_test {
namespace {

constexpr double revolution = 2.0 * std::numbers::pi;

double value_at(const AlongSpline& spline, const AlongSpline::Fit& fit, double along,
                double* second = nullptr) {
  const AlongPlace p = spline.locate(along);
  const double a = 1.0 - p.fraction;
  const double b = p.fraction;
  const double h = p.step;
  const std::size_t i = p.interval;
  if (second != nullptr)
    *second = a * fit.second[i] + b * fit.second[i + 1];
  return a * fit.value[i] + b * fit.value[i + 1] +
         h * h / 6.0 * ((a * a * a - a) * fit.second[i] + (b * b * b - b) * fit.second[i + 1]);
}

std::vector<double> equal_steps(double begin, double step, std::size_t count) {
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(begin + step * static_cast<double>(i));
  return places;
}

TEST(AlongSpline, EqualValuesGiveThemselvesToTheBit) {
  const std::vector<double> uneven{-75000.0, -995.0, -895.0, -867.3, 12.0, 17.1};
  for (const double smoothing : {0.0, 30.0, 300.0})
    for (const double period : {0.0, 1e5}) {
      const AlongSpline spline(uneven, smoothing, period);
      const AlongSpline::Fit fit = spline.fit(std::vector<double>(uneven.size(), 0.1));
      for (std::size_t k = 0; k < spline.knots().size(); ++k) {
        EXPECT_EQ(fit.value[k], 0.1);
        EXPECT_EQ(fit.second[k], 0.0);
      }
    }
}

TEST(AlongSpline, KeepsStraightLines) {
  const std::vector<double> places{-500.0, -120.0, -100.0, -80.0, 3.0, 8.0, 13.0};
  std::vector<double> values;
  for (const double x : places)
    values.push_back(2.0 + 0.05 * x);
  for (const double smoothing : {0.0, 40.0}) {
    const AlongSpline spline(places, smoothing, 0.0);
    const AlongSpline::Fit fit = spline.fit(values);
    for (double x = -500.0; x <= 13.0; x += 0.7)
      EXPECT_NEAR(value_at(spline, fit, x), 2.0 + 0.05 * x, 1e-10);
  }
}

struct Errors {
  double value = 0.0;
  double second = 0.0;
};

Errors errors_of_a_wave(std::size_t count) { // around a wheel
  const AlongSpline spline(equal_steps(-1.0, revolution / static_cast<double>(count), count), 0.0,
                           revolution);
  std::vector<double> values;
  for (const double theta : spline.knots().first(count))
    values.push_back(std::sin(3.0 * theta));
  const AlongSpline::Fit fit = spline.fit(values);
  Errors errors;
  for (double theta = 0.0; theta < revolution; theta += 0.0011) {
    double second = 0.0;
    const double value = value_at(spline, fit, theta, &second);
    errors.value = std::max(errors.value, std::abs(value - std::sin(3.0 * theta)));
    errors.second = std::max(errors.second, std::abs(second + 9.0 * std::sin(3.0 * theta)));
  }
  return errors;
}

TEST(AlongSpline, IsOfFourthOrderAndItsSecondDerivativeOfSecond) {
  const Errors coarse = errors_of_a_wave(60);
  const Errors fine = errors_of_a_wave(120);
  EXPECT_NEAR(std::log2(coarse.value / fine.value), 4.0, 0.1);
  EXPECT_NEAR(std::log2(coarse.second / fine.second), 2.0, 0.1);
  EXPECT_LT(fine.value, 3e-6);
}

TEST(AlongSpline, HalvesWavesOfTheSmoothingLength) {
  const std::size_t count = 400;
  const double period = 1000.0;
  const AlongSpline spline(equal_steps(0.0, 2.5, count), 100.0, period);
  std::vector<double> values;
  for (const double x : spline.knots().first(count))
    values.push_back(std::cos(revolution * x / 100.0));
  const AlongSpline::Fit fit = spline.fit(values);
  EXPECT_NEAR(fit.value.front(), 0.5, 2e-3);
  EXPECT_NEAR(value_at(spline, fit, 150.0), -0.5, 2e-3);
}

TEST(AlongSpline, DoesNotSwingOverAnIntervalMuchLongerThanItsNeighbour) {
  const std::vector<double> places{-24000.0, -1000.0, -990.0, -980.0, -970.0};
  const std::vector<double> values{0.0, 0.0, 1.0, 2.0, 3.0}; // a slope of 1:10 begins
  const AlongSpline spline(places, 0.0, 0.0);
  const AlongSpline::Fit fit = spline.fit(values);
  double swing = 0.0;
  for (double x = -24000.0; x < -1000.0; x += 0.5)
    swing = std::max(swing, std::abs(value_at(spline, fit, x)));
  EXPECT_LT(swing, 0.3); // mm; 440 mm without knots in between
  for (std::size_t i = 1; i + 1 < spline.knots().size(); ++i) {
    const double before = spline.knots()[i] - spline.knots()[i - 1];
    const double after = spline.knots()[i + 1] - spline.knots()[i];
    EXPECT_LE(std::max(before, after), 2.5 * std::min(before, after));
  }
}

TEST(AlongSpline, IsPeriodicToTheBit) {
  const std::vector<double> places{-0.1, 0.0, 0.07, 0.1}; // a flat; straight over the rest
  const std::vector<double> values{0.0, -0.9, -0.4, 0.0};
  const AlongSpline spline(places, 0.0, revolution);
  const AlongSpline::Fit fit = spline.fit(values);
  EXPECT_EQ(spline.knots()[spline.last_place_knot()], 0.1);
  EXPECT_EQ(fit.value.front(), fit.value.back());
  EXPECT_EQ(fit.second.front(), fit.second.back());
  EXPECT_NEAR(value_at(spline, fit, std::numbers::pi), 0.0, 1e-3);
  EXPECT_NEAR(value_at(spline, fit, 0.03 + 3.0 * revolution), value_at(spline, fit, 0.03), 1e-13);
  EXPECT_EQ(spline.locate(0.12 - revolution).interval, spline.locate(0.12).interval);
}

TEST(AlongSpline, OneOrTwoPlacesAroundAWheel) {
  const AlongSpline one(std::vector{0.5}, 0.0, revolution);
  EXPECT_EQ(value_at(one, one.fit(std::vector{7.0}), 2.0), 7.0);
  const AlongSpline two(std::vector{0.0, std::numbers::pi}, 0.0, revolution);
  const AlongSpline::Fit fit = two.fit(std::vector{1.0, -1.0});
  EXPECT_NEAR(value_at(two, fit, 0.5 * std::numbers::pi), 0.0, 1e-15);
  EXPECT_LT(fit.second.front(), 0.0);
}

TEST(AlongSpline, RefusesWhatIsNoListOfPlaces) {
  const auto refuses = [](const std::vector<double>& places, double smoothing, double period,
                          const char* part) {
    test::expect_error(
        ErrorCode::invalid_argument, [&] { AlongSpline(places, smoothing, period); }, part);
  };
  refuses({1.0}, 0.0, 0.0, "number of slices = 1: at least 2");
  refuses({}, 0.0, revolution, "at least 1");
  refuses({1.0, 1.0}, 0.0, 0.0, "place of slice 2");
  refuses({0.0, NAN}, 0.0, 0.0, "place of slice 2");
  refuses({0.0, 7.0}, 0.0, revolution,
          "must be less than one revolution, 6.283: leave out the last slice");
  refuses({0.0, 1.0}, -1.0, 0.0, "smoothing length along = -1");
  refuses({0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, 1e9, 0.0,
          "at most 1000 distances of the closest knots, 1");
  std::vector<double> clusters; // each with forty knots on both sides
  for (int i = 0; i < 1000; ++i)
    for (const double offset : {0.0, 1e-9})
      clusters.push_back(1e3 * i + offset);
  refuses(clusters, 0.0, 0.0, "at most 20000");
  test::expect_error(
      ErrorCode::invalid_argument,
      [] {
        (void)AlongSpline(std::vector{0.0, 1.0}, 0.0, 0.0).fit(std::vector{1.0});
      },
      "number of values = 1");
}

} // namespace
} // namespace wrc::test::along_spline_test
