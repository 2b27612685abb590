/// Banded Cholesky factors against dense products.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/banded_system.hpp"

namespace wrc::test::banded_system_test {
namespace {

constexpr std::size_t order = 9;
constexpr double rounding = 1e-12; ///< of a few hundred operations on numbers of about 1

/// Diagonally dominant, with irregular entries.
BandMatrix sample() {
  BandMatrix matrix(order, 3);
  for (std::size_t j = 0; j < order; ++j)
    for (std::size_t i = j; i < std::min(order, j + 4); ++i)
      matrix.at(i, j) = i == j ? 4.0 + 0.3 * static_cast<double>(j)
                               : std::sin(static_cast<double>(7 * i + 3 * j));
  return matrix;
}

std::vector<double> product(const BandMatrix& matrix, const std::vector<double>& x) {
  std::vector<double> y(order, 0.0);
  for (std::size_t i = 0; i < order; ++i)
    for (std::size_t j = 0; j < order; ++j)
      y[i] += matrix.value(i, j) * x[j];
  return y;
}

TEST(BandedSystem, SolutionsMeetTheirSystem) {
  const BandMatrix matrix = sample();
  std::vector<double> right_side;
  for (std::size_t i = 0; i < order; ++i)
    right_side.push_back(std::cos(static_cast<double>(i)));
  const std::vector<double> back = product(matrix, BandCholesky(matrix).solve(right_side));
  for (std::size_t i = 0; i < order; ++i)
    EXPECT_NEAR(back[i], right_side[i], rounding);
}

/// Columns of the inverse by solutions, and the determinant by its factor of 2^order when the
/// matrix is doubled.
TEST(BandedSystem, InverseAndDeterminantAreThoseOfTheMatrix) {
  BandMatrix matrix = sample();
  const BandCholesky factor(matrix);
  const BandMatrix inverse = factor.inverse();
  for (std::size_t j = 0; j < order; ++j) {
    std::vector<double> unit(order, 0.0);
    unit[j] = 1.0;
    const std::vector<double> column = factor.solve(unit);
    for (std::size_t i = j; i < std::min(order, j + 4); ++i)
      EXPECT_NEAR(inverse.at(i, j), column[i], rounding);
  }
  const double before = factor.log_determinant();
  for (std::size_t j = 0; j < order; ++j)
    for (std::size_t i = j; i < std::min(order, j + 4); ++i)
      matrix.at(i, j) *= 2.0;
  EXPECT_NEAR(BandCholesky(matrix).log_determinant() - before,
              static_cast<double>(order) * std::log(2.0), rounding);
  BandMatrix diagonal(2, 0);
  diagonal.at(0, 0) = 2.0;
  diagonal.at(1, 1) = 3.0;
  EXPECT_NEAR(BandCholesky(diagonal).log_determinant(), std::log(6.0), rounding);
}

/// Samples L'^-1 z of unit vectors z have the inverse as the sum of their squares.
TEST(BandedSystem, SamplesHaveTheInverseAsCovariance) {
  const BandCholesky factor(sample());
  const BandMatrix inverse = factor.inverse();
  std::vector<double> squares(order, 0.0);
  for (std::size_t j = 0; j < order; ++j) {
    std::vector<double> unit(order, 0.0);
    unit[j] = 1.0;
    const std::vector<double> drawn = factor.solve_upper(unit);
    for (std::size_t i = 0; i < order; ++i)
      squares[i] += drawn[i] * drawn[i];
  }
  for (std::size_t i = 0; i < order; ++i)
    EXPECT_NEAR(squares[i], inverse.at(i, i), rounding);
}

TEST(BandedSystem, RefusesWhatIsNotPositiveDefinite) {
  BandMatrix matrix = sample();
  matrix.at(4, 4) = -1.0;
  try {
    const BandCholesky factor(matrix);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::internal);
    EXPECT_NE(std::string(error.what()).find("row 5"), std::string::npos);
  }
}

} // namespace
} // namespace wrc::test::banded_system_test
