/// Tables and spectra that are kept: right, positive, and the same bits however they came about.
#include "half_space/influence_cache.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "half_space/influence_coefficients.hpp"

namespace wrc::test::influence_cache_test {
namespace {

/// Far coefficients are sums of another order in a row than alone.
constexpr double same_coefficient = 1e-14;
/// Rounding of a transform relative to the sum of the coefficients.
constexpr double same_spectrum = 1e-13;

template <typename Real>
void expect_same_bits(const KernelSpectrum<Real>& left, const KernelSpectrum<Real>& right) {
  ASSERT_EQ(left.rows, right.rows);
  ASSERT_EQ(left.columns, right.columns);
  for (std::size_t column = 0; column <= left.columns / 2; ++column) {
    ASSERT_TRUE(
        std::equal(left.column(column), left.column(column) + left.rows, right.column(column)));
  }
}

TEST(InfluenceCache, TablesHoldLovesCoefficients) {
  InfluenceCache cache;
  for (const double aspect : {1.0 / 200.0, 0.3, 1.0, 100.0}) {
    const auto kept = cache.table({aspect}, 30, 50);
    const InfluenceTable& table = *kept;
    ASSERT_GE(table.rows, 30U);
    ASSERT_GE(table.columns, 50U);
    for (std::size_t row = 0; row < 30; ++row) {
      for (std::size_t column = 0; column < 50; ++column) {
        ASSERT_NEAR(table.row(row)[column] / influence_integral(static_cast<double>(column),
                                                                static_cast<double>(row) * aspect,
                                                                1.0, aspect),
                    1.0, same_coefficient)
            << row << ", " << column << ", aspect " << aspect;
      }
    }
  }
}

TEST(InfluenceCache, TablesOfSmoothElementsHoldTheCorrectedCoefficients) {
  InfluenceCache cache;
  for (const double aspect : {1.0 / 200.0, 0.3, 1.0, 100.0}) {
    const auto kept = cache.table({aspect, Elements::smooth}, 30, 50);
    const InfluenceTable& table = *kept;
    for (std::size_t row = 0; row < 30; ++row) {
      for (std::size_t column = 0; column < 50; ++column) {
        const double expected =
            influence_coefficient(static_cast<double>(column), static_cast<double>(row) * aspect,
                                  1.0, aspect, 1.0 / std::numbers::pi, Elements::smooth);
        ASSERT_NEAR(table.row(row)[column] / expected, 1.0, same_coefficient)
            << row << ", " << column << ", aspect " << aspect;
      }
    }
    EXPECT_NE(table.row(0)[0], cache.table({aspect}, 30, 50)->row(0)[0]) << "tables of their own";
  }
}

TEST(InfluenceCache, EnlargedTablesHaveTheSameBits) {
  InfluenceCache grown;
  for (std::size_t size = 3; size < 70; size += 11) {
    const auto table = grown.table({0.7}, size, 2 * size + 1);
    InfluenceCache fresh;
    const auto expected = fresh.table({0.7}, size, 2 * size + 1);
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t column = 0; column <= 2 * size; ++column) {
        ASSERT_EQ(table->row(row)[column], expected->row(row)[column]);
      }
    }
  }
}

template <typename Real> class SpectrumTest : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(SpectrumTest, Precisions, );

