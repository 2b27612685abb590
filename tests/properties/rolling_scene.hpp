/// Scenes with creep forces, half of them by motion: loaded ones as of drawn_scene.hpp, and posed
/// ones, whose position is prescribed, with roll, far off the centre, deep, on large wheels and
/// under much yaw, to the ends of what keys permit.
#pragma once

#include <cstdint>

#include "drawn_scene.hpp"

namespace properties {

/// The same seed draws the same scene.
DrawnScene rolling_loaded_scene(std::uint64_t seed);
DrawnScene rolling_posed_scene(std::uint64_t seed);

} // namespace properties
