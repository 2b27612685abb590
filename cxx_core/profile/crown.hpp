/// The crown of a rail among the heights along its profile, from the gauge to the field side.
///
/// It is the highest place, unless that belongs to a guard rail: behind a groove on the field side
/// stands the head, far below it. Units mm. Thread rule: a pure function.
#pragma once

#include <cstddef>
#include <span>

namespace wrc {

/// Index of the crown; of one height at least.
std::size_t crown_among(std::span<const double> heights);

} // namespace wrc
