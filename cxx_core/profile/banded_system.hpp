/// Symmetric positive definite banded systems: solutions, and the part of the inverse in the band.
///
/// Cholesky factor by LAPACK; the inverse's band from the factor by the equations of Takahashi,
/// Fagan and Chin (1973; Erisman and Tinney, On computing certain elements of the inverse of a
/// sparse matrix, Communications of the ACM 18, 1975), in O(order * width^2).
/// Thread rule: an object serves one thread at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wrc {

/// The lower band of a symmetric matrix by columns: at(i, j) for i from j to j + width.
class BandMatrix {
public:
  BandMatrix() = default;
  BandMatrix(std::size_t order, std::size_t width)
      : order_(order), rows_(width + 1), entries_(order * (width + 1), 0.0) {}

  [[nodiscard]] std::size_t order() const { return order_; }
  [[nodiscard]] std::size_t width() const { return rows_ - 1; }
  [[nodiscard]] double& at(std::size_t row, std::size_t column) {
    return entries_[column * rows_ + row - column];
  }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return entries_[column * rows_ + row - column];
  }
  /// The same for an entry on either side of the diagonal; 0 outside the band.
  [[nodiscard]] double value(std::size_t row, std::size_t column) const {
    const std::size_t low = std::max(row, column);
    const std::size_t high = std::min(row, column);
    return low - high < rows_ ? at(low, high) : 0.0;
  }
  [[nodiscard]] double* data() { return entries_.data(); }
  [[nodiscard]] const double* data() const { return entries_.data(); }

private:
  std::size_t order_ = 0;
  std::size_t rows_ = 1;
  std::vector<double> entries_;
};

/// L L' = matrix.
class BandCholesky {
public:
  /// Throws Error(internal) for a matrix that is not positive definite in double precision.
  explicit BandCholesky(BandMatrix matrix);

  /// The logarithm of the determinant of L L'.
  [[nodiscard]] double log_determinant() const;
  [[nodiscard]] std::vector<double> solve(std::vector<double> right_side) const;
  /// Solves L' x = right_side: of independent normal numbers this makes a sample whose covariance
  /// is the inverse.
  [[nodiscard]] std::vector<double> solve_upper(std::vector<double> right_side) const;
  /// The band of the inverse.
  [[nodiscard]] BandMatrix inverse() const;

private:
  BandMatrix factor_;
};

} // namespace wrc
