#include "wrc_regression/check.hpp"

#include <cmath>

namespace driver {

double Check::deviation() const {
  return expected == 0.0 ? actual : actual / expected - 1.0;
}

bool Check::passed() const {
  // Not "greater than": a NaN must fail.
  return trouble.empty() && std::abs(deviation()) <= tolerance.relative;
}

} // namespace driver
