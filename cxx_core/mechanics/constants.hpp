/// Constants of behaviour of this room: the normal contact solvers.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// No side of a coarser grid of a cascade is shorter.
/// origin: reasoned: a contact that fills two thirds of it still has five elements across.
inline constexpr std::size_t min_level_side = 8;

/// Longest side of the coarsest grid.
/// origin: reasoned: such a grid costs next to nothing beside the finest, and still holds the
/// contact.
inline constexpr std::size_t max_coarsest_side = 32;

/// Longest side of a grid on which an iteration begins with given pressures; they come from a few
/// elements, and longer grids take them from coarser ones.
/// origin: measured (instructions of a run over irregular track): with 32 normal contact takes 9 %
/// more at 1e-3, without a limit creep forces 4 % more, and 256 x 128 elements half as much again.
inline constexpr std::size_t max_started_side = 64;

/// Fraction of elements below the distance that the first pressures start from.
/// origin: reasoned: contact fills a third to two thirds of a potential contact area; too small a
/// first contact grows faster than one too large shrinks.
inline constexpr double start_quantile = 0.3;

/// Error of p at which a coarser grid of the cascade is left.
/// origin: reasoned: refining adds about as much.
inline constexpr double coarse_level_tolerance = 1e-2;

/// Elements around the pressures that the iteration starts with, and around contact found
/// outside.
/// origin: reasoned: the edge moves by one element from grid to grid, and reaching a side costs
/// the iteration.
inline constexpr std::size_t box_margin = 2;

/// By which part of the box a side that contact has reached moves outwards, one element more.
/// origin: reasoned: a box too small by half is large enough after three steps.
inline constexpr std::size_t box_growth_divisor = 4;

/// Fraction of the tolerance that max|z| may reach when the iteration stops: the free step leaves
/// an error of 0.1 to 0.6 of max|z|, in flat punches and very narrow contacts up to 1.9 (at loose
/// tolerances).
/// origin: measured (tests/core/mechanics/normal_solver_tolerance_test.cpp): less than 1 is
/// needed.
inline constexpr double stop_share = 0.75;

/// Error that interpolation may have in the displacements of patches by each other: a fraction of
/// the tolerance, but no less than the second.
/// origin: reasoned: small beside the tolerance; nodes cost more than they bring below the
/// second.
inline constexpr double coupling_share = 0.03;

/// origin: reasoned: small beside what patches in planes of their own leave out.
inline constexpr double min_coupling_error = 1e-5;

/// Overlap outside the box that counts as contact left out, as a fraction of the approach, in
/// single precision.
/// origin: derived: eight roundings of single precision; a displacement is a sum of products.
inline constexpr double missed_overlap = 5e-7;

/// The same in double precision, where the tolerance asks for less.
/// origin: derived: some hundred roundings of double precision.
inline constexpr double double_overlap = 1e-13;

/// Largest number of pressures whose displacements are removed one by one, ...
/// origin: bound: of a buffer on the stack.
inline constexpr std::size_t max_single_cuts = 128;

/// ... and elements of the box per such pressure.
/// origin: measured (60 scenes of wrc_tradeoff on 256 x 128 elements): with none one by one 8 %
/// more time; on 40 x 20 the same.
inline constexpr double elements_per_cut = 16.0;

/// Rounding in u stands for an error of p relative to the largest p of about this much times
/// N^1.15, N elements along the longer side: the ratio of the operator's extreme eigenvalues
/// grows with it.
/// origin: measured with directions in single precision: 8.9e-6 for 78 elements, 2.6e-5 for 156,
/// 6.1e-5 for 306, 1.4e-4 for 614, 2.9e-4 for 1228.
inline constexpr double single_drift = 8.5e-8;

/// origin: derived: the same with the rounding of double precision, two units.
inline constexpr double double_drift = 2e-16;

/// origin: measured: see single_drift.
inline constexpr double drift_exponent = 1.15;

/// Number of iterations of the projected CG, and of the stiffness, without a smaller error after
/// which they stop.
/// origin: bound: longer than any plateau of converging cases, about ten iterations; costs only
/// those that fail.
inline constexpr int stagnation_window = 60;

/// Fraction by which the pressures of one box may shrink or grow in an iteration of several boxes.
/// Where the least energy lies beyond, all go the same part of the way, which keeps the load; where
/// that would be less than the least part, a step of the same length in all boxes is taken.
/// origin: reasoned: no box is emptied or doubled by one step.
inline constexpr double max_joint_step_shrinking = 0.5;

/// origin: derived: a box that is doubled by one step is halved by the opposite one.
inline constexpr double max_joint_step_growth = 1.0 / (1.0 - max_joint_step_shrinking) - 1.0;

/// origin: measured (JointContactRandom.MeetsTheRequestedTolerance): without it and the limit of
/// growth one pressure ends off by 1.2.
inline constexpr double min_joint_step_part = 0.1;

/// Added to the diagonal of energies that are 1 there: a direction may be parallel to the
/// pressures to within single precision.
/// origin: derived: between the squared rounding of single precision, 4e-15, and what would
/// change a step by 1e-6.
inline constexpr double joint_step_ridge = 1e-9;

/// Polonsky & Keer: iterations without better pressures after which it stops.
/// origin: bound: longer than any plateau on noise and on two contacts; a floor costs this
/// many iterations.
inline constexpr int polonsky_keer_stagnation_window = 300;

/// Polonsky & Keer: pressures are off by 5 to 70 times the relative error of the gaps.
/// origin: measured: up to 154 elements across.
inline constexpr double pressure_error_per_gap_error = 70.0;

/// Steps of the strips' iteration.
/// origin: bound: it takes 5 to 30; the limit ends what does not converge.
inline constexpr int strip_step_limit = 200;

/// Steel that yields (yielding.cpp): part of the residual that conjugate gradients leave of a
/// step of Newton's method, ...
/// origin: reasoned: a step of the last length, that of the tolerance, then leaves a tenth of it.
inline constexpr double yield_step_tolerance = 0.1;
/// ... halvings of a step that would lead to more energy, steps, ...
/// origin: bound: a step takes one part or two; there are 3 to 10 steps.
inline constexpr int yield_halvings = 20;
inline constexpr int yield_rounds = 60;
/// ... and the part of the energy that rounding may add.
/// origin: derived: some thousand roundings of double precision.
inline constexpr double yield_energy_rounding = 1e-12;

/// Nodes of the interpolation in either direction.
/// origin: reasoned: with 16 the error stays below 1.5 times the requested one unless boxes are
/// nearly in touch (patch_coupling.hpp); fewer than 4 would not carry the moments of the loads.
inline constexpr std::size_t min_coupling_nodes = 4;
inline constexpr std::size_t max_coupling_nodes = 16;

} // namespace wrc
