/// States of a wheel that a vehicle simulation must know, and pressures that no steel carries.
///
/// Lifted: no contact. On the flange tip: a patch lies beyond the steepest point of the flange,
/// where nothing stops a climbing wheel (Nadal 1896). On the chamfer: a patch lies beyond the
/// tread. Beyond yield: the largest pressure is more than the softer of the two steels carries
/// without yielding (half_space/steel.hpp). At the end of a part: the
/// first touch is where a part of a rail that varies begins or ends, or such an end cuts a patch
/// (cut_contact.hpp). Units mm, MPa. Thread rule: pure functions.
///
/// Not known here: how the wheel came there.
#pragma once

#include <optional>

#include "records/wheel_result.hpp"

namespace wrc {

/// Values of the flags in wheel_state; those of the C interface.
enum WheelState : int {
  lifted = 1,
  on_flange_tip = 2,
  on_chamfer = 4,
  beyond_yield = 8,
  at_part_end = 32
};

/// The flags together; none if the mechanics have not run.
std::optional<int> wheel_state(const WheelResult& wheel);

/// Warns of a largest pressure that no steel of wheels and rails carries; of stiffer bodies, of one
/// that no ceramic does.
void warn_of_pressure(WheelResult& wheel);

} // namespace wrc
