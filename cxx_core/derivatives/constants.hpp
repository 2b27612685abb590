/// Constants of behaviour of this room: derivatives by the wheelset's motion.
///
/// Each with its origin: published (with author) or derived, bound, measured (with what measures
/// it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

namespace wrc {

/// Of the linear solutions of sensitivities.
/// origin: measured: what the rates neglect is more (wheel_sensitivities.hpp).
inline constexpr double sensitivity_tolerance = 1e-4;

} // namespace wrc
