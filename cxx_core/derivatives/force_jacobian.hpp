/// How all contact forces of a wheel change with the wheelset's positions and velocities.
///
/// For implicit integrators. Forces and moments about the wheelset's centre as those of
/// creep/total_force.hpp, F = sum (F_n + T) and M = sum (M_n + r x T + M_spin n), by lateral
/// position, height, roll and yaw and by six velocities; by the position along the track and the
/// angle of the axle nothing changes. Normal forces as in derivatives/patch_rates.hpp, with equal
/// pairs where there are no creep forces. Tangential ones,
/// with creepages c and the derivatives of the tangential solution (CreepDerivatives), change by
///   dT = (dT/dc) dc + (dT/dp) dp + (dT/dmu) dmu
/// and with their plane, which turns. dc and dmu from the motion of wheelset and patch
/// (creep/kinematics.hpp, creep/friction.hpp), dT/dp dp, by pressures, as creep/creep_rates.hpp has
/// it; of unlike bodies the contact is taken to stay similar, (dT/dN) dN.
/// Units N, N mm by mm, rad, mm/s, rad/s. Track frame. Thread rule: pure functions.
///
/// Not known here: elements that enter the contact, or change between adhesion and slip; the change
/// of it by tangential forces of an unknown pitch rate.
#pragma once

#include <array>

#include "creep/kinematics.hpp"
#include "records/motion.hpp"

namespace wrc {

struct PatchRates;
struct PatchResult;
struct WheelRates;
struct WheelResult;

/// Whether all patches that carry creep forces have their derivatives (CreepRequest), as a Jacobian
/// needs.
bool jacobian_is_known(const WheelResult& wheel);

/// The Jacobian of a wheel for which jacobian_is_known() holds, with the rates of its normal
/// forces. Prescribed creepages stay fixed.
ForceJacobian jacobian_of(const WheelResult& wheel, const WheelRates& rates);

/// Longitudinal and lateral creep force, spin moment and force along the normal beyond creepages of
/// a patch with derivatives, with their rates; left-hand frame of the side.
std::array<RatedByState, 4> rated_creep_forces(const WheelResult& wheel, const PatchResult& patch,
                                               const PatchRates& rates);

} // namespace wrc
