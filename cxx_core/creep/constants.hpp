/// Constants of behaviour of this room: creep forces of the patches of a wheel.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

namespace wrc {

/// An element of unlike bodies counts as this number towards solve.element_limit.
/// origin: bound: measured (bounded_scenes posed, seed 5, scene 887): the alternations between
/// pressures and tractions take 3.8 s on 98,000 elements, like bodies at most 1.2 s.
inline constexpr double cost_of_unlike_bodies = 4.0;

/// Likewise one whose tractions are found at several pitch rates, where the pitch is free.
/// origin: bound: measured (bounded_scenes loaded, seed 2002, scene 25740): the search takes 3.7 s
/// on 100,000 elements.
inline constexpr double cost_of_free_pitch = 3.0;

/// Error of creep forces over mu N on a grid of one element along the contact, falling with the
/// square of their number, those by pressures included.
/// origin: measured (wrc_tradeoff --creep 1500): bounds 96.1 to 99.8 % of errors at accuracies from
/// 1e-1 to 1e-3, and is 2.8 to 3.1 times the error in the median from 1e-2 on.
inline constexpr double creep_error_of_one_column = 0.85;

/// Creep forces of a contact that an end of a body cuts are as accurate as its place, but no
/// coarser than this. origin: bound: the coarsest that solve.accuracy permits.
inline constexpr double coarsest_of_cut = 0.1;

/// Fraction of the accuracy that the error of elements by that law may take.
/// origin: measured (wrc_tradeoff --creep 1500): 99.1 % of 3023 patches or more meet accuracies
/// from 1e-1 to 1e-3; with 0.66, for 5 % less time, 98.8 % at 1e-3.
inline constexpr double share_of_creep_columns = 0.6;

/// The fewest elements along a contact.
/// origin: measured (60 ellipses): errors reach 7 % of mu N there.
inline constexpr double min_creep_columns = 8.0;

/// The largest number of elements along a contact; twice this number across.
/// origin: bound: of memory, about 200 MB; the error by the law is 1e-5 of mu N.
inline constexpr double max_creep_columns = 400.0;

/// Elements across for each along, over an elliptic contact as long as wide.
/// origin: measured (wrc_tradeoff --creep 1500): with 1.1 accuracies of 3e-3 and 1e-3 are met on
/// 99.1 and 99.0 % of patches, with 1.17 on 99.2 and 99.1 %.
inline constexpr double creep_rows_by_columns = 1.17;

/// Elements along a contact whose gap bends along the rail, for each one where it is a parabola.
/// origin: measured (20 wheels on flats and 20 on a crossing, 1e-2): with 1, 1.2, 1.5 and 1.8
/// errors of 4, 4, 1 and 1 of 40 exceed their estimate.
inline constexpr double bent_creep_columns = 1.5;

/// The fewest elements across an elliptic contact.
/// origin: derived: half of min_creep_columns for a contact of equal length and width.
inline constexpr double min_creep_rows = 0.5 * min_creep_columns * creep_rows_by_columns;

/// Fraction of the accuracy, relative to friction's largest moment about the axle, to which a free
/// pitch rate balances the torque. Forces of unlike bodies change by steps as their alternations
/// end: their torque is balanced to creep_iteration_share, the size of these steps.
/// origin: reasoned: a fortieth of creep_iteration_share, by which forces of like bodies may err.
inline constexpr double free_pitch_tolerance = 0.01;

/// Below this friction tractions are computed with more friction and in proportion more creepage.
/// origin: bound: far below any that shows beside normal forces; squares of its tractions, and
/// of slips over them, are numbers for all moduli and loads.
inline constexpr double least_friction = 1e-30;

/// Friction that does not drive an axle: its pitch rate is that of rolling.
/// origin: bound: pressures, which have no moment about the axle of a round wheel, are off by 1e-7
/// of their force times its radius.
inline constexpr double no_driving_friction = 1e-6;

/// Evaluations of the torque after which the next one is where the wheels slide. With that and
/// those below, a pitch rate takes 40 at most. origin: bound: steps grow fourfold, from a start
/// that is right within a creepage of 1e-3.
inline constexpr int outward_evaluations = 11;

/// Largest number of evaluations of the torque after two pitch rates bracket the solution.
/// origin: bound: ten settle what is smooth, halving by these leaves 4e-9 of the bracket.
/// Between unlike bodies the alternation's own tolerance may exceed that of the torque: 90 once
/// took 28 s.
inline constexpr int pitch_evaluations = 28;

/// Step of differences by creepages of the cheaper models, in creepages at which the contact
/// slides. origin: reasoned: errors of truncation 1e-4, of rounding 1e-11.
inline constexpr double creep_difference_step = 1e-2;

/// Least friction that sets the steps of differences for the linear law, which has none itself.
/// origin: bound: steps are then above the rounding of any creepage permitted.
inline constexpr double least_linear_friction = 1e-2;

/// Change of pressures, in the largest of them, by which they are differentiated.
/// origin: reasoned: elements under pressure keep it, all but some at the edge.
inline constexpr double creep_pressure_step = 1e-4;

/// Tolerance of the tangential iteration, in accuracies, ...
/// origin: measured (400 steps of 0.1 um at 18 positions of three pairs of profiles, 1e-3): forces
/// leave their line by 2.1 % of the accuracy in the median and 22 % at most; with 0.2, for 14 %
/// more time, by 1.7 and 19 %: elements that enter the contact show.
inline constexpr double creep_iteration_share = 0.4;

/// ... of steps of time, whose forces change fast with velocities, ...
/// origin: measured (wheelset at rest, pushed to 0.6, 0.8 and 0.9 of friction, accuracies 0.1 and
/// 0.03): an implicit integrator iterates up to 11 and 7 times a step, with 0.4 up to 15 and 10, in
/// the same time.
inline constexpr double step_iteration_share = 0.04;

/// ... and error of forces for each unit of its residual.
/// origin: measured: as creep_iteration_share.
inline constexpr double creep_error_by_residual = 0.3;

/// How much larger the error that planes leave in creep forces is than that of the pressures.
/// origin: measured (wrc_tradeoff --truth 1000): 1.3 % of creep forces on wheels and 3.5 % on flats
/// exceed their estimate at 1e-3 with 1, 1.0 and 1.0 % with 1.2, whose estimates exceed the
/// accuracy on 7.0 instead of 4.7 % of the wheels; summed with the others, 14.7 %.
inline constexpr double creep_error_of_plane = 1.2;

/// How much larger errors are than the load that pressures between elements have elsewhere than the
/// solution (pressure/moved_load.hpp).
/// origin: measured (wrc_tradeoff --truth 1000): 2.5 % of creep forces on flats exceed their
/// estimate at 1e-2 with 1, 2.0 % with 1.25.
inline constexpr double error_by_moved_load = 1.25;

/// Creepages, and the spin times the radius, above which they are warned of; those of a motion only
/// from slow_speed on.
/// origin: reasoned: flanges have 0.06 and 1, and 1 means one per mille, 0.1 that in 1/m.
inline constexpr double greatest_creepage = 0.2;
inline constexpr double greatest_spin = 3.0;

/// Elements each way, at least.
/// origin: derived: grids of creep forces have even numbers of elements.
inline constexpr double fewest_creep_elements = 2.0;

} // namespace wrc
