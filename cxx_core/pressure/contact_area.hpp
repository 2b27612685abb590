/// The area of contact from the zero line of p^2.
///
/// p^2 at the element centres, continued to negative values outside contact (edge_square of
/// squared_pressure.hpp), is interpolated linearly on four triangles between any four centres and
/// their mean; the area is where it is above 0. Towards the grid's own edge the outermost values
/// go on unchanged, so area is never counted beyond the grid.
///
/// Relative error against Hertz, n elements across the shorter axis, axis ratios 1/5 to 5, any
/// orientation and shift; root mean square over the cases, the largest is 2 to 4 times that:
///   pressures solved on the grid, smooth elements: 5 % at n = 3, 0.5/n^2 for n = 6 to 24, 1.4/n^2
///   at 96; constant elements: 8 % at n = 3, 1/n^2 for n = 6 to 24, 3.2/n^2 at 96, where a
///   remainder of -0.03/n shows, since the pressures of their outermost elements are smaller still
///   than edge_beyond_pressures says; pressures sampled from the closed form, which are not too
///   small there: too large by 0.07/n.
/// Counting elements is +0.38/n too large with pressures of constant elements, +0.55/n of smooth
/// ones, and worse at every n from 2 on.
/// Where pressures do not fall to 0 at the edge (punches) the area is the counted one except for
/// rounded corners of a quarter of an element at the most; a single element counts two thirds.
/// When contact moves across the grid the area jumps by 0.3 of an element with 6 elements across,
/// 0.1 with 12, 0.02 with 24; counted it jumps by 1 to 3.
/// Units mm, N, MPa; frame and order of elements of base/grid.hpp. Thread rule: pure functions.
#pragma once

#include <span>
#include <vector>

#include "base/grid.hpp"
#include "pressure/pressure_field.hpp"

namespace wrc {

/// Area of contact of the whole grid, mm^2. Throws Error(invalid_argument) for a pressure span of
/// another size than the grid.
double contact_area(const Grid& grid, std::span<const double> pressure);

} // namespace wrc
