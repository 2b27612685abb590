/// What creep forces are requested of a wheel: model, creepages or motion, friction, accuracy.
///
/// Units mm, s, N, MPa, rad. Thread rule: plain values.
#pragma once

#include <optional>

#include "accuracy/constants.hpp"
#include "creep/elastic_history.hpp"
#include "creep/friction.hpp"
#include "creep/kinematics.hpp"
#include "half_space/material.hpp"
#include "records/creep_choice.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// What a wheel's creep forces follow from.
struct CreepRequest {
  CreepModel model = CreepModel::none;
  Creepages creepages;            ///< at the reference of each patch, track frame; or
  std::optional<Motion> motion;   ///< what they follow from instead, track frame
  double nominal_radius = 0.0;    ///< mm, for the motion
  RailDisplacement rail_slope{};  ///< WheelsetMotion
  RailDisplacement rail_velocity; ///< mm/s and rad/s, for the motion, track frame
  SlipChoice slip;                ///< from the motion
  /// A step of time from these displacements, s, of the full theory from the motion; 0: steady.
  double time_step = 0.0;
  const WheelHistory* history = nullptr; ///< none: no tractions before
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

} // namespace wrc
