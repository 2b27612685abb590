/// Constants of behaviour of this room used by several of its files.
///
/// Each with its origin, as `scripts/list_constants.sh` prints them.
#pragma once

namespace wrc {

/// To which contact points are found along a profile, least distances agree, and tables of heights
/// follow their curve, mm.
/// origin: derived: ten times the rounding of positions of 500 mm, 1e-13.
inline constexpr double position_tolerance = 1e-12;

} // namespace wrc
