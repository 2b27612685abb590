/// Constants of behaviour of this room: solutions of scenes, their steps and their spread by noise.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

// What the noise of profiles changes (noise_spread.cpp).

/// Deviations that hold the truth in 95 of 100 cases.
/// origin: published: Student's distribution with ten degrees of freedom (likely_lines).
inline constexpr double spread_deviations = 2.228;

/// Solutions that a spread is computed from, at least.
/// origin: reasoned: with seven degrees of freedom the deviations are 2.36, 6 % more; fewer are
/// those of the smoother lines only.
inline constexpr int least_spread_solutions = 7;

/// Accuracy of the solutions with likely curves.
/// origin: reasoned: a spread of 10 % is then known to a few per cent, as its number of lines knows
/// it to 22 %.
inline constexpr double likely_line_accuracy = 1e-2;

/// Spread over its result above which it is a little over, and beyond usable_excess of which the
/// result is not to be used.
/// origin: reasoned: points with a spread of 20 % do not say what a pressure is.
inline constexpr double usable_spread = 0.1;

/// Elements that all lines have together, if solve.element_limit is not set.
/// origin: derived: the most that one solution then has.
inline constexpr double usual_spread_elements = 1e5;

/// Elements that a line has in any case.
/// origin: bound: the least that solve.element_limit permits.
inline constexpr double least_line_elements = 1e3;

// Differences along a path and around wheels (solve_scene.cpp, vehicle_step.cpp).

/// How far behind a solution is compared, over the length of the contact.
/// origin: reasoned: the difference multiplies errors of solutions by 1.4, and a wave of two
/// contact lengths loses a tenth of its slope.
inline constexpr double path_step = 0.5;

/// Step of differences along the track and around the wheel, mm.
/// origin: reasoned: contacts change by less than their accuracy, rounding by a millionth of that.
inline constexpr double track_difference_step = 5e-3;

/// Permitted steps of time, s.
/// origin: bound: displacements over them are numbers; beyond, rolling is steady.
inline constexpr double least_time_step = 1e-9;
inline constexpr double most_time_step = 1e9;

// Position under a load and a moment (static_equilibrium.cpp).

/// Loads that a search meets are met within this share of the accuracy.
/// origin: reasoned: forces themselves are off by the accuracy; a hundredth of it does not show.
inline constexpr double load_share_of_accuracy = 0.01;

/// Solutions: that of the start, and those of Newton's method.
/// origin: bound: 4 to 8 are needed from tread to flange.
inline constexpr int most_static_solutions = 40;

/// Solutions in a row after which there is no such position, if none of them lessens the missing
/// load by this fraction. origin: bound: steps are then a thousandth of Newton's.
inline constexpr int most_vain_solutions = 10;
inline constexpr double least_static_progress = 0.05;

/// Distance of a wheel's contact from the wheelset's centre, mm, by which a moment is shared at the
/// start, and least share of a wheel there.
/// origin: bound: the start only.
inline constexpr double usual_contact_arm = 750.0;
inline constexpr double least_wheel_share = 0.02;

/// Largest load, N, as load.left permits.
/// origin: bound: a hundred times what wheels carry.
inline constexpr double largest_static_load = 1e7;

// Pressures that make a total load (total_load.cpp).

/// What may be left of a total.
/// origin: measured (TotalLoad.*): where iterations of creep forces take a step more or less,
/// totals jump by 1e-8 on treads and up to 4e-7 of themselves on flanges, whatever the accuracy;
/// secants leave 1e-7 and less.
inline constexpr double total_load_tolerance = 1e-6;

/// Number of solutions after which load_share_of_accuracy suffices, ...
/// origin: bound: twice the number needed if nothing jumps; where forces jump no load does better.
inline constexpr int usual_total_solutions = 12;

/// ... and of the last one, after which there is no load.
/// origin: bound: bisections of a jump down to the tolerance take 20 more.
inline constexpr int most_total_solutions = 40;

/// The largest load on the pressures, in totals.
/// origin: bound: full sliding down a flange of 75 degrees with friction 0.25 leaves a
/// fifteenth.
inline constexpr double largest_total_ratio = 32.0;

/// The largest factor between one load and the next.
/// origin: bound: a few solutions to the largest load; keeps the first secants in range.
inline constexpr double largest_load_growth = 4.0;

// Surfaces and tables of steps (surface_cache.hpp, table.cpp).

/// Shortest waves of a wheel that the search for contacts finds, mm.
/// origin: measured: waves of 9.6 mm are found, those of 8.3 mm are not all.
inline constexpr double shortest_wheel_wave = 12.0;

/// Studies compare many profiles; a surface of 600 points takes 0.4 MB, one of 5000 points 2.6, a
/// crossing 3.7. A scene has two of a kind. origin: bound: of memory, changes no result.
inline constexpr std::size_t most_cached_surfaces = 64;
inline constexpr std::size_t most_surfaces_of_scene = 2;

/// Cells and results of a table.
/// origin: bound: a table of 2 GB.
inline constexpr std::size_t most_table_values = std::size_t{1} << 28;

} // namespace wrc
