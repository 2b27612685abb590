#include "table/tensor_spline.hpp"

#include "base/error.hpp"

extern "C" {
/// LAPACK: factors of a banded matrix, and solutions by them. Bands this narrow are not blocked,
/// and dgbtrf would lay 66 kB for blocks on the stack.
void dgbtf2_(const int* m, const int* n, const int* kl, const int* ku, double* ab, const int* ldab,
             int* ipiv, int* info);
void dgbtrs_(const char* trans, const int* n, const int* kl, const int* ku, const int* nrhs,
             const double* ab, const int* ldab, const int* ipiv, double* b, const int* ldb,
             int* info);
}

namespace wrc {

void interpolate_lines(const SplineAxis& axis, double* values, std::size_t stride,
                       const std::vector<std::size_t>& lines) {
  constexpr int below = 2;
  constexpr int above = 2;
  constexpr int rows = 2 * below + above + 1;
  const int order = static_cast<int>(axis.count);
  std::vector<double> band(static_cast<std::size_t>(rows) * axis.count);
  for (std::size_t i = 0; i < axis.count; ++i) {
    const SplineAxis::Weights weights = axis.at(axis.node(i));
    for (std::size_t k = 0; k < weights.value.size(); ++k) {
      const std::size_t column = weights.index + k;
      if (column + below >= i && column <= i + above) { // beyond, the basis is 0 at the node
        band[column * rows + static_cast<std::size_t>(below + above) + i - column] =
            weights.value[k];
      }
    }
  }
  std::vector<int> pivots(axis.count);
  int info = 0;
  dgbtf2_(&order, &order, &below, &above, band.data(), &rows, pivots.data(), &info);
  // Lines in groups, so that they take little memory of their own.
  constexpr std::size_t group = 64;
  std::vector<double> right(group * axis.count);
  for (std::size_t from = 0; from < lines.size() && info == 0; from += group) {
    const std::size_t count = std::min(group, lines.size() - from);
    const int sides = static_cast<int>(count);
    for (std::size_t line = 0; line < count; ++line) {
      for (std::size_t i = 0; i < axis.count; ++i) {
        right[line * axis.count + i] = values[lines[from + line] + i * stride];
      }
    }
    dgbtrs_("N", &order, &below, &above, &sides, band.data(), &rows, pivots.data(), right.data(),
            &order, &info);
    for (std::size_t line = 0; line < count; ++line) {
      for (std::size_t i = 0; i < axis.count; ++i) {
        values[lines[from + line] + i * stride] = right[line * axis.count + i];
      }
    }
  }
  if (info != 0) {
    throw Error(ErrorCode::internal, "spline: its nodes do not determine it");
  }
}

} // namespace wrc
