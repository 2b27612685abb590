/// One number of the library beside the number it should be.
#pragma once

#include <string>
#include <vector>

namespace driver {

/// How far a number may be off, and why that much.
struct Tolerance {
  std::string name;
  double relative = 0.0;
  std::string reason;
};

struct Check {
  std::string group; ///< "paper", "hertz", "contact", "own"
  std::string name;  ///< of the case
  std::string result;
  double expected = 0.0;
  double actual = 0.0;
  Tolerance tolerance;
  std::string trouble; ///< why there is no number, "" if there is one

  [[nodiscard]] double deviation() const;
  [[nodiscard]] bool passed() const;
};

} // namespace driver
