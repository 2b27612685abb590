/// The arc length of a slice over the parameter across a surface: corresponding features of all
/// slices lie at the same parameter.
///
/// Between features u_k, where the arc length is s_k, a quintic with the slopes
///   s'_k = 2 / (1 / d_(k-1) + 1 / d_k),  d_k = (s_(k+1) - s_k) / (u_(k+1) - u_k),
/// the harmonic mean (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984), that of the only
/// neighbour at both ends, and s'' = 0 at features. The map is C2, so the surface is C2 across as
/// the slices are, and ascends, since no slope is above 2 d: s' is linear in both slopes of an
/// interval and not negative for slopes 0 and 2 d in any combination.
/// Units mm. Thread rule: immutable after construction, safe to share.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "profile/quintic.hpp"

namespace wrc {

class FeatureMap {
public:
  /// Both ascend strictly, at least two of each. Equal ones make exactly s = u.
  FeatureMap(std::span<const double> parameters, std::span<const double> arcs);

  /// Arc length with its derivatives by the parameter, at a parameter between two features.
  [[nodiscard]] QuinticValues at(std::size_t interval, double parameter) const {
    return is_identity_ ? QuinticValues{parameter, 1.0, 0.0}
                        : evaluate(polynomials_[interval], parameter - parameters_[interval]);
  }

private:
  bool is_identity_;
  std::vector<double> parameters_;
  std::vector<Quintic> polynomials_;
};

} // namespace wrc
