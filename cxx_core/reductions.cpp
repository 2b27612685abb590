#include "reductions.hpp"

#include <algorithm>
#include <limits>

#include "vector_clones.hpp"

namespace wrc {

WRC_VECTOR_CLONES double sum_of(const double* values, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < count; ++i) {
    sum += values[i];
  }
  return sum;
}

WRC_VECTOR_CLONES double least_of(const double* values, std::size_t count) {
  double least = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : least)
  for (std::size_t i = 0; i < count; ++i) {
    least = std::min(least, values[i]);
  }
  return least;
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

} // namespace wrc
