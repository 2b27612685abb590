/// Forces of rolling contact from closed formulas, on an ellipse: the cheapest of the models.
///
/// The frame, signs and units are those of rolling_contact.hpp: x the rolling direction, y to the
/// left, origin at the ellipse's centre, creepages wheel minus rail, forces on the wheel; mm, N,
/// MPa, rad. With c = sqrt(a b) and Kalker's coefficients (kalker_coefficients.hpp)
///   linear (Kalker 1967, On the Rolling Contact of Two Elastic Bodies, Delft):
///     Fx = -G c^2 C11 xi,  Fy = -G c^2 (C22 eta + c C23 phi),  Mz = G c^3 (C23 eta - c C33 phi)
///     exact for small creepages; it knows no friction and is off by a tenth from 0.3 mu N.
///   Shen, Hedrick & Elkins (1983, A Comparison of Alternative Creep Force Models for Rail Vehicle
///   Dynamic Analysis, VSD 12, 79-83): the linear forces, cut as Vermeulen & Johnson (1964) cut
///   those without spin,
///     F = mu N (t - t^2/3 + t^3/27) for t < 3, else mu N;  t = |F linear|/(mu N)
///     with the moment shortened as the forces are. Meant for small spin.
///   Polach (1999, A Fast Wheel-Rail Forces Calculation Computer Code, VSD 33 suppl., 728-739):
///     F = (2 mu N/pi) (kA e/(1 + (kA e)^2) + atan(kS e)),  e = G pi a b cjj sC/(4 mu N)
///     cjj s = sqrt((C11 xi)^2 + (C22 eta)^2),  s = sqrt(xi^2 + eta^2),  sC = sqrt(xi^2 + etaC^2)
///     etaC = eta + a phi where that is larger in absolute value, else eta
///     Fx = -F xi/sC,  Fy = -F eta/sC - FyS
///     FyS = (9/16) a mu N K (1 + 6.3 (1 - exp(-a/b))) phi/sC
///     K = (1 - d^2)^(3/2)/3 - eS (d^3/3 - d^2/2 + 1/6),  d = (eS^2 - 1)/(eS^2 + 1)
///     eS = (8/3) G b sqrt(a b) C23 |etaC|/(mu N (1 + 6.3 (1 - exp(-a/b))))
///     kA and kS stand for the stiffness in adhesion and slip, 1 for clean surfaces. There is no
///     moment in it. The sign of K is the one that makes the limit that of the linear theory, from
///     which it still differs where xi and phi come together.
/// How far off they are: docs/creep.md. Thread rule: pure functions.
#pragma once

#include "rolling/kalker_coefficients.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// What is known of a contact by an ellipse.
struct RollingEllipse {
  double longitudinal_semi_axis = 0.0; ///< a, along x
  double lateral_semi_axis = 0.0;      ///< b
  double load = 0.0;                   ///< N
  double friction = 0.3;               ///< mu
  double shear_modulus = 0.0;          ///< G, as in RollingProblem
  double poisson = 0.0;                ///< nu, as in RollingProblem
};

struct CreepForces {
  double longitudinal = 0.0; ///< Fx, N
  double lateral = 0.0;      ///< Fy, N
  double spin_moment = 0.0;  ///< Mz, N mm
};

/// Kalker's coefficients of its axes and Poisson's ratio. Computed once, it serves all creepages.
KalkerCoefficients kalker_coefficients(const RollingEllipse& ellipse);

/// Throws Error(invalid_argument) for semi-axes or a modulus that are not positive, a negative load
/// or friction, or a Poisson's ratio outside 0 to 0.5.
void check_ellipse(const RollingEllipse& ellipse);

CreepForces linear_forces(const RollingEllipse& ellipse, const KalkerCoefficients& coefficients,
                          const Creepages& creepages);

CreepForces shen_hedrick_elkins_forces(const RollingEllipse& ellipse,
                                       const KalkerCoefficients& coefficients,
                                       const Creepages& creepages);

/// Fractions of Kalker's stiffness in Polach's law: 1 on clean surfaces, less on wet ones.
struct PolachReduction {
  double adhesion = 1.0; ///< kA
  double slip = 1.0;     ///< kS, at most kA
};

CreepForces polach_forces(const RollingEllipse& ellipse, const KalkerCoefficients& coefficients,
                          const Creepages& creepages, const PolachReduction& reduction = {});

} // namespace wrc
