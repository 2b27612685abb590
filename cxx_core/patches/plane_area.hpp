/// Rectangles in the plane of a contact patch, and equally spaced elements in them.
///
/// The potential contact area of a patch is the rectangle that holds its virtual penetration
/// (patches/contact_patches.hpp): elastic displacements are positive everywhere under positive
/// pressures, so there is no contact where the undeformed bodies, lowered by the true approach, do
/// not overlap (Kik & Piotrowski 1996).
/// Units mm; frame of patches/contact_frame.hpp. Thread rule: pure functions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "base/grid.hpp"

namespace wrc {

/// A rectangle in the plane of a contact frame.
struct PlaneArea {
  double lateral_first = 0.0;
  double lateral_last = 0.0;
  double longitudinal_first = 0.0;
  double longitudinal_last = 0.0;

  [[nodiscard]] double width() const { return lateral_last - lateral_first; }
  [[nodiscard]] double length() const { return longitudinal_last - longitudinal_first; }
  /// Moves each edge outwards by a fraction of width and length.
  [[nodiscard]] PlaneArea widened(double share) const;

  /// Contains no point yet.
  [[nodiscard]] static PlaneArea empty() {
    constexpr double unset = std::numeric_limits<double>::infinity();
    return {unset, -unset, unset, -unset};
  }
  /// Moves edges outwards until the point is inside.
  void include(double lateral, double longitudinal) {
    include(PlaneArea{lateral, lateral, longitudinal, longitudinal});
  }
  void include(const PlaneArea& other) {
    lateral_first = std::min(lateral_first, other.lateral_first);
    lateral_last = std::max(lateral_last, other.lateral_last);
    longitudinal_first = std::min(longitudinal_first, other.longitudinal_first);
    longitudinal_last = std::max(longitudinal_last, other.longitudinal_last);
  }
};

/// Equally spaced elements that fill an area.
Grid grid_over(const PlaneArea& area, std::size_t lateral_count, std::size_t longitudinal_count);

/// The next even number: elements around a middle stay where they are while it grows.
std::size_t even_count(double count);

/// Elements of given sizes: all that have their centres in an area and at least one each side of
/// its middle along the rail, and across it one each side of the point at a given fraction of the
/// width from its edge.
Grid grid_with_sizes(const PlaneArea& area, double lateral_step, double longitudinal_step,
                     double share_of_width);

} // namespace wrc
