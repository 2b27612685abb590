/// How the forces of the rail on a wheel change with lateral position, height, roll and yaw.
///
/// Derivatives of the discrete solution at its fixed set of elements in contact, for integrators
/// that need a Jacobian. Elements follow the contact: of a single patch as its grid does, so that
/// the derivatives are those of the discrete forces; of several they move with its centre of
/// pressure and grow with its semi-axes, as found by a first solution with fixed elements (of
/// patches that interact they move along the rail alone). What the fixed set leaves out is then
/// only how the contact changes its form. With the directions f of elements, p their pressures and
/// r the ends of their rays on the rail (remesh/rail_normals.hpp),
///   F = sum p f dA,  M = sum (r - r_c) x p f dA,
/// r_c the wheelset's centre. dp/dq follows from the change of the gap (derivatives/gap_rates.hpp)
/// and one linear solution for each motion (derivatives/contact_stiffness.hpp). f and r change as
/// elements move, and as the plane turns, along whose normal gaps are measured; how fast it turns
/// is the caller's knowledge (derivatives/plane_rates.hpp). The derivative of M includes that r_c
/// moves.
///
/// Rows along a curve (patches/contact_curve.hpp) stay on it where elements move, and turn with it;
/// the curve itself stays in the track, since its motion has only a second-order effect.
///
/// The position is that of the pair, at which the pressures have the approach 0.
/// At constant vertical load the height follows: dz/dq = -(dF_z/dq) / (dF_z/dz), and
///   dF_y/dq at constant load = dF_y/dq + dF_y/dz dz/dq.
///
/// Units mm, N, MPa, rad: forces by N/mm and N/rad, moments by N and N mm/rad. Track frame,
/// left-hand side. The right side is the left one of the mirrored pose (y, yaw, roll with the other
/// sign, geometry/frames.hpp), see RollingFrame::mirrored.
/// With both sides in the track frame the wheelset's matrix is their sum.
/// Thread rule: pure functions, except that a solver keeps memory: it serves one thread at a time.
/// Not known here: friction, inertia, changes of the set of elements.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/by_motion.hpp"
#include "derivatives/contact_stiffness.hpp"
#include "patches/contact_frame.hpp"
#include "records/rates.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

ForceRates operator+(const ForceRates& a, const ForceRates& b);

/// A patch of a solution.
struct LoadedPatch {
  ContactFrame frame;
  Grid grid;
  std::span<const double> pressure; ///< MPa
  /// Of the plane, which turns about the frame's origin; 0 along a curve.
  ByMotion<double> angle_rates = {};
  /// How fast the contact moves along the rail, mm/mm and mm/rad, and the undeformed distance, mm,
  /// so that elements can follow the contact; without it they stay.
  ByMotion<double> along_rates = {};
  std::span<const double> undeformed_distance = {};
  std::span<const double> row_scales = {}; ///< remesh/row_scales.hpp
  /// How its grid moves, where that is known: elements then go with it.
  std::optional<ByMotion<ElementMotion>> grid_motion = {};
};

struct PatchSensitivity {
  double normal_force = 0.0; ///< sum of the pressures, N
  ByMotion<double> normal_force_rates;
  ByMotion<ElementMotion> elements;
  ByMotion<std::vector<double>> pressure_rates; ///< of these elements, MPa per mm or rad
  ForceRates force_rates;
};

struct WheelSensitivity {
  std::vector<PatchSensitivity> patches;
  WheelForce force; ///< at this position
  ForceRates force_rates;
  int iterations = 0; ///< of all linear solutions (contact_stiffness.hpp)
  StopReason stop_reason = StopReason::tolerance_met;
};

struct SensitivityRequest {
  double combined_modulus = 0.0; ///< E*, MPa
  Elements elements = Elements::constant;
  double tolerance = 1e-8;             ///< of the linear solutions
  PatchInfluence* influence = nullptr; ///< of the patches on each other
  std::span<const YieldingBody> yielding = {};
  /// How that influence itself changes with each motion, per mm or rad; null where it does not.
  ByMotion<PatchInfluence*> influence_rates = {};
};

/// Throws Error(invalid_argument) as the solver does.
WheelSensitivity compute_patch_rates(const PosedPair& pair, std::span<const LoadedPatch> patches,
                                     const SensitivityRequest& request, ContactStiffness& solver);

/// Makes the rates of all patches of a wheel together, whose force is `force`, symmetric: dQ_i/dq_j
/// = dQ_j/dq_i, Q the forces along the coordinates q, since they are derivatives of an energy.
/// Elements of a finite size break that by the error of sums. Both of a pair become the more
/// accurate one, such that what is left when the height follows a load stays as it is. Left-hand
/// side.
void make_symmetric(ForceRates& rates, const WheelForce& force, const Pose& pose);

/// None where the vertical force does not depend on the height (no contact).
std::optional<CondensedRates> condense_at_vertical_load(const ForceRates& rates);

} // namespace wrc
