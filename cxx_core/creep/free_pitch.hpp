/// The pitch rate at which the wheels' contact forces hold the torque on their axle.
///
///   T + e_axle . sum M(pitch rate) = 0
///
/// M the moments of all contact forces about the wheelset's centre (creep/total_force.hpp), e_axle
/// the axle pointing left; T > 0 drives forwards. The sum falls as the pitch rate grows, from
/// sliding one way to sliding the other way. Polach's model, which costs next to nothing, gives the
/// start and the slope of the sum there; secants and a bracket do the rest. Where friction falls
/// with slip the sum has a least and a greatest value: of several rates the one with the least slip
/// is taken. Units N mm, rad/s. Thread rule: as the solver's.
#pragma once

#include <span>

#include "creep/creep_request.hpp"
#include "records/wheel_result.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

/// A wheel with its normal contact solved, and what its creep forces follow from.
struct DrivenWheel {
  WheelResult* wheel = nullptr;
  CreepRequest request; ///< with a motion
};

struct FreePitch {
  double rate = 0.0;
  /// Friction cannot hold the torque: the wheels slide, with a creepage of 1 along the track.
  bool saturated = false;
  /// Friction that falls with slip holds the torque at a rate with more slip as well.
  bool ambiguous = false;
  int evaluations = 0; ///< of the torque by the requested model
};

/// Solves the creep forces of the wheels at the rate found.
FreePitch solve_free_pitch(std::span<DrivenWheel> wheels, double torque, RollingSolver& solver);

} // namespace wrc
