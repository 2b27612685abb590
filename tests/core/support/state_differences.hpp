/// Positions and velocities of a scene, and how the forces on a wheel change with them, by central
/// differences of whole scenes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "creep/total_force.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test {

/// Distance of the contacts from the wheelset's centre, mm: moments count over it.
inline constexpr double contact_arm = 750.0;

/// Forces, and moments over the arm, N.
using ForceColumn = std::array<double, 6>;

/// Of a scene with prescribed position and motion, pitch rate included.
inline double& state_of(Scene& scene, std::size_t which) {
  Motion& motion = *scene.motion;
  switch (static_cast<StateVariable>(which)) {
  case StateVariable::lateral:
    return scene.lateral;
  case StateVariable::vertical:
    return *scene.vertical;
  case StateVariable::roll:
    return *scene.roll;
  case StateVariable::yaw:
    return scene.yaw;
  case StateVariable::speed:
    return motion.speed;
  case StateVariable::lateral_velocity:
    return motion.lateral;
  case StateVariable::vertical_velocity:
    return motion.vertical;
  case StateVariable::roll_rate:
    return motion.roll;
  case StateVariable::pitch_rate:
    return *motion.pitch;
  default:
    return motion.yaw;
  }
}

/// Long enough for changes to stand out of what grids and iterations leave, short against what
/// changes the slopes.
inline double step_of(const Scene& scene, std::size_t which) {
  const double slow = 1e-4 * std::abs(scene.motion->speed);
  const std::array<double, state_count> steps{0.01,
                                              0.002,
                                              1e-5,
                                              1e-5,
                                              slow,
                                              slow,
                                              slow,
                                              slow / contact_arm,
                                              slow / scene.left.radius,
                                              slow / contact_arm};
  return steps.at(which);
}

inline ForceColumn force_column(const WheelResult& wheel) {
  const WheelForce total = total_force(wheel);
  const double share = 1.0 / contact_arm;
  return {total.force.x,          total.force.y,          total.force.z,
          share * total.moment.x, share * total.moment.y, share * total.moment.z};
}

/// Over a share of the usual step.
inline ForceColumn difference_by(const Scene& scene, std::size_t which,
                                 std::optional<SceneWheel> SceneResult::*side, double share = 1.0) {
  const double step = share * step_of(scene, which);
  const auto forces = [&](double sign) {
    Scene moved = scene;
    state_of(moved, which) += sign * step;
    return force_column(*(solve_scene(moved).*side));
  };
  const ForceColumn ahead = forces(1.0);
  const ForceColumn behind = forces(-1.0);
  ForceColumn rate{};
  for (std::size_t row = 0; row < rate.size(); ++row) {
    rate[row] = (ahead[row] - behind[row]) / (2.0 * step);
  }
  return rate;
}

inline ForceColumn column_of(const ForceJacobian& jacobian, std::size_t which) {
  ForceColumn column{};
  for (std::size_t row = 0; row < column.size(); ++row) {
    column[row] = jacobian[row][which] / (row < 3 ? 1.0 : contact_arm);
  }
  return column;
}

/// Largest difference of a column from another one, over its largest entry.
inline double column_error(const ForceColumn& found, const ForceColumn& expected) {
  double apart = 0.0;
  double largest = 0.0;
  for (std::size_t row = 0; row < expected.size(); ++row) {
    apart = std::max(apart, std::abs(found[row] - expected[row]));
    largest = std::max(largest, std::abs(expected[row]));
  }
  return apart / largest;
}

inline double column_error(const ForceJacobian& jacobian, std::size_t which,
                           const ForceColumn& expected) {
  return column_error(column_of(jacobian, which), expected);
}

} // namespace wrc::test
