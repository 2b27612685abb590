/// The tangential contact problem of two half-spaces with Coulomb friction, and its answer.
///
/// Steady rolling in +x: with u = A q the displacement of body 1 (wheel) relative to body 2 (rail)
/// under the tractions q on body 1,
///   s = w - du/dx,  w = (xi - phi y, eta + phi x)         slip and rigid slip over the speed
/// and, where it is given, a rigid slip of each element in addition;
///   |q| <= g = mu p;  s = 0 where |q| < g;  q = -g s/|s| where s is not 0
/// (Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, ch. 1 and 5). A step of
/// transient rolling, by one element h, has s = w + (u(x) - u'(x + h))/h with u' the displacement
/// before the step, and a shift s = w + u - u' with w in mm (xi and eta in mm, phi in rad).
/// A step of time (`step_length` d above 0) has s = w - f du/dx + (u - u')/d, with f the speed of
/// rolling and 1/d the rate of steps over the speed that slips are over, and u' at the same place
/// of the contact: an implicit step, which is steady rolling for long steps and a shift at
/// standstill.
/// Frame: x rolling direction, y to the left; the leading edge is at large x. Creepages are wheel
/// minus rail, forces act on the wheel. Units mm, N, MPa, rad.
/// Unlike bodies (Kalker's difference parameter K is not 0) displace across as well: pressures add
/// the slip K/(pi G) d/dx of the integral of p (x, y)/r^2 to w, and tractions open the gap by
/// `normal_displacement`, which changes the pressures in turn (rolling/unlike_bodies.hpp).
/// Rows of elements that lie along a curve across the rail have angles: lateral tractions and slips
/// are along their own row. What pressures and tractions displace of each other there
/// (rolling/curve_displacement.hpp) is not part of the problem.
/// Derivatives along x are upstream-biased differences inside the influence coefficients
/// (traction_convolution.hpp). The derivative of the displacement by pressures is exact where edges
/// are known. Pressures are given, and stay. Thread rule: plain values.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

/// Rigid slip of a patch over the speed, or of a shift in mm and rad.
struct Creepages {
  double longitudinal = 0.0; ///< xi
  double lateral = 0.0;      ///< eta
  double spin = 0.0;         ///< phi, 1/mm, positive turns x to y
};

/// What moves: a steady state of rolling, one step of rolling by one element, or one shift without
/// rolling (CONTACT's T = 3, 2 and 1).
enum class TangentialMotion { rolling, transient, shift };

/// How the derivative along x is taken.
enum class SlipDifference {
  biased,     ///< four points, second order up to the contact's edges
  first_order ///< one element upstream, as CONTACT (Vollebregt) does: for comparison
};

/// How a problem changes with something: elements, which move with the grid, their pressures and
/// the slip given for each.
struct ProblemRate {
  double longitudinal_first = 0.0; ///< mm, as the others
  double longitudinal_step = 0.0;
  double lateral_first = 0.0;
  double lateral_step = 0.0;
  std::vector<double> pressure{}; ///< MPa per element; without effect where there is none
  std::vector<double>
      covered{}; ///< covered fraction per element; empty: the edge stays in its element
  double rolling_share = 0.0;   ///< of f, in a step of time
  std::vector<double> slip_x{}; ///< of the slip given for each element; empty: it stays
  std::vector<double> slip_y{};
  std::vector<double> weight_x{}; ///< of the weights of each element; empty: they stay
  std::vector<double> weight_y{};
};

