/// A polynomial of the fifth degree by the values and two derivatives at its ends.
///
/// Quintic Hermite interpolation (Farin, Curves and Surfaces for CAGD, 2002, ch. 7): error
/// h^6 / 46080 times the sixth derivative over a length h. Ascending coefficients about the begin.
/// Units are the caller's. Thread rule: pure functions.
#pragma once

#include <array>
#include <cstddef>

namespace wrc {

using Quintic = std::array<double, 6>;

struct QuinticValues {
  double value;
  double first;
  double second;
};

/// Value and two derivatives at a distance from the begin, in one Horner pass.
inline QuinticValues evaluate(const Quintic& c, double s) {
  double value = c[5];
  double first = 0.0;
  double half_second = 0.0;
  for (std::size_t power = 5; power-- > 0;) {
    half_second = half_second * s + first;
    first = first * s + value;
    value = value * s + c[power];
  }
  return {value, first, 2.0 * half_second};
}

/// The quintic with given end values and derivatives. What the second order Taylor polynomial of
/// the begin leaves over at the end sets the upper three coefficients, so that the rounding of
/// large positions does not enter twice.
inline Quintic quintic(const QuinticValues& begin, const QuinticValues& end, double length) {
  const double h = length;
  const double value = (end.value - begin.value) - h * (begin.first + 0.5 * h * begin.second);
  const double first = ((end.first - begin.first) - h * begin.second) * h;
  const double second = (end.second - begin.second) * h * h;
  const double cube = 1.0 / (h * h * h);
  return {begin.value,
          begin.first,
          0.5 * begin.second,
          (10.0 * value - 4.0 * first + 0.5 * second) * cube,
          (-15.0 * value + 7.0 * first - second) * cube / h,
          (6.0 * value - 3.0 * first + 0.5 * second) * cube / (h * h)};
}

} // namespace wrc
