/// Whether a side is in contact at the depth found, and what is said where it cannot be trusted.
///
/// Rounding: positions on the wheel are accurate to eps R, the rounding of its radius, and lateral
/// coordinates to eps y. Of these a distance along the normal of a contact of angle a takes
///   d_r = eps R cos(a) / 2,  d_y = eps y sin(a) / 2  (standard deviations),
/// d_r from element to element, d_y and another d_r from row to row. On a half-space a wave of
/// distances of the wave number k has pressures E* k / 2 times as high; over all waves that a grid
/// with elements of h_x (along) and h_y (across) knows, the pressures scatter by
///   s_p = pi / (2 sqrt(3)) E* sqrt(d_r^2 / h_x^2 + (d_r^2 + d_y^2) / h_y^2).
/// Where the peak is taken from a section (peak_section.hpp), h_y is the width of its strips.
/// This is absolute: relative to pmax it grows with the number of elements across the contact and
/// falls with 1/overlap. The halves are assumed, from the safe side: fields of distance show 0.2
/// (from element to element) to 0.36 (from row to row). Errors of pmax were below s_p in 82 and
/// below 2 s_p, which is what is warned of, in 99 per cent of 1983 solutions (loads from 1e-8 N,
/// tread to flange, radii of 150 to 5000 mm, accuracies of 1e-4 to 1e-2: docs/evidence/limits.md).
/// The approach is off by the difference between the tables of heights at the first touch and the
/// rays. Units mm, N, MPa. Thread rule: pure functions.
#pragma once

#include "accuracy/grid_solution.hpp"
#include "base/warning.hpp"
#include "records/wheel_request.hpp"

namespace wrc {

/// Whether there is contact at a depth found from the request. If not, a warning says why, except
/// for a load of zero: loads too small to distinguish from zero are treated as zero. An absurd
/// overlap throws Error(invalid_argument).
bool is_in_contact(const WheelRequest& request, double depth, Warnings& warnings);

/// Throws Error(no_contact) if the depth found for a load in the end is no overlap of wheel
/// and rail. `depth` is vertical, from the first touch.
void check_found_depth(const WheelRequest& request, double depth);

/// Marks a solution that the search abandons, though it is in contact, as not converged; a warning
/// says after how many solutions.
void mark_unsettled(GridSolution& solution, int solutions, Warnings& warnings);

/// Warns of overlaps so small that the rounding of positions takes more than the requested
/// accuracy.
void warn_of_rounding(const GridSolution& solution, const WheelRequest& request,
                      double wheel_radius, Warnings& warnings);

} // namespace wrc
