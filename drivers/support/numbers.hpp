/// Numbers as texts.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>

namespace driver {

/// With so many digits behind the point.
inline std::string fixed(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

} // namespace driver
