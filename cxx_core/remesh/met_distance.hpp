/// Which undeformed distances are distances: a ray that misses wheel or rail has none.
///
/// Slopes and parabolas through the distances of neighbouring elements leave such rays out.
/// Units mm. Thread rule: pure functions.
#pragma once

#include "remesh/constants.hpp"

namespace wrc {

/// Of a distance from which approaches may have been subtracted.
constexpr bool is_met(double distance) {
  return distance < 0.5 * no_material_distance;
}

} // namespace wrc
