#include "creep/rolling_frame.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace wrc {
namespace {

/// Signs of a force along x and y and a moment about z, or of slips and spin.
using Signs = std::array<double, 3>;

constexpr Signs mirror_signs(double mirror) {
  return {1.0, mirror, mirror};
}
constexpr Signs turn_signs(double turn) {
  return {turn, turn, 1.0};
}

Creepages times(const Signs& signs, const Creepages& creepages) {
  return {signs[0] * creepages.longitudinal, signs[1] * creepages.lateral,
          signs[2] * creepages.spin};
}

CreepForces times(const Signs& signs, const CreepForces& forces) {
  return {signs[0] * forces.longitudinal, signs[1] * forces.lateral, signs[2] * forces.spin_moment};
}

/// Derivatives of three by three, row by row.
std::array<double, 9> times_both(const Signs& signs, std::array<double, 9> by_creepage) {
  for (std::size_t row = 0; row < signs.size(); ++row) {
    for (std::size_t column = 0; column < signs.size(); ++column) {
      by_creepage[3 * row + column] *= signs[row] * signs[column];
    }
  }
  return by_creepage;
}

/// Turns the first three; the others are along the normal.
template <std::size_t count>
std::array<double, count> times(const Signs& signs, std::array<double, count> values) {
  for (std::size_t i = 0; i < signs.size(); ++i) {
    values[i] *= signs[i];
  }
  return values;
}

} // namespace

Creepages RollingFrame::mirrored(const Creepages& creepages) const {
  return times(mirror_signs(mirror()), creepages);
}

CreepForces RollingFrame::mirrored(const CreepForces& forces) const {
  return times(mirror_signs(mirror()), forces);
}

Stress RollingFrame::mirrored(Stress stress) const {
  for (const StressComponent component : {xy, yz}) {
    stress[component] *= mirror();
  }
  return stress;
}

Motion RollingFrame::mirrored(const Motion& motion) const {
  Motion other = motion;
  other.lateral = mirror() * motion.lateral;
  other.roll = mirror() * motion.roll;
  other.yaw = mirror() * motion.yaw;
  other.curvature = mirror() * motion.curvature;
  constexpr std::array<std::size_t, 3> lateral_roll_yaw{1, 3, 5};
  for (const std::size_t turning : lateral_roll_yaw) {
    other.acceleration[turning] = mirror() * motion.acceleration[turning];
  }
  return other;
}

RailDisplacement RollingFrame::mirrored(const RailDisplacement& displacement) const {
  return mirror() < 0.0 ? wrc::mirrored(displacement) : displacement;
}

CreepDerivatives RollingFrame::mirrored(CreepDerivatives derivatives) const {
  const Signs signs = mirror_signs(mirror());
  derivatives.by_creepage = times_both(signs, derivatives.by_creepage);
  derivatives.by_load = times(signs, derivatives.by_load);
  derivatives.by_friction = times(signs, derivatives.by_friction);
  return derivatives;
}

ForceRates RollingFrame::mirrored(const ForceRates& rates) const {
  const ByMotion<double> signs{mirror(), 1.0, mirror(), mirror()};
  return by_motion([&](std::size_t motion) {
    const auto& [force, moment] = rates[motion];
    return signs[motion] * WheelForce{mirrored(force), mirrored_moment(moment)};
  });
}

ForceJacobian RollingFrame::mirrored(ForceJacobian jacobian) const {
  const double m = mirror();
  const std::array<double, 6> rows{1.0, m, 1.0, m, 1.0, m}; // force x, y, z and moment x, y, z
  std::array<double, state_count> columns{};
  columns.fill(1.0);
  for (const StateVariable variable :
       {StateVariable::lateral, StateVariable::roll, StateVariable::yaw,
        StateVariable::lateral_velocity, StateVariable::roll_rate, StateVariable::yaw_rate}) {
    columns[static_cast<std::size_t>(variable)] = m;
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      jacobian[row][column] *= rows[row] * columns[column];
    }
  }
  return jacobian;
}

Creepages RollingFrame::turned(const Creepages& creepages) const {
  return times(turn_signs(turn_), creepages);
}

CreepForces RollingFrame::turned(const CreepForces& forces) const {
  return times(turn_signs(turn_), forces);
}

Grid RollingFrame::turned(Grid grid) const {
  if (backwards()) {
    grid.longitudinal_first = -grid.longitudinal(grid.longitudinal_count - 1);
    grid.lateral_first = -grid.lateral(grid.lateral_count - 1);
  }
  return grid;
}

std::vector<double> RollingFrame::turned_numbers(std::vector<double> field) const {
  if (backwards()) {
    std::reverse(field.begin(), field.end());
  }
  return field;
}

std::vector<double> RollingFrame::turned_components(std::vector<double> field) const {
  field = turned_numbers(std::move(field));
  for (double& component : field) {
    component *= turn_;
  }
  return field;
}

SlipField RollingFrame::turned(SlipField slip) const {
  return {turned_components(std::move(slip.x)), turned_components(std::move(slip.y))};
}

RollingSolution RollingFrame::turned(RollingSolution solution) const {
  if (!backwards()) {
    return solution;
  }
  for (auto* field : {&solution.traction_x, &solution.traction_y, &solution.slip_x,
                      &solution.slip_y, &solution.displacement_x, &solution.displacement_y}) {
    *field = turned_components(std::move(*field));
  }
  solution.normal_displacement = turned_numbers(std::move(solution.normal_displacement));
  const Signs signs = turn_signs(turn_);
  const CreepForces forces =
      times(signs,
            CreepForces{solution.longitudinal_force, solution.lateral_force, solution.spin_moment});
  solution.longitudinal_force = forces.longitudinal;
  solution.lateral_force = forces.lateral;
  solution.spin_moment = forces.spin_moment;
  solution.by_creepage = times_both(signs, solution.by_creepage);
  solution.weighted_by_creepage = times(signs, solution.weighted_by_creepage);
  for (std::array<double, 4>& rate : solution.by_rate) {
    rate = times(signs, rate);
  }
  return solution;
}

} // namespace wrc
