#include "derivatives/rail_jacobian.hpp"

#include <cmath>
#include <cstddef>

#include "creep/rolling_frame.hpp"
#include "records/wheel_result.hpp"

namespace wrc {

namespace {

using State = std::array<double, state_count>;

double& at(State& state, StateVariable variable) {
  return state[static_cast<std::size_t>(variable)];
}

} // namespace

std::array<State, rail_state_count> opposite_motions(const WheelDetails& details) {
  const Pose& pose = details.pose;
  const double across = pose.lateral - details.rail->origin_y();
  const double above = details.vertical - details.rail->origin_z();
  const double yaw_of_turn = -std::sin(pose.yaw) * std::tan(pose.roll);
  std::array<State, rail_state_count> motions{};
  auto& [lateral, height, roll, lateral_rate, height_rate, roll_rate] = motions;
  at(lateral, StateVariable::lateral) = -1.0;
  at(height, StateVariable::vertical) = -1.0;
  at(roll, StateVariable::lateral) = above;
  at(roll, StateVariable::vertical) = -across;
  at(roll, StateVariable::roll) = -std::cos(pose.yaw);
  at(roll, StateVariable::yaw) = yaw_of_turn;
  at(lateral_rate, StateVariable::lateral_velocity) = -1.0;
  at(height_rate, StateVariable::vertical_velocity) = -1.0;
  at(roll_rate, StateVariable::lateral_velocity) = above;
  at(roll_rate, StateVariable::vertical_velocity) = -across;
  at(roll_rate, StateVariable::roll_rate) = -std::cos(pose.yaw);
  at(roll_rate, StateVariable::pitch_rate) = std::sin(pose.yaw) / std::cos(pose.roll);
  at(roll_rate, StateVariable::yaw_rate) = yaw_of_turn;
  if (details.motion) {
    const Motion& motion = details.motion->motion;
    const RailDisplacement& rail = details.motion->rail_velocity;
    at(roll, StateVariable::lateral_velocity) = motion.vertical - rail.height;
    at(roll, StateVariable::vertical_velocity) = rail.lateral - motion.lateral;
    for (State* moved : {&lateral, &roll}) {
      at(*moved, StateVariable::speed) =
          motion.curvature * motion.speed * at(*moved, StateVariable::lateral);
    }
  }
  return motions;
}

RailJacobian rail_jacobian_of(const WheelResult& wheel, const ForceJacobian& jacobian) {
  const double m = wheel.details.mirror;
  const ForceJacobian inside = RollingFrame(m).mirrored(jacobian);
  const std::array<State, rail_state_count> motions = opposite_motions(wheel.details);
  const std::array<double, 6> row_signs{1.0, m, 1.0, m, 1.0, m};
  const std::array<double, rail_state_count> column_signs{m, 1.0, m, m, 1.0, m};
  RailJacobian result{};
  for (std::size_t row = 0; row < result.size(); ++row) {
    for (std::size_t column = 0; column < rail_state_count; ++column) {
      double sum = 0.0;
      for (std::size_t i = 0; i < state_count; ++i) {
        sum += inside[row][i] * motions[column][i];
      }
      result[row][column] = row_signs[row] * column_signs[column] * sum;
    }
  }
  if (wheel.total) { // e_x x F is the same seen in the mirror
    const auto& [force, moment] = *wheel.total;
    result[1][2] -= force.z;
    result[2][2] += force.y;
    result[4][2] -= moment.z;
    result[5][2] += moment.y;
  }
  return result;
}

} // namespace wrc
