/// Constants of behaviour of this room: root searches and elements.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

namespace wrc {

/// Mean of a smooth function over an element, less its value at the centre, in second differences.
/// origin: derived: that of a quadratic.
inline constexpr double mean_excess_over_element = 1.0 / 24.0;

// Searches for a root in a bracket (root_bracket.hpp).

/// A bisection at least every so often: with 8 a smooth root, which takes 5 to 9 steps, is hardly
/// held up.
/// origin: bound: it ends searches whose secants stall; with 4 to 16 no result changes by more than
/// the tolerance.
inline constexpr int bisection_period = 8;

/// Enough to bisect any interval of doubles of one sign down to rounding.
/// origin: bound: 8 times 53 bisections at most; 200 suffice with the secants between.
inline constexpr int max_bracket_steps = 200;

} // namespace wrc
