#include "base/reductions.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/vector_clones.hpp"

namespace wrc {
namespace {

template <typename Real>
WRC_VECTOR_BODY double dot_body(const Real* one, const Real* other, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < count; ++i) {
    sum += one[i] * other[i];
  }
  return sum;
}

template <typename Real>
WRC_VECTOR_BODY void add_body(Real* to, Real factor, const Real* from, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    to[i] += factor * from[i];
  }
}

template <typename Real>
WRC_VECTOR_BODY void scale_body(Real* to, Real factor, const Real* from, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = factor * from[i];
  }
}

} // namespace

WRC_VECTOR_CLONES double sum_of(const double* values, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < count; ++i) {
    sum += values[i];
  }
  return sum;
}

WRC_VECTOR_CLONES double least_of(const double* values, std::size_t count) {
  // Independent lanes: a single least value is not vectorised, for fear of values that are no
  // numbers.
  constexpr std::size_t lanes = 16;
  std::array<double, lanes> least;
  least.fill(std::numeric_limits<double>::infinity());
  const std::size_t whole = count - count % lanes;
  for (std::size_t i = 0; i < whole; i += lanes) {
#pragma omp simd
    for (std::size_t k = 0; k < lanes; ++k) {
      least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
    }
  }
  for (std::size_t i = whole; i < count; ++i) {
    least[0] = std::min(least[0], values[i]);
  }
  return *std::min_element(least.begin(), least.end());
}

WRC_VECTOR_CLONES bool all_finite(const double* values, std::size_t count) {
  // 0 times a value is 0 unless the value is not finite.
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < count; ++i) {
    sum += 0.0 * values[i];
  }
  return sum == 0.0;
}

WRC_VECTOR_CLONES double least_ratio(const double* values, const double* others,
                                     std::size_t count) {
  double least = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : least)
  for (std::size_t i = 0; i < count; ++i) {
    const double ratio = values[i] / others[i];
    least = ratio < least ? ratio : least;
  }
  return least;
}

// Both precisions: the attribute does not work on templates themselves.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define REDUCTIONS(Real)                                                                           \
  template <>                                                                                      \
  WRC_VECTOR_CLONES double dot(const Real* one, const Real* other, std::size_t count) {            \
    return dot_body(one, other, count);                                                            \
  }                                                                                                \
  template <>                                                                                      \
  WRC_VECTOR_CLONES void add_scaled(Real* to, double factor, const Real* from,                     \
                                    std::size_t count) {                                           \
    add_body(to, static_cast<Real>(factor), from, count);                                          \
  }                                                                                                \
  template <>                                                                                      \
  WRC_VECTOR_CLONES void scale_to(Real* to, double factor, const Real* from, std::size_t count) {  \
    scale_body(to, static_cast<Real>(factor), from, count);                                        \
  }

REDUCTIONS(float)
REDUCTIONS(double)
#undef REDUCTIONS
// NOLINTEND(bugprone-macro-parentheses)

} // namespace wrc
