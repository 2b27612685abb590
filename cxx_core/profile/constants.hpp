/// Constants of behaviour of this room: curves through points and segments, slices.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all. Lengths in mm.
#pragma once

#include <array>
#include <cstddef>

namespace wrc {

/// Steps smaller than this are left, mm.
/// origin: derived: on elements of 0.05 mm of steel they cause E* step / (2 * 0.05 mm) = 1 MPa.
inline constexpr double min_step = 1e-6;
/// Length over which each side of a step is moved, mm; whole pieces.
/// origin: derived: half of S1002's step of 1.2e-4 mm then changes the curvature by no more than
/// 6 * 6e-5 mm / (2 mm)^2 = 1e-4 / mm.
inline constexpr double transition_length = 2.0;

/// Lengths that count as none, mm: between points that are one, between sections that are equal, of
/// shifts.
/// origin: derived: ten thousand roundings of positions, 1e-13 mm, below the last digit of files,
/// 1e-4, and a hundredth of the approach under the least loads. Results change by up to themselves
/// in a millimetre, so by less than a thousandth of the finest accuracy, 1e-6.
inline constexpr double negligible_length = 1e-9;

/// Largest distance between nodes, mm, so that a scan over them meets every local minimum of a gap.
/// origin: reasoned: below the narrowest contact strip of worn flanges, about 1 mm; scan_slack
/// of geometry/constants.hpp follows from it.
inline constexpr double max_node_distance = 0.5;
/// Largest gap between neighbouring segments, mm.
/// origin: reasoned: standards print coordinates to 1e-3 mm.
inline constexpr double max_junction_gap = 1e-3;

/// Largest angle of a piece of an arc, rad.
/// origin: derived: R (h/R)^6 / 46080 stays below 1e-11 mm up to R = 29 mm, and beyond that
/// max_node_distance is the tighter bound.
inline constexpr double max_piece_angle = 0.05;
/// Accuracy of pieces, mm, and of their curvature, relative to the largest.
/// origin: reasoned: an interpolated polynomial cannot be distinguished from the standard's, and
/// gaps are exact to 1e-11 mm.
inline constexpr double piece_tolerance = 1e-11;
inline constexpr double piece_curvature_tolerance = 1e-8;
/// Rounding of a curvature, 1/mm, which a straight piece shows too.
/// origin: derived: rounding of positions, 1e-13 mm, over the square of a piece of 0.1 mm.
inline constexpr double curvature_rounding = 1e-11;
/// Refinement ends here with an error.
/// origin: bound: 40 times the pieces of a profile of 250 mm at 0.5 mm.
inline constexpr std::size_t max_pieces = 20000;

/// How often the knots follow the arc length of the spline through them.
/// origin: reasoned: each pass squares the deviation of the parameter from the arc length.
inline constexpr int reparametrisations = 2;
/// Length along the spline per length of its parameter, which is close to 1 for a smooth line;
/// below this the points turn back on themselves and the tangent is lost.
/// origin: bound: any value well below 1 and above rounding.
inline constexpr double min_speed = 0.01;
/// Length of a curve in lengths of the chords of its points.
/// origin: reasoned: curves through sensible points exceed their chords by a few per cent at most;
/// those that swing do so by orders of magnitude.
inline constexpr double max_detour = 2.0;

/// An interval longer than this many times its neighbour is halved.
/// origin: reasoned: uneven slices of a measurement, at most two to one, keep their spline; halves
/// of a halved interval are no longer than twice the next.
inline constexpr double most_growth = 2.5;
/// Bound of input (not a tuning constant).
inline constexpr std::size_t max_knots = 20000;

/// Share of the shorter of two slices that the other must reach beyond its end.
/// origin: measured: of the 147 pairs of a British crossing 140 reach up to 0.025 beyond each
/// other, which is its rails' variation, and 7 reach 0.08 to 1.24, where parts begin or end or the
/// slices are cut at other places.
inline constexpr double least_excess = 0.05;
/// A line this near to an end of a slice, over the length of the shorter slice, is the end's, and
/// lengths this near to each other are equal.
/// origin: reasoned: much less than least_excess, so that no line is near to both ends of a common
/// stretch; 0.5 mm of a rail's 100 mm. A rise that is taken for ends makes lengths differ by
/// least_excess or more.
inline constexpr double same_line = 0.1 * least_excess;

/// Depth of the groove between a guard rail and the head of its rail, and least height of the guard
/// rail above that head, mm.
/// origin: published: flanges, which pass through grooves, are 20 mm high or more (EN 13715).
inline constexpr double least_groove = 20.0;
/// origin: reasoned: guard rails stand 20 to 60 mm above the head, blades of switches a few;
/// what is between would do as well.
inline constexpr double least_guard_height = 8.0;

/// Longest smoothing length, in distances of the closest places.
/// origin: derived: the terms of the matrix then differ by (1000 / 2 pi)^4 = 6e8, which leaves
/// seven digits.
inline constexpr double longest_along_smoothing = 1000.0;

/// Wavelengths that are halved to see what depends on them, mm; 0: the points as they are.
/// origin: reasoned: waves of 2 to 8 mm are as likely noise that an instrument has filtered;
/// halving 3 mm keeps, and halving 15 mm removes them.
inline constexpr std::array smoothed_waves{0.0, 3.0, 5.0, 8.0, 15.0};

} // namespace wrc
