/// Constants of behaviour of this room: surfaces of rails and wheels, and where they touch.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all. Lengths in mm.
#pragma once

#include <array>
#include <cstddef>

#include "profile/constants.hpp"

namespace wrc {

/// To which contact points are found along a profile, least distances agree, and tables of heights
/// follow their curve, mm.
/// origin: derived: ten times the rounding of positions of 500 mm, 1e-13.
inline constexpr double position_tolerance = 1e-12;

/// Steps of Newton's method on one ray.
/// origin: bound: free_newton_steps suffice on smooth profiles, halvings beyond a kink.
inline constexpr int max_newton_steps = 50;

/// To which single rays are traced, mm.
/// origin: derived: a tenth of a thousandth of the smallest approach of interest, 1e-8 mm.
inline constexpr double ray_tolerance = 1e-12;

/// At a step of a profile, as the rounding of a standard's coefficients leaves it, Newton's method
/// finds no root: a point this near, mm, is accepted.
/// origin: derived: above max_junction_gap, the largest step that a profile may have.
inline constexpr double step_tolerance = 2.0 * max_junction_gap;

/// Longest step of Newton's method over a surface, mm: at first along a ray, and along a row of
/// bodies that vary.
/// origin: reasoned: less than the shortest arc of a standard profile, and than the distance of two
/// minima along a row.
inline constexpr double longest_newton_step = 4.0;

/// At a kink or a step Newton's method may alternate: after this many steps it closes in.
/// origin: bound: ends a cycle; on smooth profiles the method has ended before.
inline constexpr int free_newton_steps = 10;

/// Slope along the track, and around wheels, up to which contact is searched: on a slope e it is r
/// e ahead of the axle. origin: reasoned: ramps of noses and flats of wheels have slopes below 1:5.
inline constexpr double steepest_along = 0.2;

/// Depth to which a wheel sinks, mm.
/// origin: reasoned: under 80 kN.
inline constexpr double typical_depth = 0.1;

/// Depth to which a wheel sinks under any load, mm.
/// origin: measured: the wheel of Table 1 sinks by 0.31 mm under 700 kN (wrc_case --json
/// --set load.left=7e5 --set solve.side=left, left.depth), ten times its load.
inline constexpr double greatest_depth = 3.0 * typical_depth;

/// A surface seen from the ray at a flatter angle than this (its cosine) no longer faces it.
/// origin: bound: 1 degree.
inline constexpr double min_facing_cosine = 0.02;

// Swings of a surface between its slices (along_check.cpp).

/// Lines across a sheet on which heights are compared.
/// origin: reasoned: every 2 to 4 mm of a head or tread; swings are wider than that.
inline constexpr std::size_t swing_lines = 24;

/// Distance of the two places that give a line's slope across, mm.
/// origin: reasoned: well below the node distance of curves, far above the rounding of heights.
inline constexpr double swing_slope_distance = 0.2 * max_node_distance;

/// Sections steeper than this across are left out.
/// origin: reasoned: contact angles beyond 63 degrees are those of a flange face.
inline constexpr double steepest_swing_section = 2.0;

/// Swings and steep rises beyond this have a warning, mm.
/// origin: measured: slices of smooth shapes swing by up to 0.0065 mm (the shipped crossing; waves
/// of 0.1 mm over 20 slices by 0.0001 mm), those about steps and sharp flats by 0.014 mm or more.
inline constexpr double notable_swing = 0.01;

/// Places nearer to 0 than this share of a rise are 0 in messages.
/// origin: bound: rounding.
inline constexpr double swing_place_rounding = 1e-9;

/// Points of a profile that are no farther apart count as one, mm. A contact so near to the end of
/// a profile is at its end. origin: derived: a thousandth of the narrowest element, far above
/// position_tolerance.
inline constexpr double same_place = 1e-6;

// Contact of profiles that do not vary (contact_search.cpp).

/// How far a node of the scan can lie above the minimum next to it, mm.
/// origin: derived: s^2 / (2 R) = 0.008 with nodes 0.5 mm apart, so s <= 0.25 mm, and relative
/// curvatures 1 / R up to 1 / (4 mm).
inline constexpr double scan_slack = 0.01;

/// Samples along a ridge under yaw, at least, ...
/// origin: reasoned: distances are a cubic there, as between any two samples.
inline constexpr int least_ridge_samples = 8;

/// ... and how far apart they are across the rail at most when the least distance is searched, mm.
/// origin: reasoned: the rail's head has radii from 13 mm; only with a yaw of 0.1 rad or more and
/// large wheels does a ridge reach farther than this in each of its samples.
inline constexpr double ridge_sample_spacing = 1.0;

// Curves as graphs and their tables of heights (curve_graph.cpp, height_function.cpp).

/// Smallest d lateral / d arc that still counts as a graph: the cosine of 89.4 degrees. Below it
/// the side of a section is vertical. origin: reasoned: no contact carries on so steep a flank.
/// Rounding of the lateral coordinate moves a height by less than a hundredfold, and the table of
/// heights stays small (max_height_halvings is for slopes up to 100).
inline constexpr double min_tangent_lateral = 0.01;

/// Steps of Newton's method from a place across to one on the curve.
/// origin: bound: within a piece Newton's method takes 3 to 5 steps; the limit ends a cycle.
inline constexpr int graph_newton_limit = 30;

/// Halvings of a piece of 0.5 mm at most; the last is used as it is.
/// origin: bound: the error falls by 2^6 a halving, and slopes up to 100 stretch pieces so much.
inline constexpr int max_height_halvings = 12;

// Tip, tread and chamfer of a wheel (first_touch.cpp).

/// What lies so close below the largest radius is the flange tip, mm.
/// origin: published: qR is measured from 2 mm below the tip (EN 13715).
inline constexpr double flange_tip_height = 2.0;

/// So far above the tread a flange tip is at least, mm, and so far beside it the tread is.
/// origin: published: flanges of trams are 20 mm high or more; the taping line is 55 mm from the
/// tip (EN 13715).
inline constexpr double least_flange_height = 15.0;
inline constexpr double tread_from_flange_tip = 60.0;

/// Slope of a chamfer at least, falling to the field side.
/// origin: published: treads have slopes up to 1:6.7, chamfers of 1:1 (EN 13715).
inline constexpr double least_chamfer_slope = 0.3;

// Lines that meet rails (rail_line.cpp), axes and gauge faces of rails (rail_surface.cpp).

/// Searches for the point over which an inclined rail's highest point lies.
/// origin: bound: the height changes the lateral place by the sine of the inclination alone.
inline constexpr int inclined_top_steps = 3;

/// Steps along an edge of a sheet, after which a line passes beside it.
/// origin: bound: lines that meet the edge itself turn back at once; the limit ends the others.
inline constexpr int sheet_edge_steps = 4;

/// Distance of the axis of a body without gauge face from the place of a gauge face, mm.
/// origin: published: running circles are 1500 mm apart, on a gauge of 1435 mm (EN 15302).
inline constexpr double axis_from_gauge_face = 32.5;

/// A gauge face falls at least by this slope.
/// origin: published: gauge corners turn to 87 degrees (EN 13674-1); a crown turns by 19 degrees.
inline constexpr double least_gauge_face_slope = 1.0;

// Surfaces through slices (sliced_sheets.cpp, sliced_surface.cpp, surface_sheet.cpp).

/// Parts of an interval along, between two knots, after which sections are compared.
/// origin: reasoned: a cubic has at most two extremes in between, which are found to a tenth of
/// their height.
inline constexpr int interval_parts = 4;

/// Smoothing length of a list that asks for smoothing without a length, in distances of slices.
/// origin: reasoned: slices do not resolve waves of two distances, and hardly those of three.
inline constexpr double smoothed_slice_distances = 4.0;

/// By which another part may be nearer to a wheel than this one, mm.
/// origin: bound: of flanges, 26 to 36 mm (EN 13715), worn ones included.
inline constexpr double highest_flange = 40.0;

// Contact of bodies that vary (varying_search.cpp).

/// Greatest distance of rows, mm: the node distance of profile curves.
inline constexpr double row_spacing = max_node_distance;

/// The coarse scan takes rows up to this far apart, and places along them, mm.
/// origin: reasoned: slices of noses and flats are that far apart.
inline constexpr double coarse_row_spacing = 2.0;
inline constexpr double coarse_row_step = 5.0;

/// Newton's method along a ray of the scan ends with a step shorter than this, mm.
/// origin: bound: the next step is a hundredth of that where profiles change by a tenth of its
/// length; minima that the scan shows are found again.
inline constexpr double scan_step = 1.0;

/// Chains are followed up to this height above the least distance, mm.
/// origin: reasoned: sixteen times greatest_depth, to which wheels sink under any load. The
/// neighbourhood is not flat: with this and near_chain_height 30 % larger forces of two of 40
/// random scenes with bodies that vary move by 0.5 and 2 % (scene_bits varying 40 19).
inline constexpr double chain_height = 50.0 * typical_depth;

/// Rows that may be in contact, above the least distance, mm.
/// origin: reasoned: twice greatest_depth, to which wheels sink under any load; see chain_height.
inline constexpr double near_chain_height = 2.0 * greatest_depth;

/// Slope that stands for that beside a least distance without curvature.
/// origin: bound: above rounding.
inline constexpr double least_valley_slope = 1e-14;

/// Below this half length the parabola is that of the least distance itself, mm.
/// origin: derived: distances of 1e-7 mm, with six digits.
inline constexpr double least_valley_half = 1e-2;

/// Longest half length of that parabola, mm.
/// origin: bound: half of the longest flats.
inline constexpr double longest_valley_half = 60.0;

/// Curvature of the flattest such parabola.
/// origin: derived: from both.
inline constexpr double least_valley_curvature =
    2.0 * typical_depth / (longest_valley_half * longest_valley_half);

/// Steps of one search along a row.
/// origin: bound: Newton's method takes a few; the limit ends a cycle.
inline constexpr int most_row_steps = 60;

/// Halvings of the way from row to row where the least distance moves far along the rail: under
/// yaw, beside flanges, by 12 mm in 0.4 mm.
/// origin: bound: 0.03 mm.
inline constexpr int most_row_halvings = 4;

/// To which least distances along a row are found, mm.
/// origin: derived: distances are then right to 1e-19 mm, their derivatives to 1e-11.
inline constexpr double row_tolerance = 1e-9;

/// Two chains closer than this on a row are one, mm.
/// origin: reasoned: far above the tolerance, far below the step of the scan.
inline constexpr double same_chain = 1e-3;

// Surfaces of wheels (wheel_surface.cpp).

/// Change of slope above which a node is a ridge.
/// origin: reasoned: with a radius of 500 mm and a yaw of 0.1 rad the locus jumps by 0.05 mm along
/// the rail there, less than any element.
inline constexpr double ridge_turn = 1e-3;

/// Slope of the steepest flank that touches a rail.
/// origin: bound: 80 degrees, where flanges of standards have 70.
inline constexpr double steepest_flank = 6.0;

/// Height above first touch at which a wheel is out of reach, mm.
/// origin: bound: ten times the greatest depth.
inline constexpr double wheel_out_of_reach = 10.0 * greatest_depth;

// Roll of a wheelset (wheelset_equilibrium.cpp).

/// The search for the roll continues until the two least distances agree to position_tolerance, and
/// accepts negligible_length where rounding allows no better. Where bodies vary they agree to this,
/// mm.
/// origin: derived: lines meet surfaces to ray_tolerance, a hundredth of this.
inline constexpr double varying_roll_tolerance = 1e-10;

/// Global searches for the roll.
/// origin: bound: every roll_halving_period-th search halves the bracket of 0.4 rad: 4e-7 rad are
/// left after 100 at the worst.
inline constexpr int max_roll_searches = 100;

/// Difference of least distances at which Newton's method on the contacts followed ends, mm.
/// origin: derived: a fifth of position_tolerance, so that the global search confirms it.
inline constexpr double followed_contact_tolerance = 0.2 * position_tolerance;

/// Steps of that method.
/// origin: bound: quadratic convergence takes 3 to 5 steps; more only where contacts change.
inline constexpr int followed_contact_steps = 12;

/// After this number of global searches the bracket is halved, whatever Newton's method says.
/// origin: bound: ends searches in which Newton's method alternates; usually one or two do.
inline constexpr int roll_halving_period = 5;

} // namespace wrc
