#include "models/elliptic_integrals.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace wrc {

EllipticIntegrals elliptic_integrals(double ratio) {
  // Contacts whose width cannot be distinguished from zero, or whose ratio is not a number: the
  // mean of 1 and 0 would not end.
  constexpr double least = std::numeric_limits<double>::min();
  const double k = ratio >= least ? ratio : least;
  double arithmetic = 1.0;
  double geometric = k;
  // sum of 2^(n-1) c_n^2 / e^2 over n >= 1, with c_1^2 / e^2 = (1 - k)/(4 (1 + k)).
  double difference_square = 0.25 * (1.0 - k) / (1.0 + k);
  double weight = 1.0;
  double sum = 0.0;
  while (true) {
    const double mean = 0.5 * (arithmetic + geometric);
    geometric = std::sqrt(arithmetic * geometric);
    arithmetic = mean;
    const double term = weight * difference_square;
    sum += term;
    if (term <= std::numeric_limits<double>::epsilon() * 1e-2) {
      break;
    }
    // c_(n+1) = c_n^2/(4 a_(n+1))
    const double next_mean = 0.5 * (arithmetic + geometric);
    difference_square *= difference_square * (1.0 - k * k) / (16.0 * next_mean * next_mean);
    weight *= 2.0;
  }
  const double complete = 0.5 * std::numbers::pi / arithmetic;
  return {complete, complete * (0.5 - sum), complete * (0.5 + sum)};
}

} // namespace wrc
