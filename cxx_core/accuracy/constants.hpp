/// Constants of behaviour of this room: elements for a requested accuracy, and the error of a
/// solution.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>
#include <numbers>

#include "patches/constants.hpp"

namespace wrc {

/// Elements over the penetration of solutions that find the depth of a load; an odd number, so that
/// a narrow contact in the middle is met.
/// origin: measured (instructions of a run over irregular track): 17 x 8, 13 x 6 and 11 x 6 take 8,
/// 0 and -2 % more at 1e-2, and 3, 7 and 10 % at 1e-3, where wheels that slide need more solutions.
inline constexpr std::size_t coarse_rows = 13;

/// Error of a depth on a contact of n rows: this over n^2, ...
/// origin: measured (wrc_tradeoff): together they bound 97.2 of 100 errors or more at accuracies
/// from 1e-1 to 3e-4, and are 2.1 to 3.0 times the error in the median.
inline constexpr double error_by_squares = 0.2231;

/// ... and this over n^4.
/// origin: measured: see error_by_squares.
inline constexpr double error_by_fourth_powers = 12.125;

/// Part of the midpoint rule's error at the edges of contact (pressure/edge_rows.hpp) that
/// solutions leave in the place of the forces, on many rows; on few more, as by the law.
/// origin: measured (wrc_tradeoff --truth 1000): 3.1 and 1.6 % of the moments of 1000 wheels exceed
/// their estimate at 1e-2 and 1e-3 without it, 2.1 and 0.9 % with 0.25, 1.9 and 0.7 % with 0.3, 1.6
/// and 0.5 % with 0.34. Of estimates at 1e-3 1.5, 2.8 and 4.3 % then exceed the accuracy that did
/// not. Halves of the wheels: 1.2 and 2.6 % at 1e-2, 0.4 and 1.0 % at 1e-3.
inline constexpr double error_by_edges = 0.3;

/// Error of a force where a profile has a kink inside the contact, over the angle times the width
/// of a row over the overlap: an eighth of that is what a turn leaves of the distances in its row.
/// origin: measured (wrc_tradeoff --random 6000 --accuracy-of forces): 247 of 12000 wheels have
/// such turns. Their errors at 1e-2, 1e-3 and 3e-4 are bounded in 96, 94 and 96 %, without it in
/// 83, 75 and 78 %, and one of their missed accuracies comes without a warning instead of 18, 22
/// and 28. Twice as much bounds 98, 95 and 97 %.
inline constexpr double error_by_ridge = 0.03;

/// Fraction of the accuracy that the error of elements by that law may take.
/// origin: measured (wrc_tradeoff): 99.5 of 100 wheels or more meet accuracies from 1e-1 to 3e-4;
/// of 1600 random ones (--random 800) 6 to 10 miss 3e-3 to 3e-4, with 5 % more 6 to 12, with 5 %
/// less, for 9 % more time, 5 to 9.
inline constexpr double share_of_law = 0.5335;

/// Where less is requested, contacts are solved as for this accuracy.
/// origin: measured (wrc_tradeoff): elements for 3e-2 and 1e-1 would save a tenth of the time, and
/// the law overestimates errors on seven rows by 3.5 and bounds 92 of 100 on eight.
inline constexpr double coarsest_accuracy = 1e-2;

/// Columns over a contact for each row; more, to an even number.
/// origin: measured (wrc_tradeoff): with share_of_law.
inline constexpr double columns_by_rows = 0.64;

/// Columns where the gap bends along the rail, for each one where it is a parabola. There contacts
/// that are shorter than wide do not take fewer for creep forces: with fewer 12 instead of 7.5 % of
/// 200 wheels on flats miss 1e-2.
/// origin: measured (20 wheels on flats and 20 on a crossing, creep forces at 1e-2): of 40, 5, 3
/// and 2 miss the accuracy with 1.6, 2 and 2.4, of which 2.4 takes a fifth more elements; with 1 14
/// do.
inline constexpr double bent_columns = 2.0;

/// Least error that an estimate states, in accuracies: that of a place which the elements of creep
/// forces, more than the law needs, do not lessen.
/// origin: measured (wrc_tradeoff --truth 1000): moments of wheels with creep forces and on flats
/// are off by up to 0.2 of 1e-2. 2.7 and 2.0 % of these exceed their estimate without it, 1.0 % of
/// both with it, and no more estimates exceed the accuracy.
inline constexpr double least_error = 0.2;

/// Columns of solutions that find the depth.
/// origin: derived: columns_by_rows of coarse_rows, rounded down.
inline constexpr auto coarse_columns =
    static_cast<std::size_t>(columns_by_rows * static_cast<double>(coarse_rows));

/// How much larger errors are by the law with the position prescribed: a force goes with the power
/// 1.5 of the depth (Hertz), but its error is not always the largest.
/// origin: measured (wrc_tradeoff --position): estimates bound 98.2 of 100 errors or more, with 1.2
/// 96.7; with 1.3 they are 3.0 to 3.2 times the error at 1e-2.
inline constexpr double position_error_factor = 1.25;

/// Rows of pressures that creep forces are computed from: their square times the accuracy.
/// origin: measured (wrc_tradeoff --creep 500, 1e-2, sizes by the scale): with 2 it is met on 99.0
/// % of patches, with 3 on 99.7 %, with 5 on 99.8 %.
inline constexpr double creep_row_law = 3.0;

/// The same for columns over a contact as long as wide.
/// origin: measured (wrc_tradeoff --creep 500, 1e-3): with 0.6 and 0.7 it is met on 99.1 % of
/// patches, with 0.8 and 1.3 on 99.3 %, which take 7 and 36 % more elements.
inline constexpr double creep_column_law = 0.7;

/// The power of length over width by which these columns grow, and those of tractions.
/// origin: measured (wrc_tradeoff --creep 1500): where contact is more than five times as long as
/// wide the rms error at 1e-3 is 0.66 of it, with 0.35, for 12 % less time on all of a run, 0.90;
/// without it errors reach 6 times the accuracy.
inline constexpr double columns_by_sides_exponent = 0.5;

/// How much better pressures must be that stresses are computed from.
/// origin: measured (compare_stress 100 7): 96 to 100 of 100 wheels meet 1e-1 to 1e-3 below the
/// surface.
inline constexpr double stress_accuracy_factor = 3.0;

/// How much worse elements of constant pressure are.
/// origin: measured (wrc_tradeoff --elements constant).
inline constexpr double constant_elements_error = 3.0;

/// Variance of the pressures in a row about their middle, in g/k of its virtual penetration
/// (expected_contact.hpp).
/// origin: derived: under Hertz's pressures on a paraboloid it is a fifth of the squared semi-axis,
/// 0.2 g/k on a depth of which the virtual penetration is 0.55; weighted, g is 7/8 of the deepest.
inline constexpr double variance_of_penetration = 0.2 / (virtual_penetration_share * 0.875);

/// Rows over the penetration that a crest takes at most.
/// origin: bound: of work; at a kink no number of rows resolves it.
inline constexpr double max_crest_rows = 160.0;

/// Length of the strips of a section, in lengths of the contact there: they displace their middle
/// as a semi-elliptic pressure over the contact does.
/// origin: derived: 2/e, since the integral of (sqrt(1 - t^2) - 1)/t from 0 to 1 is ln 2 - 1.
inline constexpr double strip_length_share = 2.0 / std::numbers::e;

/// Error of a crest, in second differences at its top: of the strips across, and of the columns
/// along as far as they exceed a semi-ellipse's.
/// origin: measured (wrc_tradeoff --practical 1500): together with the law of resolution.hpp it is
/// exceeded by 2 of 3000 errors of pmax at 1e-2, and each miss has a warning; with 0.06 and 0.08
/// (of 6000) by 17 and 14, and two misses have none. From 0.06 to 0.1 second grids take 1.3 % more
/// solutions.
inline constexpr double error_by_second_difference = 0.1;

/// Error of a maximum, as a fraction of its unresolved part (peak_section.cpp).
/// origin: measured (crests of five wheels): a halving of strips far wider than a crest adds 0.5 to
/// 1 times as much, others less.
inline constexpr double error_by_unresolved = 0.5;

/// Unresolved part of a top below which strips are not divided, relative.
/// origin: reasoned: below the error of any other kind at the finest accuracies.
inline constexpr double least_unresolved = 1e-4;

/// Strips on each side of an unresolved top that are divided. On the inner half of them all
/// pressure is solved for again. origin: measured (crests of five wheels at 1e-2 and 1e-3): with 8
/// they are off by up to 0.5 %, with 12 by 0.6 %, at 1e-3 by 0.18 and 0.08 %.
inline constexpr std::size_t window_reach = 12;

/// How often they are divided, at most.
/// origin: bound: strips are then shorter by 256, some tenths of a micrometre.
inline constexpr int most_refinements = 4;

/// Strips of a section for each row, at least.
/// origin: measured (600 wheels, 99 %): 8 make errors of pmax a tenth smaller, 1 is no section at
/// all.
inline constexpr double strips_per_row = 4.0;

/// Number of strips into which one strip next to an unresolved maximum is divided.
inline constexpr auto strip_refinement = static_cast<std::size_t>(strips_per_row);

/// Strips over the rows under pressure, at least.
/// origin: measured (wrc_tradeoff --random 6000): at 1e-2, where pressures have a bound, pmax is
/// off by 4.3 instead of 18 accuracies at worst, by more than 2 on 2 instead of 8 of 12000 wheels.
/// 96 take a tenth more time at 1e-2.
inline constexpr double min_strips = 64.0;

/// Error of the force of a contact in a plane, over its vertical load and the square of the cosine
/// of the plane's angle: the third power of the surface's standard deviation from the plane's
/// direction, and this times the square of its mean.
/// origin: measured (34 scenes against curved patches, tread to flange): errors are 0.1 to 1.1
/// times as large.
inline constexpr double force_error_by_mean = 0.4;

/// Error of the depth of a contact in a plane, and of its moments over force and semi-axis, over
/// the square of the surface's turn.
/// origin: measured (docs/evidence/curved.md, planes alone): 0.03 bounds 97 % of the
/// depths and 98.5 % of the moments of 200 wheels.
inline constexpr double depth_error_by_turn = 0.03;

/// Likewise over the square of the angle of a kink inside the contact.
/// origin: derived: the standard deviation of the surface's inclination is that of an evenly
/// turning one with sqrt(5) times the turn (Hertz). Of 25 random scenes with kinks of 0.042 to 0.72
/// rad planes differ from curves by up to 0.12 in the depth, and by up to 0.11 of the square in the
/// moments of 23.
inline constexpr double depth_error_by_kink = 5.0 * depth_error_by_turn;

/// Error of the largest pressure in a plane, over the square of the surface's turn.
/// origin: measured (docs/evidence/curved.md, planes alone): 0.07 bounds all of 200 wheels except
/// three at gauge corners; 0.011 is the median.
inline constexpr double pressure_error_by_turn = 0.07;

/// Of rows along a curve: error of the depth over the square of their turn, ...
/// origin: published (CONTACT's example of a conformal contact, with coefficients by finite
/// elements): the force at its position is 3 % larger over 1.4 rad, two thirds of it the depth's.
inline constexpr double depth_error_on_curve = 0.01;

/// ... and of the largest pressure.
/// origin: published: see depth_error_on_curve; 4 % larger.
inline constexpr double pressure_error_on_curve = 0.02;

/// Fraction of the accuracy at which the error of a plane begins to bend it towards the curve.
/// origin: reasoned: the rest of the accuracy is that of elements; a wide stretch keeps results
/// smooth.
inline constexpr double curve_begins = 0.5;

/// Elements of a wheel's grids of normal contact together, and of its grids of creep forces, that
/// solve.element_limit permits at most if it is not set.
/// origin: bound: 100,000 take up to 1.2 s and 150 MB; accuracies finer than 2.6e-4 reach it.
inline constexpr double default_element_limit = 100000.0;

/// Where fewer are permitted: this over the root of the accuracy, 16,000 at 1e-2 and 51,000 at
/// 1e-3. A scene costs in proportion to its elements: a limit far above what a usual one needs lets
/// the worst take a hundred times as long.
/// origin: bound: measured (bounded_scenes loaded): of 519 random wheelsets with creep forces, worn
/// and rough profiles among them, 1e-3 takes 5,900 in the median, 26,000 in 99 % and 46,000 at
/// most, 3e-4 takes 16,000 and 86,000.
inline constexpr double elements_by_root = 1600.0;

} // namespace wrc
