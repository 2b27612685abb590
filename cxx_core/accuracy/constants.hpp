/// Constants of behaviour of this room: elements for a requested accuracy, and the error of a
/// solution.
///
/// Each with its origin: derived, source (with author), measured (with what measures it) or
/// reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>
#include <numbers>

namespace wrc {

/// Rows over the penetration for an accuracy of 1e-2, and the power by which they grow: the
/// fewest with which 99.5 of 100 wheels meet accuracies from 1e-1 to 3e-4.
/// origin: measured (wrc_tradeoff).
inline constexpr double rows_at_one_percent = 21.0;

/// origin: measured: see rows_at_one_percent.
inline constexpr double rows_exponent = 0.355;

/// Columns for each row.
/// origin: measured (wrc_tradeoff): with rows_at_one_percent.
inline constexpr double columns_by_rows = 0.45;

/// The fewest that still hold a patch.
/// origin: reasoned: five elements across the contact.
inline constexpr double min_rows = 10.0;

/// origin: reasoned: see min_rows.
inline constexpr double min_columns = 8.0;

/// Error of a depth, in 1 over squared rows: the law of resolution.hpp.
/// origin: measured (wrc_tradeoff): bounds 97 of 100 errors.
inline constexpr double error_of_one_row = 1.5;

/// How much larger the error of a force is, with the position prescribed.
/// origin: derived: a force goes with the power 1.5 of the depth (Hertz).
inline constexpr double force_by_depth = 1.5;

/// Rows of pressures that creep forces are computed from: their square times the accuracy.
/// origin: measured (wrc_tradeoff --creep 500, 1e-2 and 1e-3): with 10 it is met on 99.2 and 99.4 %
/// of patches, with 14 on 99.5 and 99.5 %; slopes over 0.4 mm are off by 0.5 and 0.28 accuracies a
/// mm.
inline constexpr double creep_row_law = 14.0;

/// The same for columns over a penetration as long as wide.
/// origin: measured (wrc_tradeoff --creep 500, 1e-2): with 2.6 it is met on 99.0 %, with 3.2 on
/// 99.5 %.
inline constexpr double creep_column_law = 3.2;

/// The power of length over width by which these columns grow, and those of tractions.
/// origin: measured (wrc_tradeoff --creep 500): without it errors reach 6 times an accuracy of 1e-3
/// where contact is 20 times as long as wide.
inline constexpr double columns_by_sides_exponent = 0.35;

/// How much better pressures must be that stresses are computed from.
/// origin: measured (compare_stress 100 7): 98 to 100 of 100 wheels meet 1e-1 to 1e-3 below the
/// surface.
inline constexpr double stress_accuracy_factor = 3.0;

/// How much worse elements of constant pressure are.
/// origin: measured (wrc_tradeoff --elements constant).
inline constexpr double constant_elements_error = 3.0;

/// Share of its grid that contact takes each way as a rule.
/// origin: derived: sqrt(0.5), Hertz: contact is half of the penetration.
inline constexpr double usual_share_of_row = 0.7;

/// Of the accuracy, what rows may leave; the rest is for the iteration and rounding.
/// origin: reasoned: 0.2 and 0.1.
inline constexpr double share_of_rows = 0.7;

/// Elements each way that an estimate above the accuracy takes, as a multiple of those before, at
/// most.
/// origin: reasoned: at a kink no number of rows resolves a crest.
inline constexpr double max_refinement = 4.0;

/// Length of the strips of a section, in lengths of the contact there: they displace their middle
/// as a semi-elliptic pressure over the contact does.
/// origin: derived: 2/e, since the integral of (sqrt(1 - t^2) - 1)/t from 0 to 1 is ln 2 - 1.
inline constexpr double strip_length_share = 2.0 / std::numbers::e;

/// Mean of a smooth pressure over an element, and its value at the centre: their difference in
/// second differences.
/// origin: derived: Taylor.
inline constexpr double mean_over_element = 1.0 / 24.0;

/// Error of a crest, in second differences of the strips at its top.
/// origin: measured (wrc_tradeoff): together with the law of resolution.hpp it bounds 95 to 100
/// of 100 errors of pmax.
inline constexpr double error_by_second_difference = 0.06;

/// Strips of a section for each row.
/// origin: measured (600 wheels, 99 %): 8 make errors of pmax a tenth smaller, 1 is no section at
/// all.
inline constexpr double strips_per_row = 4.0;

} // namespace wrc
