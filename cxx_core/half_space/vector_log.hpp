/// Natural logarithms for vectorised loops: without branches, tables or calls.
///
///   ln x = k ln 2 + ln m,  m = x / 2^k in [sqrt(1/2), sqrt 2),
///   ln m = 2 artanh s = 2 (s + s^3/3 + s^5/5 + ...),  s = (m - 1)/(m + 1), |s| < 0.172
/// (Abramowitz & Stegun 1964, 4.1.27). The series stops at s^21, which leaves 1e-18 of the value.
/// With f = m - 1 the sum is written f - (f^2/2 - s (f^2/2 + R)), R = ln m / s - 2, since 2 s alone
/// would carry the rounding of the division (as in the C library of 4.3BSD, K. C. Ng 1986). Errors
/// are below one unit in the last place. Logarithms of values that are not positive, finite and
/// normal are wrong; nothing is checked. Does not choose the instruction set: call it from a
/// function marked WRC_VECTOR_CLONES; results differ between sets by rounding only.
#pragma once

#include <bit>
#include <cstdint>

#include "base/vector_clones.hpp"

namespace wrc {

/// ln(x + rest) for `rest` below the rounding of x; without has_rest it is not looked at.
template <bool has_rest> WRC_VECTOR_BODY double vector_log_of_sum(double x, double rest) {
  constexpr std::uint64_t fraction_bits = 0x000f'ffff'ffff'ffff;
  constexpr std::uint64_t one = 0x3ff0'0000'0000'0000;
  constexpr std::uint64_t root_of_half = 0x3fe6'a09e'667f'3bcd;
  // The logarithm of 2 in two parts; the first has zeros at its end, so that k times it is exact.
  constexpr double log_two_high = 0x1.62e42feep-1;
  constexpr double log_two_low = 0x1.a39ef35793c76p-33;

  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (one - root_of_half);
  // The exponent as the last bits of 2^52: AVX2 cannot convert integers of this length.
  const double k = std::bit_cast<double>((shifted >> 52U) | std::bit_cast<std::uint64_t>(0x1p52)) -
                   (0x1p52 + 1023.0);
  const double m = std::bit_cast<double>((shifted & fraction_bits) + root_of_half);
  const double f = m - 1.0;
  const double s = f / (2.0 + f);
  const double z = s * s;
  double series = 2.0 / 21.0;
  series = series * z + 2.0 / 19.0;
  series = series * z + 2.0 / 17.0;
  series = series * z + 2.0 / 15.0;
  series = series * z + 2.0 / 13.0;
  series = series * z + 2.0 / 11.0;
  series = series * z + 2.0 / 9.0;
  series = series * z + 2.0 / 7.0;
  series = series * z + 2.0 / 5.0;
  series = series * z + 2.0 / 3.0;
  const double half_square = 0.5 * f * f;
  double small = s * (half_square + series * z) + k * log_two_low;
  if constexpr (has_rest) {
    // rest / x, where 1 / m = (1 - s)/(1 + s) to a hundredth does.
    const double scale = std::bit_cast<double>((2046U - (shifted >> 52U)) << 52U); // 2^-k
    small += rest * scale * (1.0 - 2.0 * s * (1.0 - s));
  }
  return k * log_two_high - ((half_square - small) - f);
}

/// ln x.
WRC_VECTOR_BODY double vector_log(double x) {
  return vector_log_of_sum<false>(x, 0.0);
}

/// ln(1 + x) for x > -1, as accurate relative to its value where x is small.
WRC_VECTOR_BODY double vector_log1p(double x) {
  const double sum = 1.0 + x;
  const double added = sum - 1.0;
  const double rest = (1.0 - (sum - added)) + (x - added);
  return vector_log_of_sum<true>(sum, rest);
}

} // namespace wrc
