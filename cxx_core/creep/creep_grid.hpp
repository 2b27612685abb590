/// Elements of the tangential problem of a patch.
///
/// Along the contact their number follows from the law error = c/n^2 (constants.hpp), more
/// where it is long. Across there are more where the pressures have crests. Elements along are
/// counted over the longest lines of the contact, those across over its scale
/// (pressure/contact_scale.hpp), so that a contact askew in its rectangle has the same number.
///
/// The grid reaches from edge to edge, so that the longest lines begin and end between elements;
/// with elements of a size that follows from real numbers, so that nothing steps where a whole one
/// is reached, derivatives by positions were twice as far off. Units mm, MPa. Thread rule: pure
/// functions.
#pragma once

#include <span>

#include "base/grid.hpp"
#include "pressure/smooth_pressure.hpp"

namespace wrc {

/// Pressures of a patch, on the grid of its normal contact.
struct PatchPressures {
  const Grid& grid;
  std::span<const double> values;
  const SmoothPressure& smooth;
  double bend = 0.0; ///< Patch::bend
};

/// Around the contact; the grid of the pressures without contact.
struct CreepGrid {
  Grid grid;
  double columns = 1.0; ///< n of the law: elements along a contact as long as wide
  double wanted = 0.0;  ///< elements without the limit
  bool limited = false; ///< these are more
};
/// With more than `limit` elements, they are enlarged in both directions to meet it; at least two
/// each way.
CreepGrid creep_grid(const PatchPressures& pressures, double accuracy, double limit);

/// A grid with the same number of elements over the rectangle around another contact of the same
/// plane.
Grid moved_around_contact(const Grid& grid, const SmoothPressure& pressure);

/// A grid with more elements on each side, enough to reach the outer grid's edges, half its own at
/// most: where contact of unlike bodies may move to.
Grid extended_to(const Grid& inner, const Grid& outer);

} // namespace wrc
