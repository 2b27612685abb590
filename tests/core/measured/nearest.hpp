/// Distance of a point from a curve, for comparisons.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "profile/curve.hpp"
#include "profile/segments.hpp"

namespace wrc {

/// Least distance: the best of the nodes, then Newton's method on its two pieces, each of which may
/// end before the foot point.
inline double distance_from(const Curve& curve, const Position& position) {
  const auto away = [&](const CurvePoint& point) {
    return std::hypot(position[0] - point.lateral, position[1] - point.height);
  };
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.piece_count(); ++i) {
    const double here = away(curve.at(i, 0.0));
    if (here < least) {
      least = here;
      best = i;
    }
  }
  for (std::size_t i = best > 0 ? best - 1 : 0; i <= best; ++i) {
    const double length = curve.starts()[i + 1] - curve.starts()[i];
    double s = 0.5 * length;
    for (int step = 0; step < 20; ++step) {
      const CurvePoint point = curve.at(i, s);
      s = std::clamp(s + (position[0] - point.lateral) * point.tangent_lateral +
                         (position[1] - point.height) * point.tangent_height,
                     0.0, length);
    }
    least = std::min(least, away(curve.at(i, s)));
  }
  return least;
}

} // namespace wrc