struct RollingProblem {
  Grid grid;
  std::span<const double> pressure; ///< MPa per element, >= 0
  /// Fraction of each element along x that is in contact, 0 to 1, where pressures are means over
  /// elements along x, and contact ends at the grid's lateral edges; empty: contact ends between
  /// elements. For steady rolling (leading_edge.hpp).
  std::span<const double> covered;
  double friction = 0.3;      ///< mu, >= 0
  double shear_modulus = 0.0; ///< G, MPa: 1/G = (1/G1 + 1/G2)/2
  double poisson = 0.0;       ///< nu: nu/G = (nu1/G1 + nu2/G2)/2, 0 to 0.5
  /// K, -0.5 to 0.5: K/G = ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4; other than 0 in steady rolling
  /// only.
  double difference_parameter = 0.0;
  std::span<const double> angles; ///< of rows along a curve by lateral index, rad; empty: a plane
  Creepages creepages;
  /// Rigid slip of each element in addition to that of the creepages, over the speed (a shift: mm);
  /// empty: none.
  std::span<const double> slip_x;
  std::span<const double> slip_y;
  /// Weights of each element in RollingSolution::weighted_force; empty: none.
  std::span<const double> weight_x;
  std::span<const double> weight_y;
  /// Of a step of time, mm; 0: none. -u'/d is part of the slip of each element.
  double step_length = 0.0;
  double rolling_share = 1.0; ///< f, 0 to 1, in a step of time
  /// Tractions before a step or a shift, MPa per element of the same grid, which moves with the
  /// contact; empty: none.
  std::span<const double> previous_x;
  std::span<const double> previous_y;
  TangentialMotion motion = TangentialMotion::rolling;
  SlipDifference difference = SlipDifference::biased;
  bool derivatives = false; ///< whether RollingSolution::by_creepage is requested
  /// For which RollingSolution::by_rate is requested, of like bodies in steady rolling.
  std::span<const ProblemRate> rates;
  double tolerance = 1e-3; ///< of the residual, see TangentialResiduals::natural
  int maximum_iterations = 30;
};

struct RollingSolution {
  std::vector<double> traction_x; ///< MPa per element, on the wheel
  std::vector<double> traction_y;
  std::vector<double> slip_x; ///< s per element in contact, over the speed (a shift: mm); 0 outside
  std::vector<double> slip_y;
  /// u after a step of time, mm per element: the u' of the next one. In adhesion less s h/(f +
  /// h/d), so that the next step makes up for the slip that the iteration leaves. Else empty.
  std::vector<double> displacement_x;
  std::vector<double> displacement_y;
  /// What the tractions open the gap by, mm per element; empty for like bodies.
  std::vector<double> normal_displacement;
  double longitudinal_force = 0.0; ///< N
  double lateral_force = 0.0;      ///< N
  double spin_moment = 0.0;        ///< N mm about the origin
  /// On request: derivatives of Fx, Fy (N) and Mz (N mm) by xi, eta and phi (1/mm), row by row
  /// (dFx/dxi, dFx/deta, ...), from the equations as linearised at the solution; else 0. Of a shift
  /// by mm and rad. Those by friction follow for like bodies, since F is homogeneous in mu and
  /// slips: mu dF/dmu = F - xi dF/dxi - eta dF/deta - phi dF/dphi, and less the derivative by a
  /// common factor of the slip given for each element.
  std::array<double, 9> by_creepage{};
  double weighted_force = 0.0;                  ///< sum of tractions times the problem's weights, N
  std::array<double, 3> weighted_by_creepage{}; ///< likewise on request
  /// Derivatives of Fx, Fy (N), Mz (N mm) and the weighted force by each of the problem's rates, in
  /// the same way.
  std::vector<std::array<double, 4>> by_rate;
  double slip_area = 0.0;     ///< mm^2
  double adhesion_area = 0.0; ///< mm^2
  /// -F.w in N: frictional power over the speed, exact for steady rolling, where the elastic energy
  /// does not change (cxx_core/creep/README.md); with that of the slip given for each element, and
  /// of unlike bodies including the displacement by pressures.
  double friction_power = 0.0;
  double power_of_pressures = 0.0; ///< of it what pressures of unlike bodies add, N
  double numerical_loss = 0.0;     ///< fraction of it that slip times traction does not show
  int iterations = 0;
  int convolutions = 0;  ///< on all grids
  double residual = 0.0; ///< reached by the iteration
  bool converged = true; ///< the residual met the tolerance
};

/// How well tractions solve a problem, from a convolution in double precision of its own.
struct TangentialResiduals {
  /// sum |q - cut(q - r s)| / sum |q|, cut: onto the circle of radius g; r: `natural_step`.
  double natural = 0.0;
  double excess = 0.0;          ///< max |q|/g - 1
  double complementarity = 0.0; ///< sum (g |s| + q.s) / sum g |w|
  double adhesion_slip = 0.0;   ///< mean |s| of elements in adhesion over mean |w|
  double angle = 0.0; ///< mean angle between q and -s of elements in slip, weighted by |s|
};

} // namespace wrc
