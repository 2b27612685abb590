/// How well the pressures of a wheel solve its contact problem.
///
/// Units: fractions of the largest displacement and of the load (mechanics/normal_contact.hpp).
/// Thread rule: a pure function.
#pragma once

#include "records/wheel_result.hpp"

namespace wrc {

/// KKT residuals of a side's patches in double precision, the worst of each kind, by separate
/// convolutions. Displacements of patches by each other count as in the solution, also in the
/// displacement that gaps are relative to, except for other nodes (patch_coupling.hpp), which shows
/// where they interact.
Residuals residuals_of(const WheelResult& side);

} // namespace wrc
