/// How a patch's creep forces change with its pressures, at fixed creepages of its reference.
///
/// Pressures change as normal contact says, with elements that follow the contact
/// (derivatives/patch_rates.hpp), the plane fixed; the reference moves along it. A patch a little
/// ahead and one a little behind, p + h dp and p - h dp, are brought onto the grid of creep forces,
/// or to an ellipse, as the patch is itself: their differences are the rates of the quantities that
/// creep forces follow from. The grid of creep forces goes with the contact's ends, edges move
/// within its elements. No contact is solved for them. Left-hand frame of the side; mm, rad, N,
/// MPa. Thread rule: pure functions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "creep/kinematics.hpp"
#include "creep/rigid_slip.hpp"
#include "records/rates.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

struct CreepDerivatives;
struct PatchRates;
struct PatchResult;

/// A patch as it is, or after a motion of the wheelset.
struct MovedPatch {
  std::vector<double> pressure;
  double normal_force = 0.0;
  ElementMotion elements; ///< of its grid, about its reference; times the motion
};

struct PatchMove {
  MovedPatch ahead, behind;
  double apart = 0.0; ///< mm or rad
};

/// By lateral position, height, roll and yaw; pressures change by the fraction `share` of their
/// largest.
ByMotion<PatchMove> moves_of(const PatchResult& patch, const PatchRates& rates, double share);

/// A grid of the patch's plane after its elements have moved.
Grid moved_grid(Grid grid, const ElementMotion& motion);

/// Fields of a problem's grid.
struct ProblemFields {
  std::vector<double> pressure, covered;
  SlipField slip;    ///< beyond creepages
  SlipField weights; ///< of the weighted force
};
/// From a problem to a grid and fields on it a step later.
ProblemRate rate_between(const RollingProblem& now, const Grid& grid, const ProblemFields& later,
                         double step);

/// Rows Fx, Fy, Mz and a column for each position.
using ForcesByPosition = std::array<double, 3 * position_count>;

/// From differences of the forces on moved patches.
template <class Forces>
ForcesByPosition differences_of(const ByMotion<PatchMove>& moves, const Forces& forces) {
  ForcesByPosition by{};
  for (std::size_t i = 0; i < position_count; ++i) {
    const CreepForces ahead = forces(moves[i].ahead);
    const CreepForces behind = forces(moves[i].behind);
    by[i] = (ahead.longitudinal - behind.longitudinal) / moves[i].apart;
    by[position_count + i] = (ahead.lateral - behind.lateral) / moves[i].apart;
    by[2 * position_count + i] = (ahead.spin_moment - behind.spin_moment) / moves[i].apart;
  }
  return by;
}

/// Those by load and friction, from those by creepages (CreepDerivatives).
void complete(CreepDerivatives& derivatives, const CreepForces& forces, const Creepages& at,
              double friction, double normal_force);
/// Adds the derivatives of a part at a point of the plane, whose creepages follow from those at the
/// origin: c' = T c, and forces about the origin are T^t of the part's; derivatives by positions
/// are not added.
void add_derivatives(CreepDerivatives& whole, const CreepDerivatives& part, double weight,
                     double longitudinal, double lateral);

} // namespace wrc
