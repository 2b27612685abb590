/// Measured points without their noise, and what remains uncertain of them.
///
/// noise_model.hpp is fitted to the points' distances from a reference along its normals: first
/// from smoothed points, then from the first result. The likely lines are drawn from what the data
/// leave open: the scatter of a result from line to line is its uncertainty. Equal points give
/// equal lines, different points independent ones. Units mm. Does not know: kinks, which are
/// rounded over a short wave; outliers. Thread rule: no state.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "profile/curve.hpp"

namespace wrc {

struct NoiseRemoval {
  std::vector<Position> points;              ///< at equal arcs
  std::vector<std::vector<Position>> likely; ///< lines that are equally likely
  std::size_t lone_ends = 0;                 ///< points at the ends that were left out
  double deviation = 0.0;                    ///< of the noise, mm
  double distance = 0.0; ///< at which it is independent, mm; 0: from point to point
  /// Waves that are halved, mm: a tenth of the profile halves shorter, a tenth longer ones.
  double short_wave = 0.0;
  double long_wave = 0.0;
};

/// Points in the order of profile.hpp. Throws Error for points that a curve cannot join.
NoiseRemoval remove_noise(std::span<const Position> points);

} // namespace wrc
