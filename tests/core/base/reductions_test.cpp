// Vectorised sums and least values against plain loops, for every length of a remainder.
#include "base/reductions.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::reductions_test {
namespace {

constexpr std::size_t most = 70; ///< more than any unrolled vector loop takes in a step
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> numbers(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = std::sin(1.0 + 3.7 * static_cast<double>(i));
  }
  return values;
}

TEST(Reductions, SumAllNumbers) {
  for (std::size_t count = 0; count <= most; ++count) {
    const std::vector<double> values = numbers(count);
    long double sum = 0.0L;
    for (const double value : values) {
      sum += value;
    }
    EXPECT_NEAR(sum_of(values.data(), count), static_cast<double>(sum), 1e-14) << count;
  }
}

TEST(Reductions, FindTheLeastNumberAnywhere) {
  EXPECT_EQ(least_of(nullptr, 0), infinity);
  for (std::size_t count = 1; count <= most; ++count) {
    std::vector<double> values = numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double before = values[i];
      values[i] = -2.0;
      EXPECT_EQ(least_of(values.data(), count), -2.0) << i << " of " << count;
      values[i] = before;
    }
  }
}

template <class Real> void expect_plain_products() {
  const double rounding = 200.0 * std::numeric_limits<Real>::epsilon();
  for (std::size_t count = 0; count <= most; ++count) {
    const std::vector<double> values = numbers(count + 1);
    const std::vector<Real> one(values.begin(), values.end() - 1);
    const std::vector<Real> other(values.begin() + 1, values.end());
    std::vector<Real> sum = one;
    std::vector<Real> scaled(count);
    add_scaled(sum.data(), -1.5, other.data(), count);
    scale_to(scaled.data(), 0.25, one.data(), count);
    double product = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      product += static_cast<double>(one[i]) * static_cast<double>(other[i]);
      EXPECT_NEAR(sum[i], one[i] - 1.5 * other[i], rounding);
      EXPECT_EQ(scaled[i], Real(0.25) * one[i]);
    }
    EXPECT_NEAR(dot(one.data(), other.data(), count), product, rounding) << count;
  }
}

TEST(Reductions, MultiplyAndAddNumbersOfBothPrecisions) {
  expect_plain_products<float>();
  expect_plain_products<double>();
}

TEST(Reductions, FindWhatIsNotFiniteAnywhere) {
  EXPECT_TRUE(all_finite(nullptr, 0));
  for (std::size_t count = 1; count <= most; ++count) {
    std::vector<double> values = numbers(count);
    values[count / 2] = std::numeric_limits<double>::max();
    EXPECT_TRUE(all_finite(values.data(), count));
    for (const double odd : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
      for (std::size_t i = 0; i < count; ++i) {
        const double before = values[i];
        values[i] = odd;
        EXPECT_FALSE(all_finite(values.data(), count)) << i << " of " << count;
        values[i] = before;
      }
    }
  }
}

} // namespace
} // namespace wrc::test::reductions_test
