/// Normal displacement of a half-space under the pressure of one rectangular element.
///
///   u(x, y) = p/(pi E*) * I(x, y),   I = integral over the element of dA / distance
/// (Love, Phil. Trans. R. Soc. A 228, 1929; Johnson, Contact Mechanics, 1985, eq. 3.25).
/// Near the element the closed form in logarithms, grouped so that no two large numbers are
/// subtracted: the sum over the element's edges of the distance to the edge's line times
///   integral along the edge of 1/distance = ln((r1 + r2 + c)/(r1 + r2 - c)),
/// r1 and r2 to the ends of the edge, c its length. Tables compute each corner and edge once for
/// the elements that meet there. The error is some units of rounding times the distance counted in
/// elements; sums of x ln(y + r) + y ln(x + r) over the corners would lose with its square.
/// Beyond `far_field_distance` times the longer side, the multipole expansion of the element up to
/// order six (mean of r^n P_n over the rectangle), whose error is below 3e-13.
/// That is for elements of constant pressure. Sums over them are off by the second order of the
/// element size even where the pressure is smooth: with its values p at the centres they leave
///   u - sum K p = -1/24 A (a^2 p_xx + b^2 p_yy) + higher orders
/// (Taylor series of p on each element; the terms of first order add up to another integral of the
/// second derivatives, by parts; near the singularity a term of third order is left). Smooth
/// elements take that into the coefficients, with second differences for the derivatives:
///   K' = K - 1/24 (K[i+1, j] + K[i-1, j] + K[i, j+1] + K[i, j-1] - 4 K[i, j]).
/// The element then has 7/6 of its pressure on itself and -1/24 on each neighbour, the sum of
/// forces and the symmetry stay, no eigenvalue gets smaller (the factor is 1 to 4/3), and what is
/// left of the error comes from the edge of contact: a fifth to a tenth of that of constant
/// elements (docs/evidence/accuracy.md).
/// Units mm and MPa; x longitudinal, y lateral, both from the element's centre. Displacements of
/// both bodies together, positive into the body. Does not handle the grid's edge, of tangential
/// tractions and of bodies that are not half-spaces.
#pragma once

#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "half_space/constants.hpp"

namespace wrc {

/// What the value of an element stands for.
enum class Elements {
  constant, ///< the pressure everywhere on it (Love)
  smooth    ///< the value at its centre of a pressure that is smooth inside the contact
};

/// Which influence coefficients, for elements of 1 x aspect.
struct InfluenceKernel {
  double aspect = 1.0;
  Elements elements = Elements::constant;

  /// Any order, to look kernels up.
  friend bool operator<(const InfluenceKernel& one, const InfluenceKernel& other) {
    return std::tie(one.aspect, one.elements) < std::tie(other.aspect, other.elements);
  }
};

/// I(x, y) in mm, of an element of constant pressure.
double influence_integral(double longitudinal_distance, double lateral_distance,
                          double longitudinal_step, double lateral_step);

/// A table: values[row * columns + column] = pi E* K for this number of rows and columns between
/// two elements, in units of the longitudinal step.
void fill_influence_table(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns,
                          std::span<double> values);

/// Integrals of Cerruti's solution over an element of 1 x aspect with constant traction, by the
/// number of elements between two points: the integrals of y^2/r^3, x^2/r^3 and x y/r^3 over the
/// element (Johnson 1985, eq. 3.91: u_x is the integral of (1 - nu)/r + nu x^2/r^3 = x^2/r^3 + (1 -
/// nu) y^2/r^3). The first two are the two halves of I above, so the same logarithms serve both
/// problems.
struct TractionTable {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;

  [[nodiscard]] double* lateral(std::size_t row) { return values.data() + 3 * row * columns; }
  [[nodiscard]] double* longitudinal(std::size_t row) { return lateral(row) + columns; }
  [[nodiscard]] double* mixed(std::size_t row) { return lateral(row) + 2 * columns; }
  [[nodiscard]] const double* lateral(std::size_t row) const {
    return values.data() + 3 * row * columns;
  }
  [[nodiscard]] const double* longitudinal(std::size_t row) const { return lateral(row) + columns; }
  [[nodiscard]] const double* mixed(std::size_t row) const { return lateral(row) + 2 * columns; }
};

TractionTable traction_table(double aspect, std::size_t rows, std::size_t columns);

/// Displacements of unlike bodies across directions: the integrals of x/r^2 and y/r^2 over an
/// element of 1 x aspect, by the number of elements between two points. With Kalker's K
/// (half_space/material.hpp) and loads on body 1, a pressure p displaces it along the surface,
/// relative to body 2, by
/// -K/(pi G) p (x, y)/r^2, and a traction q opens the gap by K/(pi G) q.(x, y)/r^2 (Johnson 1985,
/// eqs. 3.18 and 3.75, of both bodies).
struct CrossTable {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;

  [[nodiscard]] double* longitudinal(std::size_t row) { return values.data() + 2 * row * columns; }
  [[nodiscard]] double* lateral(std::size_t row) { return longitudinal(row) + columns; }
  [[nodiscard]] const double* longitudinal(std::size_t row) const {
    return values.data() + 2 * row * columns;
  }
  [[nodiscard]] const double* lateral(std::size_t row) const { return longitudinal(row) + columns; }
};

CrossTable cross_table(double aspect, std::size_t rows, std::size_t columns);

/// The derivatives of these integrals by the position along x, as `longitudinal` and `mixed` of a
/// table that is to be read with nu = 1: the exact ones, from the element's two edges across.
TractionTable cross_rate_table(double aspect, std::size_t rows, std::size_t columns);

/// u per unit pressure, in mm/MPa: I/(pi E*) of constant elements.
double influence_coefficient(double longitudinal_distance, double lateral_distance,
                             double longitudinal_step, double lateral_step, double combined_modulus,
                             Elements elements = Elements::constant);

} // namespace wrc
