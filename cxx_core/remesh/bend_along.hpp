/// How little the gap of a contact is a parabola along the rail.
///
/// Under a round wheel on a rail that does not vary each row of the gap is a parabola, and
/// pressures along it are those of an ellipse. At the ends of a flat or on a nose they have crests,
/// and slopes at the edge, that elements counted for an ellipse do not resolve. The measure is the
/// difference of the penetration from that of a round wheel on a prismatic rail, less the best
/// parabola in each row, root mean square over the penetration, weighted with it, over the deepest.
/// It is continuous in the distances, and 0 where nothing varies.
///
/// Units mm. Thread rule: a pure function.
#pragma once

#include <span>

#include "base/grid.hpp"

namespace wrc {

/// 0 to 1, which is reached at `whole_bend`. `distance`: undeformed, of the grid's elements, and
/// `plain`: that of the round wheel on the prismatic rail; without penetration 0.
double bend_along(const Grid& grid, std::span<const double> distance,
                  std::span<const double> plain);

} // namespace wrc
