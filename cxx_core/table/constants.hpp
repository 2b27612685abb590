/// Constants of behaviour of this room: tables of contact forces.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <chrono>
#include <cstddef>

namespace wrc {

/// Accuracy of normal contact in the table's nodes, and tolerance of the tangential iteration in
/// the creep law's. origin: reasoned: a tenth of the error that the splines themselves have.
inline constexpr double node_accuracy = 1e-3;

/// Largest linear force of spin over mu N that is solved for the creep law, in place of spin
/// without end. origin: reasoned: tractions are off by a hundredth where the slip turns, in a
/// hundredth of it.
inline constexpr double largest_spin_node = 100.0;

/// Scales of the creep law's slip and spin, k and q of creep_law.hpp: below and above 1 nodes come
/// together at rest.
/// origin: measured (trial of 400 random ellipses): 95 % of slopes at small slip and spin err by
/// less than 0.019, instead of 0.066 with 17 x 17 x 13 x 7 nodes and scales of 1; with 0.4 and 3 it
/// is 0.014, but 0.060 of forces at large spin instead of 0.008.
inline constexpr double law_slip_scale = 0.7;
inline constexpr double law_spin_scale = 1.5;

/// Largest ln(a/b) of the creep law's nodes, to both sides.
/// origin: reasoned: 12 to 1, beyond which wheels are on no rail that is new.
inline constexpr double largest_law_log_ratio = 2.5;

/// Accuracy of Kalker's coefficients in the nodes, and of the solutions that the table is compared
/// with. origin: reasoned: a tenth of the error that the splines have in creep forces.
inline constexpr double table_creep_accuracy = 1e-2;

/// Slope of first touch, height over lateral position, that tells where the flange begins.
/// origin: measured (trial of tables of S1002 on 60E1): halfway up the jump from 0.4 to 2.7.
inline constexpr double flange_slope = 0.9;

/// Contact angle beyond which normal force counts as that of the flange's lobe, rad.
/// origin: reasoned: 26 degrees, between those of treads (below 0.2) and of flanges (above 1).
inline constexpr double flange_lobe_angle = 0.45;

/// Distances before that place, mm, between which the table begins to follow it.
/// origin: measured (likewise): the worst error of Fy falls from 0.42 to 0.027 of the load.
inline constexpr double alignment_begins = 4.0;
inline constexpr double alignment_ends = 1.0;

/// Least yaw, in the largest, at which what vanishes without yaw is taken over it.
/// origin: reasoned: rounding of contact forces is 1e-5 of them there.
inline constexpr double least_yaw_node = 0.05;

/// Friction below which a table has no creep forces.
/// origin: bound: far below any that shows beside normal forces; linear forces over it are numbers
/// for all velocities permitted.
inline constexpr double least_table_friction = 1e-9;

/// Part of each range, before its end, over which the exact solution takes over.
/// origin: reasoned: as a cell of the map of errors is of the lateral range.
inline constexpr double border_share = 0.05;

/// How far below first touch the table goes on, in depths at the largest load.
/// origin: reasoned: 1.84 times the largest load, where a flange strikes its rail; errors are
/// measured up to there.
inline constexpr double largest_depth = 1.5;

/// How far above first touch, in depths at the largest load, the exact solution is still asked.
/// origin: reasoned: several times the error of the spline of first touch.
inline constexpr double lift_margin = 0.1;

/// Load below which errors are still over this fraction of the largest load.
/// origin: reasoned: a wheel's load in a train, where the largest is twice that.
inline constexpr double least_load_share = 0.5;

/// Fraction of the states around a corner of the map that may err by more than its likely error;
/// and of the states that may err by more than the bound and than the likely error, as the factors
/// of the map are set. origin: reasoned: as the name says; and a tenth and a half of the fractions
/// that the documentation promises, since no vehicle draws its states as these are.
inline constexpr double likely_share = 0.01;
inline constexpr double calibrated_share = 1e-4;
inline constexpr double calibrated_likely_share = 0.005;

/// Friction at which the map has errors of forces; what normal forces err by, as if it were that of
/// creep forces at a friction; and friction below which errors are no smaller.
/// origin: measured (compare_table, a coach on S1002 in sharp curves): 0.1 to 2 % of the wheels are
/// beyond the likely error at frictions of 0.1 to 1, and 13 % at 0.05.
inline constexpr double friction_of_errors = 0.3;
inline constexpr double friction_without_errors = 0.15;
inline constexpr double least_friction_of_errors = 0.2;

/// Frictional work over the distance, N, below which errors are still over this.
/// origin: reasoned: wear below it is that of a trailer on straight track, and harms nothing.
inline constexpr double least_wear_number = 1.0;

/// Friction at which slopes of creep forces are those of sticking contact.
/// origin: bound: the largest friction of a step.
inline constexpr double sticking_friction = 10.0;

/// Friction of the random states that measure errors.
/// origin: bound: that of dry rails.
inline constexpr double least_drawn_friction = 0.1;
inline constexpr double largest_drawn_friction = 0.6;

/// Error of a state without an answer.
/// origin: bound: far beyond any other.
inline constexpr double error_without_answer = 1e3;

/// Memory of a table's spline of contact, bytes.
/// origin: bound: table_file.cpp reads no larger files.
inline constexpr double largest_spline = 1e9;

/// Cells of the map of errors over a lateral distance, 1/mm.
/// origin: measured (trial of 76800 states of S1002 on 60E1): errors rise from 0.03 to 0.3 of the
/// load over 0.1 mm where the contact goes over from the flange's root to the flange.
inline constexpr double cells_per_length = 32.0;

/// Speed of random states and of those that slopes are fitted to, mm/s.
/// origin: reasoned: that of a train; forces do not depend on it far above standstill.
inline constexpr double drawn_speed = 2e4;

/// Accuracy of the solutions that slopes are fitted to.
/// origin: reasoned: that of a step whose derivatives decide on stability (docs/coach.md).
inline constexpr double fit_accuracy = 1e-3;

/// Lateral positions to both sides that slopes are fitted at, their distance, and the distance
/// beyond them over which offsets fall to 0, mm.
/// origin: reasoned: where a centred wheelset oscillates before its flanges touch; and measured
/// (trial of S1002 on 60E1): offsets change over half a mm.
inline constexpr double fit_reach = 3.0;
inline constexpr double fit_step = 0.1;
inline constexpr double fit_fall = 1.0;

/// Largest factor, beside 1, of linear forces that is taken for a correction.
/// origin: measured (trial of S1002 on 60E1): on the tread they are 0.95 to 1.05.
inline constexpr double largest_correction = 0.2;

/// Lateral distance to both sides over which noise is taken out of linear creep forces, mm, and
/// the misfit, over the force, up to which it counts as noise.
/// origin: measured (trial of S1002 on 60E1 at the centre): neighbours 0.05 mm apart differ by
/// 0.01, and the slope of the lateral force by 290 of 700 N/mm; and reasoned: five times that.
inline constexpr double smoothing_reach = 0.25;
inline constexpr double smoothed_noise = 0.05;
/// What the misfit of the arm from which rolling radii follow is over, mm.
/// origin: measured (likewise): it is noisy by 0.001 mm on the tread, by the noise above over this.
inline constexpr double smoothed_arm = 0.4;
/// What that of the longitudinal force by spin is over, in lateral forces by spin.
/// origin: reasoned: an ellipse has no such force, so up to a fifth of the lateral one is noise.
inline constexpr double smoothed_cross = 4.0;

/// Lateral force of the spin over friction times load below which the fit leaves it as it is.
/// origin: reasoned: accuracy of the solutions is a tenth of that; less has no factor but noise.
inline constexpr double least_spin_force = 0.01;

// Files of tables and of unfinished ones (table_file.cpp, finished_tasks.cpp).

/// Bytes of a file and of a name in it, and nodes of one variable.
/// origin: bound: of memory.
inline constexpr std::size_t largest_table_file = std::size_t{1} << 31U;
inline constexpr std::size_t longest_table_name = 4096;
inline constexpr std::size_t most_table_nodes = 1U << 16U;

/// Iterations, and halvings of a step, of an equilibrium by a table; and the share of the loads
/// that it may miss. origin: bound: from a start near by Newton's method takes three; and rounding
/// of a table's numbers in single precision.
inline constexpr int most_table_iterations = 30;
inline constexpr double load_share_met = 1e-7;

/// The start of an equilibrium: steps of differences, mm and rad; the largest changes of height and
/// roll at once; and the depth, over that of the largest load, at which it is near enough.
/// origin: bound: far above rounding and far below contact's size; wheels stay within their
/// profiles; and Newton's method on forces goes on from there.
inline constexpr double depth_step = 1e-4;
inline constexpr double roll_step = 1e-7;
inline constexpr double largest_height_change = 5.0;
inline constexpr double largest_roll_change = 0.01;
inline constexpr double depth_met = 1e-3;

/// Vertices of a map of errors, each of some ten numbers.
/// origin: bound: of memory.
inline constexpr std::size_t largest_map_of_errors = std::size_t{1} << 22U;

/// Letters of the format of another version's file that a message quotes.
/// origin: bound: of the message.
inline constexpr std::size_t longest_table_format = 20;

/// Bytes of a file of unfinished tasks.
/// origin: bound: twice the largest file of a table, whose numbers are in single precision.
inline constexpr std::size_t largest_unfinished_file = std::size_t{1} << 32U;

/// Between two writes of unfinished tasks.
/// origin: bound: what a stopped build loses at most; a file of 26 MB takes 0.05 s.
inline constexpr std::chrono::seconds least_time_between_writes{20};

/// Speed of the wheelset in the nodes of a table, mm/s.
/// origin: bound: the geometry of slip does not depend on it.
inline constexpr double speed_of_nodes = 1e4;

} // namespace wrc
