#include "creep/kinematics.hpp"

#include <cmath>

namespace wrc {

namespace {

/// The formulas of the header for plain numbers or numbers with rates.
template <class Real> struct State {
  Real speed, lateral_velocity, vertical_velocity, roll_rate, pitch_rate, yaw_rate;
  Real lateral, roll, yaw;
};

template <class Real> struct PatchPlace {
  VectorOf<Real> longitudinal, lateral, normal;
  VectorOf<Real> place, centre;
  Real reference_y;
  double ahead;
};

template <class Real> struct Slip {
  std::array<Real, twist_count> twist;
  Real reference_speed, slip_speed;
};

template <class Real>
Slip<Real> slip_of(const State<Real>& state, const WheelsetMotion& wheelset,
                   const PatchPlace<Real>& patch) {
  using Vector = VectorOf<Real>;
  using std::cos, std::sin, std::sqrt;
  const RailDisplacement& rail = wheelset.rail_velocity;
  const double curvature = wheelset.motion.curvature;
  const Real zero(0.0);
  const Vector arm = patch.place - patch.centre;
  // Those of R = Rz(yaw) Rx(roll).
  const Vector along{cos(state.yaw), sin(state.yaw), zero};
  const Vector axle{-sin(state.yaw) * cos(state.roll), cos(state.yaw) * cos(state.roll),
                    sin(state.roll)};
  const Vector rolling = state.pitch_rate * axle;
  const Vector turning = rolling + state.roll_rate * along +
                         Vector{zero, zero, state.yaw_rate + curvature * state.speed};
  const Vector rail_turning{Real(rail.roll), zero, zero};
  const Vector rail_arm =
      patch.place - Vector{zero, Real(wheelset.rail_origin_y), Real(wheelset.rail_origin_z)};
  Vector velocity =
      Vector{state.speed * (1.0 - curvature * state.lateral), state.lateral_velocity - rail.lateral,
             state.vertical_velocity - rail.height} +
      cross(turning, arm) - cross(rail_turning, rail_arm);
  if (wheelset.follows_surface) {
    const Vector turn = rolling + Vector{zero, zero, curvature * state.speed};
    const Vector travel{state.speed * (1.0 - curvature * state.lateral), zero, zero};
    const Vector round_arm = arm - Vector{Real(patch.ahead), zero, zero};
    const Vector round_normal{zero, patch.normal.y, patch.normal.z};
    velocity.z = velocity.z - (dot(travel + cross(turn, arm), patch.normal) -
                               dot(cross(turn, round_arm), round_normal)) /
                                  patch.normal.z;
  }
  Slip<Real> slip;
  const Vector& ahead = patch.longitudinal;
  const Real travelled =
      ahead.x + ahead.z * ahead.z / ahead.x; // along it, for each mm of the track
  slip.reference_speed = 0.5 * (state.speed * (1.0 - curvature * patch.reference_y) * travelled -
                                dot(cross(rolling, arm), ahead));
  const double slowest = wheelset.motion.standstill_speed;
  slip.slip_speed = sqrt(slip.reference_speed * slip.reference_speed + Real(slowest * slowest));
  const std::array<const Vector*, 3> axes{&patch.longitudinal, &patch.lateral, &patch.normal};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    slip.twist[i] = dot(velocity, *axes[i]) / slip.slip_speed;
    slip.twist[axes.size() + i] = dot(turning - rail_turning, *axes[i]) / slip.slip_speed;
  }
  return slip;
}

} // namespace

RigidSlip rigid_slip(const WheelsetMotion& wheelset, const ContactFrame& frame, double approach,
                     double ahead) {
  const Motion& motion = wheelset.motion;
  const Pose& pose = wheelset.pose;
  const Slip<double> slip =
      slip_of<double>({motion.speed, motion.lateral, motion.vertical, motion.roll,
                       wheelset.pitch_rate(), motion.yaw, pose.lateral, pose.roll, pose.yaw},
                      wheelset,
                      {frame.longitudinal,
                       frame.lateral,
                       frame.normal,
                       frame.origin - approach * frame.normal,
                       {0.0, pose.lateral, wheelset.height},
                       frame.origin.y,
                       ahead - approach * frame.normal.x});
  return {{slip.twist[0], slip.twist[1], slip.twist[5]},
          slip.twist,
          slip.reference_speed,
          slip.slip_speed};
}

RatedSlip rated_slip(const WheelsetMotion& wheelset, const MovingFrame& frame) {
  const Motion& motion = wheelset.motion;
  const Pose& pose = wheelset.pose;
  const auto variable = [](double value, StateVariable which) {
    return RatedByState::variable(value, static_cast<std::size_t>(which));
  };
  const Slip<RatedByState> slip = slip_of<RatedByState>(
      {variable(motion.speed, StateVariable::speed),
       variable(motion.lateral, StateVariable::lateral_velocity),
       variable(motion.vertical, StateVariable::vertical_velocity),
       variable(motion.roll, StateVariable::roll_rate),
       variable(wheelset.pitch_rate(), StateVariable::pitch_rate),
       variable(motion.yaw, StateVariable::yaw_rate),
       variable(pose.lateral, StateVariable::lateral), variable(pose.roll, StateVariable::roll),
       variable(pose.yaw, StateVariable::yaw)},
      wheelset,
      {frame.longitudinal, frame.lateral, frame.normal, frame.place, frame.centre,
       frame.reference_y, frame.ahead});
  return {slip.twist, slip.reference_speed, slip.slip_speed};
}

} // namespace wrc
