/// Logarithms for vectorised loops against those of the standard library in long double.
#include "half_space/vector_log.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::vector_log_test {
namespace {

/// In units of the last place; what vector_log.hpp promises.
constexpr double largest_error = 1.0;

constexpr std::size_t count = 100000;

using Values = std::vector<double>;

WRC_VECTOR_CLONES void fill_log(const double* x, double* values, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    values[i] = vector_log(x[i]);
  }
}

WRC_VECTOR_CLONES void fill_log1p(const double* x, double* values, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    values[i] = vector_log1p(x[i]);
  }
}

double units_in_last_place(double value, long double expected) {
  const double rounded = std::abs(static_cast<double>(expected));
  const double unit = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return static_cast<double>(std::abs(value - expected) / unit);
}

/// 2^e with e evenly distributed.
Values powers(double least_exponent, double largest_exponent) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> exponent(least_exponent, largest_exponent);
  Values values(count);
  for (double& value : values) {
    value = std::exp2(exponent(generator));
  }
  return values;
}

Values negative(Values values) {
  for (double& value : values) {
    value = -value;
  }
  return values;
}

void expect_log(const Values& x) {
  Values values(x.size());
  fill_log(x.data(), values.data(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double expected = std::log(static_cast<long double>(x[i]));
    ASSERT_LE(units_in_last_place(values[i], expected), largest_error) << x[i];
  }
}

void expect_log1p(const Values& x) {
  Values values(x.size());
  fill_log1p(x.data(), values.data(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double expected = std::log1p(static_cast<long double>(x[i]));
    ASSERT_LE(units_in_last_place(values[i], expected), largest_error) << x[i];
  }
}

TEST(VectorLog, EqualsTheLogarithm) {
  expect_log(powers(-1021.0, 1023.0));
  expect_log(powers(-2.0, 2.0));
  expect_log(powers(-1e-3, 1e-3));
  expect_log({0x1p-1022, std::numeric_limits<double>::max(), 0.5, 1.0, 2.0, std::sqrt(0.5),
              std::sqrt(2.0), std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)});
  Values one{1.0};
  fill_log(one.data(), one.data(), 1);
  EXPECT_EQ(one[0], 0.0);
}

TEST(VectorLog, OfOnePlusASmallNumberIsAccurate) {
  expect_log1p(powers(-1000.0, 0.0));
  expect_log1p(powers(-60.0, 60.0));
  expect_log1p(powers(-4.0, 1000.0));
  expect_log1p(negative(powers(-1000.0, -1e-9)));
  expect_log1p(negative(powers(-4.0, -1e-9)));
  expect_log1p({0.0, -0.5, 1.0, 0x1p53, 0x1p-53, -0x1p-53, -1.0 + 0x1p-53});
}

} // namespace
} // namespace wrc::test::vector_log_test
