/// Creep forces of the patches of a wheel, from the pressures found.
///
/// Each patch is solved by itself on a grid of its own over the rectangle around its contact, with
/// the pressures interpolated to it (pressure/smooth_pressure.hpp) and scaled to its normal force.
/// Elements follow from the requested accuracy and the pressures (creep_grid.hpp); where their
/// number does not change, forces are continuous functions of the scene. Patches of one plane are
/// solved one by one as well, each with the rigid slip at its place. Tractions of unlike bodies
/// change the pressures they stem from: the full model takes that into the pressures on its own
/// grid (rolling/unlike_bodies.hpp).
///
/// Results: creep_result.hpp. Units mm, N, MPa, rad. Thread rule: as the solver's.
///
/// Not known here: what the tractions of patches displace at each other, and what those of unlike
/// bodies change in the results of normal contact.
#pragma once

#include <optional>
#include <vector>

#include "half_space/material.hpp"
#include "rolling/rolling_contact.hpp"
#include "wheel/constants.hpp"
#include "wheel/creep_result.hpp"
#include "wheel/friction.hpp"
#include "wheel/kinematics.hpp"
#include "wheel/rigid_slip.hpp"

namespace wrc {

struct PatchRates;
struct PatchResult;
struct WheelResult;

/// How creep forces are computed: the ladder of docs/creep-models.md. Closed formulas and FASTSIM
/// stand on the Hertzian ellipse with the patch's second moments of pressure; FASTSIM by strips and
/// the full theory on its own pressures.
enum class CreepModel { none, linear, shen_hedrick_elkins, polach, fastsim, fastsim_strips, full };

/// What a wheel's creep forces follow from.
struct CreepRequest {
  CreepModel model = CreepModel::none;
  Creepages creepages;            ///< at the reference of each patch, track frame; or
  std::optional<Motion> motion;   ///< what they follow from instead, track frame
  double nominal_radius = 0.0;    ///< mm, for the motion
  RailDisplacement rail_velocity; ///< mm/s and rad/s, for the motion, track frame
  SlipChoice slip;                ///< from the motion
  FrictionLaw friction;
  double accuracy = 1e-3;     ///< error of forces, and of the moment over sqrt(a b), over mu N
  double speed = 0.0;         ///< mm/s, for the power of given creepages
  bool derivatives = false;   ///< whether CreepResult::derivatives are requested
  bool pitch_is_free = false; ///< `motion` is one of several that are tried
  double element_limit = default_element_limit; ///< of the grids of a wheel together
  /// What that leaves of the elements of each; found if it is not set.
  std::optional<double> element_share{};
  ShearConstants material;
  double combined_modulus = 0.0; ///< E*, MPa
};

/// Fills in the creep forces of all patches, in place of earlier ones.
void solve_creep_forces(WheelResult& wheel, const CreepRequest& request, RollingSolver& solver);
/// Those of one patch, and of its parts; of a request with a motion those of the wheel's motion as
/// solve_creep_forces has set it. `rates`: of the patch, or of its parts one after the other, for
/// the derivatives by positions.
CreepResult creep_of_patch(const WheelResult& wheel, const PatchResult& patch,
                           const CreepRequest& request, RollingSolver& solver,
                           std::vector<CreepResult>& parts, const PatchRates* rates = nullptr);
/// Adds the warnings that the creep forces found give rise to.
void warn_of_creep_forces(WheelResult& wheel, const CreepRequest& request);

} // namespace wrc
