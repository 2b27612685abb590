/// How much load pressures between the elements have elsewhere than the solution.
///
/// Where a gap bends along the rail (remesh/bend_along.hpp) the pressures of a solution do not show
/// how they end, and what is put between them (smooth_pressure.hpp) bears other loads than the
/// elements did. Creep forces follow from where the load is along the rolling direction: what one
/// column has too much is missing in others, so half of the sum of the differences has moved. A
/// load at the distance x from the middle has a moment of x/c times itself times c, the root of the
/// product of the semi-axes: a load beyond c counts with this factor.
///
/// Units are the caller's. Thread rule: a pure function. Not known here: how wrong the solution's
/// own pressures are.
#pragma once

#include <span>

#include "pressure/smooth_pressure.hpp"

namespace wrc {

/// Fraction of the load of `pressure`, which `smooth` goes between. `middle`: of it along the grid;
/// `mean_axis`: c.
double moved_load(const Grid& grid, std::span<const double> pressure, const SmoothPressure& smooth,
                  double middle, double mean_axis);

} // namespace wrc
