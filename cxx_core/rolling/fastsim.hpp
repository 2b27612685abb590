/// FASTSIM: rolling contact on a bed of springs (Kalker 1982, A Fast Algorithm for the Simplified
/// Theory of Rolling Contact, VSD 11, 1-13), on an ellipse and on any patch.
///
/// Displacements are u = L q at each point, so that along a strip of constant y, from its leading
/// edge downstream,
///   dq/dx = w/L where it sticks;  q = -mu p s/|s| where it slips,
/// with the frame, signs and units of rolling_contact.hpp. Three flexibilities L1, L2, L3 serve the
/// longitudinal and lateral creepage and the spin. On an ellipse, as Kalker has it,
///   w/L = (xi/L1 - phi y/L3, eta/L2 + phi x/L3).
/// On any patch, spin acts on a strip as it does about the strip's middle, xs: longitudinal and
/// lateral creepage, and a rest that turns about the middle,
///   w/L = ((xi - phi y)/L1, (eta + phi (xs + x0))/L2 + phi (x - xs)/L3),
/// which on ellipses is nearer to the full theory than Kalker's. The flexibilities are chosen so
/// that Fx of xi, Fy of eta and Fy of phi are right without slip. What the theory does not know:
/// elements act on none but themselves. Its error does not fall with its grid; the slip speeds are
/// its weakest results (docs/creep.md).
/// Thread rule: pure functions.
#pragma once

#include "rolling/creep_laws.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

/// Displacement over traction of the bed of springs, mm/MPa. Infinite: creepage of this kind is
/// without effect.
struct Flexibilities {
  double longitudinal = 0.0; ///< L1
  double lateral = 0.0;      ///< L2
  double spin = 0.0;         ///< L3
  /// x0, mm: by how much the lateral creepage of spin acts ahead of the strips. 0 for patches that
  /// are their own image from the front, as an ellipse is, and not used on ellipses.
  double spin_lead = 0.0;
};

/// L1 = 8a/(3 G C11), L2 = 8a/(3 G C22), L3 = pi a sqrt(a/b)/(4 G C23) (Kalker 1982).
Flexibilities flexibilities_of(const RollingEllipse& ellipse,
                               const KalkerCoefficients& coefficients);

struct FastsimGrid {
  std::size_t strips = 16; ///< of equal width, 1 to 256
  std::size_t slices = 16; ///< of equal length, of each strip
};

struct FastsimForces {
  CreepForces forces;
  double slip_area = 0.0;      ///< mm^2
  double adhesion_area = 0.0;  ///< mm^2
  double friction_power = 0.0; ///< -F.w, N
};

/// On an ellipse whose friction is limited by mu p, p = 2N/(pi a b) (1 - (x/a)^2 - (y/b)^2): the
/// parabolic pressure that goes with springs. Throws Error(invalid_argument) for a grid out of
/// range; the ellipse is not checked (check_ellipse).
FastsimForces fastsim_forces(const RollingEllipse& ellipse, const Flexibilities& flexibilities,
                             const Creepages& creepages, const FastsimGrid& grid = {});

/// Strip by strip on the problem's own pressures, each strip (each part of it, where it has gaps)
/// from its own leading edge. For steady rolling: throws Error(invalid_argument) for other motions,
/// for flexibilities that are not positive, and as check_problem does. Numbers of the full solver's
/// iteration are 0, and the solution is `converged`.
RollingSolution solve_with_fastsim(const RollingProblem& problem,
                                   const Flexibilities& flexibilities);

/// Flexibilities with which FASTSIM has on this very patch, without slip, the Fx of xi, the Fy of
/// eta and the Fy of phi of the full theory: from three solutions without slip on a coarse grid.
/// About the point where Fy of phi and Mz of eta are C23 and -C23, as Kalker's are about the middle
/// of an ellipse, L3 follows from C23; the distance of that point ahead of the springs' is x0. They
/// do not depend on pressures, friction and creepages, only on which elements are in contact:
/// compute them once for a patch. No ellipse is assumed. Throws as check_problem does.
Flexibilities flexibilities_of(const RollingProblem& problem, RollingSolver& solver);

} // namespace wrc
