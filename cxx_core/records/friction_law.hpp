/// Friction between wheel and rail, as it is given (creep/friction.hpp).
///
/// Units mm, s. Thread rule: plain values.
#pragma once

#include <vector>

namespace wrc {

struct FrictionAtPlace {
  double s; ///< on the wheel's profile
  double coefficient;
  bool operator==(const FrictionAtPlace&) const = default;
};

struct FrictionLaw {
  double coefficient = 0.3;              ///< at rest, if no positions are given
  std::vector<FrictionAtPlace> places{}; ///< in the order of s
  double limit_ratio = 1.0;              ///< A
  double decay = 0.0;                    ///< B, s/mm

  [[nodiscard]] bool falls() const { return limit_ratio < 1.0 && decay > 0.0; }
};

} // namespace wrc