TYPED_TEST(SpectrumTest, IsTheTransformOfTheWrappedKernel) {
  InfluenceCache cache;
  const double pi = std::acos(-1.0);
  for (const auto& [rows, columns] :
       {std::pair<std::size_t, std::size_t>{2, 2}, {6, 10}, {9, 5}, {16, 12}}) {
    for (const double aspect : {0.05, 1.0, 4.0}) {
      const auto spectrum = cache.spectrum<TypeParam>({aspect}, rows, columns);
      const auto inverse = cache.inverse_spectrum<TypeParam>({aspect}, rows, columns);
      const auto count = static_cast<double>(rows * columns);
      const auto kernel = [&, rows = rows, columns = columns](std::size_t row, std::size_t column) {
        return influence_integral(static_cast<double>(std::min(column, columns - column)),
                                  static_cast<double>(std::min(row, rows - row)) * aspect, 1.0,
                                  aspect);
      };
      double whole = 0.0;
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
          whole += kernel(row, column);
        }
      }
      const double rounding = whole * (same_spectrum + std::numeric_limits<TypeParam>::epsilon());
      for (std::size_t k = 0; k < rows; ++k) {
        for (std::size_t l = 0; l <= columns / 2; ++l) {
          double expected = 0.0;
          for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t column = 0; column < columns; ++column) {
              const double turns = static_cast<double>(k * row) / static_cast<double>(rows) +
                                   static_cast<double>(l * column) / static_cast<double>(columns);
              expected += kernel(row, column) * std::cos(2.0 * pi * turns);
            }
          }
          const double value = spectrum->column(l)[k];
          ASSERT_NEAR(value * count, expected, rounding);
          ASSERT_NEAR(inverse->column(l)[k] * count * expected, 1.0, 2.0 * rounding / expected);
        }
      }
    }
  }
}

TYPED_TEST(SpectrumTest, IsPositive) {
  InfluenceCache cache;
  for (const double aspect : {1.0 / 200.0, 1.0 / 30.0, 0.2, 1.0, 3.0, 40.0, 200.0}) {
    for (const auto& [rows, columns] :
         {std::pair<std::size_t, std::size_t>{2, 2}, {16, 48}, {80, 6}, {128, 144}, {2, 512}}) {
      const auto spectrum = cache.spectrum<TypeParam>({aspect}, rows, columns);
      const auto inverse = cache.inverse_spectrum<TypeParam>({aspect}, rows, columns);
      for (std::size_t column = 0; column <= columns / 2; ++column) {
        for (std::size_t row = 0; row < rows; ++row) {
          ASSERT_GT(spectrum->column(column)[row], TypeParam{0})
              << rows << " x " << columns << ", aspect " << aspect;
          ASSERT_GT(inverse->column(column)[row], TypeParam{0});
          ASSERT_TRUE(std::isfinite(inverse->column(column)[row]));
        }
      }
    }
  }
}

TYPED_TEST(SpectrumTest, IsTheSameBitsKeptOrFreshOrDropped) {
  InfluenceCache warm;
  // A larger table than needed, from another call.
  warm.table({1.5}, 200, 150);
  const auto first = warm.spectrum<TypeParam>({1.5}, 48, 64);
  const auto first_inverse = warm.inverse_spectrum<TypeParam>({1.5}, 48, 64);
  EXPECT_EQ(warm.spectrum<TypeParam>({1.5}, 48, 64).get(), first.get()) << "kept";
  warm.spectrum<TypeParam>({0.1}, 30, 30);
  warm.drop_unused();
  warm.drop_unused();
  warm.drop_unused();
  const auto again = warm.spectrum<TypeParam>({1.5}, 48, 64);
  EXPECT_NE(again.get(), first.get()) << "dropped; the first one is still held here";
  expect_same_bits(*again, *first);
  expect_same_bits(*warm.inverse_spectrum<TypeParam>({1.5}, 48, 64), *first_inverse);
  InfluenceCache fresh;
  expect_same_bits(*fresh.spectrum<TypeParam>({1.5}, 48, 64), *first);
  expect_same_bits(*fresh.inverse_spectrum<TypeParam>({1.5}, 48, 64), *first_inverse);
}

TEST(InfluenceCache, KeepsTablesOfTheLastTwoSolutions) {
  InfluenceCache cache;
  const auto first = cache.spectrum<double>({1.0}, 32, 32);
  const auto second = cache.spectrum<double>({2.0}, 32, 32);
  cache.drop_unused();
  for (int solution = 0; solution < 2; ++solution) {
    EXPECT_EQ(cache.spectrum<double>({1.0}, 32, 32).get(), first.get());
    cache.drop_unused();
    cache.drop_unused();
  }
  EXPECT_EQ(cache.spectrum<double>({1.0}, 32, 32).get(), first.get());
  EXPECT_NE(cache.spectrum<double>({2.0}, 32, 32).get(), second.get()) << "unused by five";
}

} // namespace
} // namespace wrc::test::influence_cache_test
