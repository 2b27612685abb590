/// Whether wheel and rail first touch where wheels are not meant to run: on the flange tip or on a
/// chamfer. A wheel whose taping line is elsewhere than its file says does so.
///
/// The tip is all within 2 mm of the largest radius of a flange, as qR is measured (EN 13715). A
/// chamfer falls off to the field side more steeply than treads do, beyond the taping line.
/// Units mm. Thread rule: pure function.
#pragma once

#include <optional>

#include "base/warning.hpp"
#include "geometry/contact_search.hpp"

namespace wrc {

/// A warning with the position; none if the touch is on tread, root or flank.
std::optional<Warning> warning_of_touch(const WheelSurface& wheel, const ContactCandidate& touch);

} // namespace wrc
