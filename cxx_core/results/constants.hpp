/// Constants of behaviour of this room: from the solution of a wheel to its result.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// A point is on the tip of the flange if the wheel falls by this much more steeply between it and
/// the taping line, rad.
/// origin: reasoned: flanks fall by 1 rad and more, crests of tips by less.
inline constexpr double tip_fall = 0.2;

/// Pressure that no steel of wheels and rails carries, MPa: 440 kgf/mm2. A material flows all round
/// a contact when the mean pressure is its hardness, about three times its yield stress (Johnson,
/// Contact Mechanics, 6.3).
/// origin: published: 440 HBW, the upper end of the hardest grade, R400HT (EN 13674-1); wheels are
/// softer, 320 HBW at most (EN 13262).
inline constexpr double hardest_steel = 440.0 * 9.80665;
/// Combined modulus above which bodies are no steel, MPa.
/// origin: derived: of two steels of 230 GPa and 0.3; steels have 190 to 220 GPa.
inline constexpr double stiffest_steel = 0.5 * 230e3 / (1.0 - 0.3 * 0.3);
/// Pressure that no stiffer body carries, MPa.
/// origin: derived: silicon nitride of the hardest balls, 16 GPa after Vickers (ISO 26602), flows
/// under a largest pressure of 1.6 times its yield stress, a third of that: 9 GPa.
inline constexpr double hardest_ceramic = 1e4;

/// Error of depth and place of a contact that the end of a body cuts, for an element across the end
/// of the length of the contact's semi-axis.
/// origin: measured (wing_rail and cross+wing among CONTACT's examples, 10 and 80 kN, -4 to 4 mm
/// from their ends, accuracies from 1e-2 to 1e-3 against 3e-4): depth errs by up to 0.20, place,
/// over the semi-axis, by up to 0.38.
inline constexpr double error_of_cut = 0.4;
/// Error of the elements beyond which the largest pressure is not given.
/// origin: measured (bounded_scenes, 2600 wheels with 1400 above 10 GPa): where it grows by 10 %
/// and more on ten times as many elements the estimate is 0.58 or more, mostly 2.5; where it stays
/// it is below 0.35.
inline constexpr double unresolved_peak = 0.5;

/// Growth of the largest pressure at a kink of a profile with twice the elements, over itself,
/// beyond which it is not given.
/// origin: reasoned: steel's elements twice as narrow add 8.2 GPa and more on the edges of built-in
/// chamfers (0.66 and 0.72 rad), 0.5 GPa on LMA's kink at s = 30 mm (0.042 rad), which carries 2 to
/// 6 GPa; a result that changes by a tenth with them is the grid's.
inline constexpr double unbounded_growth = 0.1;
/// Error estimate, over the accuracy, up to which results are only a little less accurate than
/// requested.
/// origin: reasoned: most errors are well below their estimate (docs/accuracy.md).
inline constexpr double usable_excess = 2.0;

/// Largest slope of a wheel's tread towards the field side, rad; anything steeper is its chamfer.
/// origin: published: treads of EN 13715 fall by up to 15 % (0.149 rad), their chamfers by 45
/// degrees.
inline constexpr double max_tread_slope = 0.2;

/// Elements of the common grid of a contact of several patches, in those of all parts.
/// origin: bound: of memory where small parts lie far apart.
inline constexpr std::size_t max_elements_ratio = 16;

/// Points along a section of stresses, and its depths below. About the number in CONTACT's own
/// examples: the size of a picture, not a tuning constant.
inline constexpr std::size_t section_places = 100;
inline constexpr std::size_t section_depths = 60;
/// ... its half length over the contact's semi-axis, and its depth over the smaller one.
/// origin: derived: stresses have their maximum above 0.8 of it (Johnson 1985, 4.2), and fall below
/// a third of it at 2.
inline constexpr double section_half_length = 1.5;
inline constexpr double section_depth = 2.0;

} // namespace wrc
