#include "profile/banded_system.hpp"

#include <cmath>

#include "base/error.hpp"

extern "C" {
/// LAPACK and BLAS: the Cholesky factor of a banded matrix, and triangular banded systems.
void dpbtrf_(const char* uplo, const int* n, const int* kd, double* ab, const int* ldab, int* info);
void dtbsv_(const char* uplo, const char* trans, const char* diag, const int* n, const int* k,
            const double* a, const int* lda, double* x, const int* incx);
}

namespace wrc {
namespace {

void solve_triangle(const BandMatrix& factor, bool transposed, std::vector<double>& x) {
  const int order = static_cast<int>(factor.order());
  const int width = static_cast<int>(factor.width());
  const int rows = width + 1;
  const int step = 1;
  dtbsv_("L", transposed ? "T" : "N", "N", &order, &width, factor.data(), &rows, x.data(), &step);
}

} // namespace

BandCholesky::BandCholesky(BandMatrix matrix) : factor_(std::move(matrix)) {
  const int order = static_cast<int>(factor_.order());
  const int width = static_cast<int>(factor_.width());
  const int rows = width + 1;
  int info = 0;
  dpbtrf_("L", &order, &width, factor_.data(), &rows, &info);
  if (info != 0) {
    throw Error(ErrorCode::internal,
                "banded matrix: not positive definite at row " + std::to_string(info));
  }
}

double BandCholesky::log_determinant() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < factor_.order(); ++i) {
    sum += 2.0 * std::log(factor_.at(i, i));
  }
  return sum;
}

std::vector<double> BandCholesky::solve(std::vector<double> right_side) const {
  solve_triangle(factor_, false, right_side);
  solve_triangle(factor_, true, right_side);
  return right_side;
}

std::vector<double> BandCholesky::solve_upper(std::vector<double> right_side) const {
  solve_triangle(factor_, true, right_side);
  return right_side;
}

BandMatrix BandCholesky::inverse() const {
  const std::size_t n = factor_.order();
  const std::size_t width = factor_.width();
  BandMatrix inverse(n, width);
  // at(i, j) is at[i + j * width]: most of the time of reading a noisy profile is spent here.
  const double* factor_at = factor_.data();
  double* inverse_at = inverse.data();
  for (std::size_t j = n; j-- > 0;) {
    const std::size_t last = std::min(n - 1, j + width);
    const double* factor = factor_at + j * width;
    for (std::size_t i = last + 1; i-- > j;) {
      double sum = i == j ? 1.0 / factor[j] : 0.0;
      for (std::size_t k = j + 1; k < i; ++k) {
        sum -= factor[k] * inverse_at[i + k * width];
      }
      for (std::size_t k = std::max(i, j + 1); k <= last; ++k) {
        sum -= factor[k] * inverse_at[k + i * width];
      }
      inverse_at[i + j * width] = sum / factor[j];
    }
  }
  return inverse;
}

} // namespace wrc
