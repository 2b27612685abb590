/// Constants of behaviour of this room: patches of penetration, their planes and the first depth.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Limits of the separation D (contact_patches.hpp) of lobes in one plane: joined below the
/// first, independent above the second.
/// origin: reasoned: joined later, narrow valleys need two grids for one contact; joined earlier,
/// one grid holds mostly gap.
inline constexpr double joined_below = 0.1;

/// origin: reasoned: see joined_below.
inline constexpr double apart_above = 0.5;

/// The same for lobes whose planes differ by other_plane_angle or more: joined only where there
/// is hardly a valley (rough profiles have many), independent once they are apart.
/// origin: reasoned: one plane is wrong for both there.
inline constexpr double steep_joined_below = -0.9;

/// origin: reasoned: see steep_joined_below.
inline constexpr double steep_apart_above = 0.0;

/// From the one angle to the other the limits move, rad.
/// origin: derived: tilting two lobes by half the lesser angle changes distances by 1 - cos = 0.5
/// %, by half the greater one by 1 %.
inline constexpr double same_plane_angle = 0.2;

/// origin: derived: see same_plane_angle.
inline constexpr double other_plane_angle = 0.3;

/// Penetration below this fraction of the deepest is outside contact.
/// origin: published: the virtual penetration is 0.55 of the approach (Kik & Piotrowski, 1996).
inline constexpr double outside_contact_share = 0.45;

/// Fraction of the approach by which the bodies overlap, 0.55 (Piotrowski & Kik, Vehicle System
/// Dynamics 46, 2008).
/// origin: derived: the rest is outside contact.
inline constexpr double virtual_penetration_share = 1.0 - outside_contact_share;

/// By how much a top between two nodes may exceed the penetration of both, mm.
/// origin: derived: half a millimetre of a circle of 1 mm radius sags by less.
inline constexpr double max_top_excess = 0.05;

/// How much yaw may change the curvature along the rail from that in rolling direction.
/// origin: bound: grids are at most ten times the length that they have without yaw.
inline constexpr double max_turn = 100.0;

/// Narrower contacts are treated as lines of this axis ratio by the first estimate of the depth.
/// origin: bound: K(e) diverges by its logarithm only.
inline constexpr double min_axis_ratio = 1e-4;

/// The depth to a load is a start for coarse solutions. One per cent would be near enough, but
/// where the search ends would show in forces.
/// origin: measured (smoothness): with a load found to 1e-4, forces jump by 2e-6.
inline constexpr double estimated_depth_accuracy = 1e-6;

/// Product of the last two relative errors of the load below which a secant step ends the search.
/// origin: measured (wrc_benchmark --case service): such a step leaves 0.04 of it.
inline constexpr double settled_excesses = 1e-4;

/// Power of the depth with which a load grows, at the start of that search, ...
/// origin: published: Hertz, 1882.
inline constexpr double load_power = 1.5;

/// ... and the smallest that is derived from two depths.
/// origin: derived: that of bodies in line contact (Johnson, 1985, 5.6), except for a logarithm.
inline constexpr double min_load_power = 1.0;

/// Depths below, mm, are not searched.
/// origin: derived: the least normal number is 2e-308.
inline constexpr double min_searched_depth = 1e-300;

/// Steps of that search.
/// origin: bound: ends a search that rounding keeps from its root.
inline constexpr int depth_iterations = 400;

/// Depth beyond which profiles no longer say what meets what, mm.
/// origin: bound: about twice the height of a flange.
inline constexpr double max_depth = 50.0;

/// Room around a patch's penetration, as a fraction of it: the scan finds its ends by cubics
/// between nodes only.
/// origin: reasoned: the ends are off by less than a per cent of it; the rest keeps contact off
/// the edge.
inline constexpr double penetration_margin = 0.05;

/// The width that every potential contact area has, over its length.
/// origin: bound: less than an element; penetration at a single point of the scan has none.
inline constexpr double least_width_over_length = 1e-3;

/// Largest slope at either end of a cubic, over its mean slope.
/// origin: published (F. N. Fritsch, R. E. Carlson, SIAM Journal on Numerical Analysis 17, 1980):
/// no monotone cubic has more.
inline constexpr double steepest_monotone = 4.0;

/// Last relative step of Newton's method to a level on a cubic, ...
/// origin: derived: rounding.
inline constexpr double way_down_tolerance = 1e-14;

/// ... and the most steps. origin: bound: of halving an interval, to rounding.
inline constexpr int most_way_down_steps = 60;

} // namespace wrc
