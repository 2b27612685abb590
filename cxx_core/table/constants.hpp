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

/// Largest ln(a/b) of the creep law's nodes, to both sides.
/// origin: reasoned: 12 to 1, beyond which wheels are on no rail that is new.
inline constexpr double largest_law_log_ratio = 2.5;

/// Accuracy of Kalker's coefficients in the nodes, and of the solutions that the table is compared
/// with. origin: reasoned: a tenth of the error that the splines have in creep forces.
inline constexpr double table_creep_accuracy = 1e-2;

/// Slope of first touch, height over lateral position, that tells where the flange begins.
/// origin: measured (trial of tables of S1002 on 60E1): halfway up the jump from 0.4 to 2.7.
inline constexpr double flange_slope = 0.9;

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

/// How far above first touch, in depths at the largest load, the exact solution is still asked.
/// origin: reasoned: several times the error of the spline of first touch.
inline constexpr double lift_margin = 0.1;

/// Load below which errors are still over this fraction of the largest load.
/// origin: reasoned: a wheel's load in a train, where the largest is twice that.
inline constexpr double least_load_share = 0.5;

/// Fraction of the states that may err by more than the error returned with them, as the factor of
/// the map is set.
/// origin: reasoned: a quarter of the share that the documentation promises.
inline constexpr double calibrated_share = 5e-4;

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

// Files of tables and of unfinished ones (table_file.cpp, finished_tasks.cpp).

/// Bytes of a file and of a name in it, and nodes of one variable.
/// origin: bound: of memory.
inline constexpr std::size_t largest_table_file = std::size_t{1} << 31U;
inline constexpr std::size_t longest_table_name = 4096;
inline constexpr std::size_t most_table_nodes = 1U << 16U;

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
