/// Which lobe of a contact the pressures of each row belong to.
///
/// Forces of rows, across the rail, with a crest for each lobe: the rows' quadratic B-spline has
/// its crests and valleys at places that move without jumps when the forces change. A row belongs
/// to the lobe on whose side of the valley its basis function lies. Where a valley becomes shallow,
/// lobes pass their forces to each other: with depths d below either crest, over it, that run from
/// 0 at `one_lobe_depth` to 1 at `own_lobe_depth` (smoothstep, s for the lobe itself and s' for the
/// other), a lobe gives the other (1 - s) s'/(s + s' - s s') of its force. So one that is born or
/// merges has no force then, and shares are continuous in the forces, except in two cases: crests
/// of equal height that merge, and three lobes both of whose valleys are shallow, when two join.
/// Thread rule: a pure function.
#pragma once

#include <span>
#include <vector>

namespace wrc {

/// For each lobe, in the order of the rows, the share of each row, which add up to 1. `rows`:
/// forces, none below 0. Empty without a force.
std::vector<std::vector<double>> lobe_shares(std::span<const double> rows);

} // namespace wrc
