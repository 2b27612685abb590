/// Values of keys that wheels on rails do not have, so that their units are likely to be others.
///
/// Each with its origin. Thread rule: constants.
#pragma once

namespace wrc {

/// Load of a wheel, N, below which it is warned of unless it is 0.
/// origin: reasoned: an empty wagon's wheel carries 20 kN, and 80 means kN.
constexpr double least_load = 1000.0;
/// Speed of standstill, mm/s, and its share of a speed of at least that, above which it is warned
/// of. origin: reasoned: creepages become smaller by 0.5 %, and 100 in m/s means 100 mm/s.
constexpr double greatest_standstill_speed = 1000.0;
constexpr double greatest_standstill_share = 0.1;
/// Inclination of rails, rad, above which it is warned of.
/// origin: reasoned: rails are laid at 1:20 to 1:40, and 0.1 is the cant of a track of 150 mm.
constexpr double steepest_inclination = 1.0 / 15.0;

} // namespace wrc
