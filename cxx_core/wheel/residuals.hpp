/// How well the pressures of a wheel solve its contact problem.
///
/// Units: shares of the largest displacement and of the load (mechanics/normal_contact.hpp). Thread
/// rule: a pure function.
#pragma once

#include "records/wheel_result.hpp"

namespace wrc {

/// KKT residuals of a side's patches in double precision, the worst of each kind, by convolutions
/// of their own. What patches displace at each other counts as in the solution, also
/// in the displacement that gaps are relative to, but for other nodes (patch_coupling.hpp), which
/// shows where they interact.
Residuals residuals_of(const WheelResult& side);

} // namespace wrc
