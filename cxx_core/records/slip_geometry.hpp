/// What the slip of a patch follows from, row by row (creep/rigid_slip.hpp).
///
/// Left-hand frame of the side. Units mm, N, rad. Thread rule: plain values.
#pragma once

#include <array>
#include <vector>

#include "records/motion.hpp"

namespace wrc {

/// The surface on a row of elements.
struct SlipRow {
  double lateral = 0.0; ///< from the plane's origin
  double height = 0.0;  ///< over the plane
  double sine = 0.0;    ///< of the angle by which it rises against the plane
  double cosine = 1.0;
  double excess = 0.0; ///< of rows along a curve: by how much its arc is longer than `lateral`

  /// Lateral position on the grid, for which the creepages' spin counts.
  [[nodiscard]] double on_grid() const { return lateral + excess; }
};

/// A row with its pressures: their sum and moments about the origin.
struct LoadedRow : SlipRow {
  double force = 0.0;
  double first = 0.0;  ///< by x
  double second = 0.0; ///< by x^2
  double across = 0.0; ///< by the square of the distance across from the row's middle
};

/// Rows xi, eta, phi, columns as Twist.
using CreepagesByTwist = std::array<std::array<double, twist_count>, 3>;

/// What the slip of a patch follows from: independent of its velocities.
struct SlipGeometry {
  std::vector<LoadedRow> rows;
  double approach = 0.0;
  /// Matrix from velocities to creepages; transposed, from creep forces to force and moment at the
  /// point of the velocities: tractions act along the surface.
  CreepagesByTwist creepages_by_twist{};
};

} // namespace wrc
