/// Small questions about curves, and numbers as texts.
#pragma once

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "support/numbers.hpp"
#include "wrc_paper/claims.hpp"

namespace driver {

/// A number of which only the size matters.
inline std::string small(double value) {
  std::ostringstream text;
  text << std::setprecision(1) << value;
  return text.str();
}

inline Verdict verdict_of(bool holds) {
  return holds ? Verdict::confirmed : Verdict::not_confirmed;
}

/// Confirmed if both hold, partly if one does.
inline Verdict verdict_of(bool one, bool other) {
  return one && other   ? Verdict::confirmed
         : one || other ? Verdict::partly
                        : Verdict::not_confirmed;
}

inline double width_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

/// Largest difference between the values at x and at -x, for curves over places symmetric to zero.
inline double asymmetry(const std::vector<double>& values) {
  double most = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    most = std::max(most, std::abs(values[i] - values[values.size() - 1 - i]));
  }
  return most;
}

} // namespace driver
