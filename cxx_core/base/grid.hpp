/// The equally spaced grid of a potential contact area.
///
/// Elements are rectangles; fields hold one value per element centre, with the longitudinal index
/// running fastest: index = lateral_index * longitudinal_count + longitudinal_index.
/// Units mm, in the plane of the contact patch (see patches/contact_frame.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wrc {

struct Grid {
  std::size_t lateral_count = 0;
  std::size_t longitudinal_count = 0;
  double lateral_step = 0.0;       ///< element size across the rail
  double longitudinal_step = 0.0;  ///< element size along the rail
  double lateral_first = 0.0;      ///< centre of the first element
  double longitudinal_first = 0.0; ///< centre of the first element

  [[nodiscard]] std::size_t element_count() const { return lateral_count * longitudinal_count; }
  [[nodiscard]] double element_area() const { return lateral_step * longitudinal_step; }
  [[nodiscard]] double lateral(std::size_t index) const {
    return lateral_first + static_cast<double>(index) * lateral_step;
  }
  [[nodiscard]] double longitudinal(std::size_t index) const {
    return longitudinal_first + static_cast<double>(index) * longitudinal_step;
  }
};

/// Index of the one of `count` positions, a step apart, that is nearest to 0.
inline std::size_t nearest_to_zero(double first, double step, std::size_t count) {
  return static_cast<std::size_t>(
      std::clamp(std::round(-first / step), 0.0, static_cast<double>(count - 1)));
}

} // namespace wrc
