/// Normal displacement of a half-space under uniform pressure on one rectangular element.
///
///   u(x, y) = p/(pi E*) * I(x, y),   I = integral over the element of dA / distance
/// (Love, Phil. Trans. R. Soc. A 228, 1929; Johnson, Contact Mechanics, 1985, eq. 3.25).
/// Near the element the closed form in logarithms, grouped so that no two large numbers are
/// subtracted: the error is some units of rounding times the distance counted in elements. Beyond
/// `far_field_distance` times the longer side, the multipole expansion of the element up to order
/// six (mean of r^n P_n over the rectangle), whose first neglected term is below 2e-13.
/// Units mm and MPa; x longitudinal, y lateral, both from the element's centre. Displacements of
/// both bodies together, positive into the body. Knows nothing of the grid's edge, of tangential
/// tractions and of bodies that are not half-spaces.
#pragma once

#include <span>

namespace wrc {

/// From this distance on, in units of the element's longer side, the expansion is used.
inline constexpr double far_field_distance = 16.0;

/// I(x, y) in mm.
double influence_integral(double longitudinal_distance, double lateral_distance,
                          double longitudinal_step, double lateral_step);

/// A row of a table: row[i] = I(i, lateral_distance) for elements of 1 x lateral_step, i = 0, 1,
/// ...
void fill_influence_row(double lateral_distance, double lateral_step, std::span<double> row);

/// u per unit pressure, I/(pi E*), in mm/MPa.
double influence_coefficient(double longitudinal_distance, double lateral_distance,
                             double longitudinal_step, double lateral_step,
                             double combined_modulus);

} // namespace wrc
