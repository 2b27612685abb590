/// Elements of the tangential problem of a patch.
///
/// As many along the contact as the law error = c/n^2 asks for (constants.hpp), fewer across; of
/// lobes side by side each has as many across. They are counted along the longest lines of the
/// contact, so that one that lies askew in its rectangle has as many. Units mm. Thread rule: pure
/// functions.
#pragma once

#include "base/grid.hpp"
#include "pressure/smooth_pressure.hpp"

namespace wrc {

/// The grid over the rectangle around the contact; that of the pressures without contact.
struct CreepGrid {
  Grid grid;
  double columns = 0.0; ///< n of the law: elements along a contact as long as wide
};
CreepGrid grid_around_contact(const Grid& of_pressures, const SmoothPressure& pressure,
                              double accuracy, int lobes);

/// A grid with as many elements over the rectangle around another contact of the same plane.
Grid moved_around_contact(const Grid& grid, const SmoothPressure& pressure);

/// A grid with as many elements more on each side as reach the outer grid's edges, half its own at
/// most: where contact of unlike bodies may move to.
Grid extended_to(const Grid& inner, const Grid& outer);

} // namespace wrc
