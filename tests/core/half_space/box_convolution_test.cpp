/// The pruned convolution against sums over all pairs of elements, and the preconditioner against
/// the periodic convolution it inverts.
#include "half_space/box_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "half_space/influence_coefficients.hpp"

namespace wrc::test::box_convolution_test {
namespace {

/// Errors relative to the largest value, over rounding: it grows like the logarithm of the lengths
/// and with the sum of the coefficients; the largest seen is 5.
constexpr double roundings = 20.0;
/// The inverse times the operator, over rounding: the condition number is some hundreds.
constexpr double inverse_roundings = 2000.0;

template <typename Real> constexpr double rounding_of = std::numeric_limits<Real>::epsilon();

template <typename Real> std::vector<Real> random_field(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<Real> field(count);
  for (Real& value : field) {
    value = static_cast<Real>(static_cast<double>(generator() >> 11) * 0x1p-53);
  }
  return field;
}

/// Sums over all pairs, in more digits than the convolution has where the compiler has them.
template <typename Real>
std::vector<double> dense_sum(const ConvolutionShape& shape, double aspect,
                              const std::vector<Real>& in) {
  const auto reach = [](std::size_t inside, std::size_t outside, std::ptrdiff_t offset) {
    return inside + outside + static_cast<std::size_t>(std::abs(offset));
  };
  const std::size_t pitch = reach(shape.columns_in, shape.columns_out, shape.column_offset);
  std::vector<double> kernel(reach(shape.rows_in, shape.rows_out, shape.row_offset) * pitch);
  for (std::size_t index = 0; index < kernel.size(); ++index) {
    kernel[index] = influence_integral(static_cast<double>(index % pitch),
                                       static_cast<double>(index / pitch) * aspect, 1.0, aspect);
  }
  const auto apart = [](std::size_t to, std::ptrdiff_t offset, std::size_t from) {
    return static_cast<std::size_t>(
        std::abs(static_cast<std::ptrdiff_t>(to) + offset - static_cast<std::ptrdiff_t>(from)));
  };
  std::vector<double> out;
  for (std::size_t row_to = 0; row_to < shape.rows_out; ++row_to) {
    for (std::size_t column_to = 0; column_to < shape.columns_out; ++column_to) {
      long double sum = 0.0;
      for (std::size_t row = 0; row < shape.rows_in; ++row) {
        const double* line = kernel.data() + apart(row_to, shape.row_offset, row) * pitch;
        for (std::size_t column = 0; column < shape.columns_in; ++column) {
          sum += static_cast<long double>(line[apart(column_to, shape.column_offset, column)]) *
                 static_cast<long double>(in[row * shape.columns_in + column]);
        }
      }
      out.push_back(static_cast<double>(sum));
    }
  }
  return out;
}

template <typename Real, typename Other>
double largest_difference(const std::vector<Real>& found, const std::vector<Other>& expected) {
  double worst = 0.0;
  double largest = 0.0;
  for (std::size_t index = 0; index < found.size(); ++index) {
    worst = std::max(
        worst, std::abs(static_cast<double>(found[index]) - static_cast<double>(expected[index])));
    largest = std::max(largest, std::abs(static_cast<double>(expected[index])));
  }
  return worst / largest;
}

template <typename Real>
void expect_dense_sum(const ConvolutionShape& shape, double aspect, InfluenceCache& cache,
                      ConvolutionWorkspace<Real>& workspace) {
  const std::vector<Real> in = random_field<Real>(shape.rows_in * shape.columns_in, 3);
  std::vector<Real> out(shape.rows_out * shape.columns_out);
  BoxConvolution<Real>::linear(shape, {aspect}, cache).apply(in.data(), out.data(), workspace);
  EXPECT_LE(largest_difference(out, dense_sum(shape, aspect, in)), roundings * rounding_of<Real>)
      << shape.rows_in << " x " << shape.columns_in << " to " << shape.rows_out << " x "
      << shape.columns_out << " at " << shape.row_offset << ", " << shape.column_offset
      << ", aspect " << aspect;
}

template <typename Real> class BoxConvolutionTest : public testing::Test {
protected:
  InfluenceCache cache;
  ConvolutionWorkspace<Real> workspace;
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(BoxConvolutionTest, Precisions, );

TYPED_TEST(BoxConvolutionTest, EqualsTheDenseSumOnARectangle) {
  for (std::size_t rows = 1; rows <= 40; rows += rows < 10 ? 1 : 5) {
    for (const std::size_t columns : {1U, 2U, 3U, 7U, 8U, 9U, 16U, 31U, 40U}) {
      expect_dense_sum<TypeParam>({rows, columns, rows, columns, 0, 0}, 1.7, this->cache,
                                  this->workspace);
    }
  }
}

TYPED_TEST(BoxConvolutionTest, EqualsTheDenseSumForAllElementShapes) {
  for (const double aspect : {1.0 / 200.0, 1.0 / 16.0, 1.0, 6.0, 200.0}) {
    expect_dense_sum<TypeParam>({17, 12, 17, 12, 0, 0}, aspect, this->cache, this->workspace);
    expect_dense_sum<TypeParam>({3, 14, 9, 5, -6, 11}, aspect, this->cache, this->workspace);
  }
}

TYPED_TEST(BoxConvolutionTest, EqualsTheDenseSumBetweenTwoRectangles) {
  std::mt19937_64 generator(11);
  for (int draw = 0; draw < 100; ++draw) {
    const auto size = [&] { return 1 + static_cast<std::size_t>(generator() % 40); };
    const auto offset = [&] { return static_cast<std::ptrdiff_t>(generator() % 81) - 40; };
    ConvolutionShape shape{size(), size(), size(), size(), offset(), offset()};
    // Every fourth holds the first rectangle, as the check of the exterior does.
    if (draw % 4 == 0) {
      shape.row_offset = -std::abs(shape.row_offset);
      shape.column_offset = -std::abs(shape.column_offset);
      shape.rows_out = shape.rows_in + static_cast<std::size_t>(-shape.row_offset) + size();
      shape.columns_out = shape.columns_in + static_cast<std::size_t>(-shape.column_offset);
    }
    expect_dense_sum<TypeParam>(shape, 0.6, this->cache, this->workspace);
  }
}

TYPED_TEST(BoxConvolutionTest, WorksInPlace) {
  for (const std::size_t rows : {1U, 7U, 8U, 24U, 37U}) {
    const std::size_t columns = 19;
    const std::vector<TypeParam> in = random_field<TypeParam>(rows * columns, 5);
    std::vector<TypeParam> apart(in.size());
    std::vector<TypeParam> in_place = in;
    const auto convolution =
        BoxConvolution<TypeParam>::linear({rows, columns, rows, columns, 0, 0}, {2.0}, this->cache);
    convolution.apply(in.data(), apart.data(), this->workspace);
    convolution.apply(in_place.data(), in_place.data(), this->workspace);
    EXPECT_EQ(in_place, apart);
  }
}

TYPED_TEST(BoxConvolutionTest, WhatTheWorkspaceHoldsDoesNotShow) {
  const ConvolutionShape shape{13, 9, 21, 30, -4, -8};
  const std::vector<TypeParam> in = random_field<TypeParam>(13 * 9, 6);
  std::vector<TypeParam> first(21 * 30);
  std::vector<TypeParam> again(21 * 30);
  const auto convolution = BoxConvolution<TypeParam>::linear(shape, {2.0}, this->cache);
  ConvolutionWorkspace<TypeParam> fresh;
  convolution.apply(in.data(), first.data(), fresh);
  // Lines full of huge values and of no numbers at all.
  for (const TypeParam spoilt : {TypeParam{1e30F}, std::numeric_limits<TypeParam>::quiet_NaN()}) {
    const std::vector<TypeParam> large(40 * 40, spoilt);
    std::vector<TypeParam> ignored(40 * 40);
    BoxConvolution<TypeParam>::linear({40, 40, 40, 40, 0, 0}, {2.0}, this->cache)
        .apply(large.data(), ignored.data(), this->workspace);
    convolution.apply(in.data(), again.data(), this->workspace);
    EXPECT_EQ(again, first);
  }
}

TYPED_TEST(BoxConvolutionTest, PreconditionerInvertsThePeriodicConvolution) {
  for (const auto& [rows, columns] :
       {std::pair<std::size_t, std::size_t>{2, 2}, {16, 16}, {48, 32}, {6, 64}}) {
    ASSERT_EQ(fast_line_length(rows), rows) << "a period of its own";
    ASSERT_EQ(fast_line_length(columns), columns);
    for (const double aspect : {0.1, 1.0, 3.0}) {
      // Love's coefficients wrapped around: the nearest image counts.
      const std::vector<TypeParam> pressure = random_field<TypeParam>(rows * columns, 8);
      std::vector<double> kernel(rows * columns);
      for (std::size_t index = 0; index < kernel.size(); ++index) {
        const std::size_t i = index / columns;
        const std::size_t j = index % columns;
        kernel[index] =
            influence_integral(static_cast<double>(std::min(j, columns - j)),
                               static_cast<double>(std::min(i, rows - i)) * aspect, 1.0, aspect);
      }
      std::vector<TypeParam> displacement(pressure.size());
      for (std::size_t to = 0; to < pressure.size(); ++to) {
        double sum = 0.0;
        for (std::size_t from = 0; from < pressure.size(); ++from) {
          const std::size_t i = (to / columns + rows - from / columns) % rows;
          const std::size_t j = (to % columns + columns - from % columns) % columns;
          sum += kernel[i * columns + j] * static_cast<double>(pressure[from]);
        }
        displacement[to] = static_cast<TypeParam>(sum);
      }
      std::vector<TypeParam> found(pressure.size());
      BoxConvolution<TypeParam>::inverse_periodic(rows, columns, {aspect}, this->cache)
          .apply(displacement.data(), found.data(), this->workspace);
      EXPECT_LE(largest_difference(found, pressure), inverse_roundings * rounding_of<TypeParam>)
          << rows << " x " << columns << ", aspect " << aspect;
    }
  }
}

TYPED_TEST(BoxConvolutionTest, PreconditionerIsSymmetricAndPositive) {
  for (const auto& [rows, columns] :
       {std::pair<std::size_t, std::size_t>{13, 21}, {1, 9}, {30, 5}}) {
    const std::size_t count = rows * columns;
    const auto preconditioner =
        BoxConvolution<TypeParam>::inverse_periodic(rows, columns, {0.5}, this->cache);
    std::vector<std::vector<TypeParam>> answers;
    for (std::size_t element = 0; element < count; ++element) {
      std::vector<TypeParam> unit(count, TypeParam{0});
      unit[element] = TypeParam{1};
      preconditioner.apply(unit.data(), unit.data(), this->workspace);
      answers.push_back(std::move(unit));
    }
    const double scale = answers[0][0];
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_GT(answers[i][i], TypeParam{0});
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_NEAR(answers[i][j], answers[j][i], roundings * rounding_of<TypeParam> * scale);
      }
    }
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      std::vector<TypeParam> field = random_field<TypeParam>(count, seed);
      for (TypeParam& value : field) {
        value -= TypeParam{0.5};
      }
      std::vector<TypeParam> answer(count);
      preconditioner.apply(field.data(), answer.data(), this->workspace);
      double product = 0.0;
      for (std::size_t i = 0; i < count; ++i) {
        product += static_cast<double>(field[i]) * static_cast<double>(answer[i]);
      }
      EXPECT_GT(product, 0.0);
    }
  }
}

} // namespace
} // namespace wrc::test::box_convolution_test
