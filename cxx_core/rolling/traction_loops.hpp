/// The loops over elements of the tangential solver, vectorised.
///
/// A vector of tractions or slips has 2 n values, n for x and then n for y. In adhesion Newton's
/// equations are (B dz) = -s; in slip, with n = (q - r s)/|q - r s|, t across it and dz = a t,
///   t.(B dz) + (sigma/g) a = -t.s,   sigma: speed of slip
/// (the bound g n turns with the slip's direction). With the projector P (all, only t, or nothing
/// outside the contact) both read P B dz + ratio dz = -P s. Does not handle grids.
/// Thread rule: pure functions. Order of sums is fixed by the instruction set.
#pragma once

#include <cstddef>

namespace wrc {

/// One level's fields of linearised elements: n values each.
template <typename Real> struct LinearisedElements {
  Real* projector_xx;
  Real* projector_xy;
  Real* projector_yy;
  Real* ratio;      ///< sigma/g, 0 in adhesion
  Real* inverse_xx; ///< of the march's diagonal, projected
  Real* inverse_xy;
  Real* inverse_yy;
};

/// r and the diagonals of an element.
struct ElementScales {
  double step = 1.0;       ///< r
  double diagonal_x = 1.0; ///< of the march
  double diagonal_y = 1.0;
  double damping = 0.0; ///< added to the ratio of every element
};

struct ResidualSums {
  double change = 0.0; ///< sum |q - cut(q - r s)|
  double size = 0.0;   ///< sum |cut(q - r s)|
  [[nodiscard]] double ratio() const { return change == 0.0 ? 0.0 : change / size; }
};

/// The natural residual of q with slip s; elements without bound g count nothing. `edge`: what the
/// leading edge adds to an element's influence on itself, in x and in y; r is smaller there.
template <typename Real>
ResidualSums natural_residual(const Real* q, const Real* s, const Real* g, const Real* edge,
                              double step, std::size_t n);

/// Sorts elements into adhesion and slip, fills `elements` and writes to `change` what brings q
/// onto the bound where it slips and within it where it sticks.
template <typename Real>
void linearise(const Real* q, const Real* s, const Real* g, const Real* edge,
               const ElementScales& scales, const LinearisedElements<Real>& elements, Real* change,
               std::size_t n);

/// out = P in + ratio z, all of 2 n values.
template <typename Real>
void project(const LinearisedElements<Real>& elements, const Real* in, const Real* z, Real* out,
             std::size_t n);

/// q onto the bound against the slip where q - r s exceeds it, else within it.
template <typename Real>
void cut_to_bound(Real* q, const Real* s, const Real* g, const Real* edge, double step,
                  std::size_t n);

/// out += what edges add to displacements under z.
template <typename Real> void add_edges(const Real* edge, const Real* z, Real* out, std::size_t n);

} // namespace wrc
