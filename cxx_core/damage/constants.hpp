/// Constants of behaviour of this room: stresses below the surface, wear and fatigue.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Distance, in sizes of an element, from which elements of that size suffice for a section: depth,
/// and distance of a row of elements from the section.
/// origin: measured (SubsurfaceStress.CoarserElementsSufficeAtDepth): stresses are off by 1e-3 of
/// the greatest pressure at most.
inline constexpr double depth_of_element = 3.0;

/// Distance of the depths at which a section is computed, over the depth: cubics give the rest.
/// origin: measured (SubsurfaceStress.CoarserElementsSufficeAtDepth): as depth_of_element.
inline constexpr double depth_spacing = 0.25;

/// Number of rows of elements above which larger elements pay far from a section.
/// origin: measured (100 x 60 points under 64 x 32 elements): a sixth of the time; with 20 rows it
/// takes longer.
inline constexpr std::size_t rows_worth_splitting = 24;

/// Number of points computed together.
/// origin: derived: single-precision values in a vector register of 64 bytes.
inline constexpr std::size_t vector_places = 16;

/// Smallest number of elements across the contact.
/// origin: derived: four moments in a row, up to the third, need four elements.
inline constexpr std::size_t coarsest_elements = 4;

/// The same for the search of the greatest stress, which is computed again at the point found.
/// origin: derived: half of depth_of_element; it only chooses between points.
inline constexpr double depth_of_search_element = 0.5 * depth_of_element;

/// Least depth, in element sizes.
/// origin: bound: the logarithms at the edges of elements are infinite on the surface itself.
inline constexpr double least_depth = 1e-6;

/// Elements across the contact in the search of the greatest stress, at least.
/// origin: measured (SubsurfaceStress.AgreesWithContact): with 4 tops on the surface are missed.
inline constexpr std::size_t search_elements = 5;

/// Largest number of points of the search along a side of the contact.
/// origin: bound: the field of a contact this slender varies slowly along it; the sums over all
/// elements at all points would take 3 s for 10 x 8400 elements (as
/// SubsurfaceStress.FindsTheStressBelowAVerySlenderContact at both orientations).
inline constexpr std::size_t most_search_places = 256;

/// Fraction of the greatest pressure that these elements must show; otherwise it is on a narrow
/// strip.
/// origin: measured (SubsurfaceStress.FindsTheStressBelowANarrowStrip); of a Hertzian pressure
/// they show 0.95.
inline constexpr double share_shown = 0.9;

/// Ratio of the depths at which the greatest stress is searched, ...
/// origin: reasoned: the field varies over its depth; three points of a parabola lie in a hump.
inline constexpr double search_depth_ratio = 2.0;
/// ... and the deepest of them over half the smaller width of the contact.
/// origin: derived: 0.70 b below line contact, 0.48 a below a circle (Johnson 1985, 4.2, 3.4).
inline constexpr double deepest_search = 1.1;

/// Depth, in elements of the search, below which the surface itself is searched.
/// origin: reasoned: values between are those of the elements.
inline constexpr double shallowest_search = 0.5;

/// Fraction of the greatest value above which the maximum at a depth is refined as well.
/// origin: measured (SubsurfaceStress.AgreesWithContact): with friction the field has tops of
/// nearly the same height near the surface and below, and coarse elements leave some percent.
inline constexpr double worth_climbing = 0.9;

/// Parabolas are laid through the greatest value in each direction as long as a round gains this
/// fraction, ...
/// origin: measured (compare_stress): one or two rounds as a rule; along ridges two leave 3e-3.
inline constexpr double least_gain = 3e-4;
/// ... in this number of rounds at most.
/// origin: bound: three times the usual number.
inline constexpr int search_rounds = 6;

/// Points on each side among which the maximum on the surface is searched again, on elements half
/// as large each time, along, ...
/// origin: derived: what a vector register holds, with the point itself.
inline constexpr std::size_t surface_reach_along = (vector_places - 1) / 2;
/// ... and across.
/// origin: reasoned: three quarters of a larger element to each side.
inline constexpr std::size_t surface_reach_across = 1;

/// Error of the greatest stress on the surface under tractions, by the root of elements over half
/// the smaller width of the contact: at its ends stresses have a cusp. Below it falls with the
/// square of the distance from the surface.
/// origin: measured (compare_stress, two samples): with half of it 90 of 100 errors on the surface
/// are bounded.
inline constexpr double near_surface_error = 0.15;

/// Fraction of the power that slip times traction must show on the grid to locate the dissipated
/// energy.
/// origin: bound: less is a remainder of the iteration, not slip.
inline constexpr double least_dissipated_share = 1e-3;

/// Density of steel, g/mm^3.
/// origin: published (Braghin et al., Wear 261, 2006, 4): turns mass into volume.
inline constexpr double steel_density = 7.85e-3;

/// USFD law, R8T wheel on 900A rail: T-gamma over the area in N/mm^2, rates in ug/(m mm^2).
/// origin: published (Lewis & Dwyer-Joyce 2004; Braghin et al., Wear 261, 2006, table 1): 5.3 e
/// to 10.4, 55.0 to 77.2, then 55.0 + 61.9 (e - 77.2), as it must be to be continuous: 61.9 e -
/// 4778.7, which is also printed, leaves the 55.0 out.
inline constexpr double usfd_mild_slope = 5.3;
inline constexpr double usfd_severe_energy = 10.4;
inline constexpr double usfd_severe_rate = 55.0;
inline constexpr double usfd_catastrophic_energy = 77.2;
inline constexpr double usfd_catastrophic_slope = 61.9;

/// Archard's k by sliding speed in mm/s and p/H.
/// origin: published (Jendel, Wear 253, 2002, fig. 3, from tests at KTH): 1 to 10, 30 to 40 and 300
/// to 400 times 1e-4; their middles.
inline constexpr double archard_mild = 5e-4;
inline constexpr double archard_severe = 35e-4;
inline constexpr double archard_seizure = 350e-4;
inline constexpr double severe_speed_first = 200.0;
inline constexpr double severe_speed_last = 700.0;
inline constexpr double seizure_pressure = 0.8;

/// Damage function of the whole life rail model: T-gamma in N, damage per wheel.
/// origin: published (Burstow, RSSB T355, 2004): 0 up to 15 N, 1e-5 at 65 N, 0 at 175 N, wear
/// beyond.
inline constexpr double rail_damage_first = 15.0;
inline constexpr double rail_damage_peak = 65.0;
inline constexpr double rail_damage_last = 175.0;
inline constexpr double rail_damage_greatest = 1e-5;

/// Steps of the scan of a line contact's stresses over x/a and z/a, and how far it goes to each
/// side and down. origin: measured (FatigueTest): a smooth field, whose limits are right to 2e-3.
inline constexpr double map_step = 0.025;
inline constexpr double map_reach = 1.5;
/// Greatest friction of the map.
/// origin: bound: beyond that of any rail.
inline constexpr double map_friction = 2.0;

/// Poisson's ratio of the map's elastic limit.
/// origin: published (Johnson 1985, 4.2): 0.3, for steel.
inline constexpr double map_poisson = 0.3;

} // namespace wrc
