/// A run over irregular track: hunting, with irregularities and changing loads of other wavelengths
/// on top, so that no step resembles the one before.
///
/// Steps of 40 mm, 1 ms at 40 m/s. The velocities are those of the path. Track frame, mm, rad, N,
/// s. Thread rule: pure functions.
#pragma once

#include <array>

namespace driver {

struct ServiceStep {
  double lateral = 0.0;
  double yaw = 0.0;
  std::array<double, 2> load{}; ///< of the left and the right wheel
  double speed = 0.0;
  double lateral_velocity = 0.0;
  double yaw_velocity = 0.0;
};

ServiceStep service_step(int index);

/// As keys of a scene, of loads and pose only.
template <class Scene> void set_pose(const ServiceStep& step, Scene& scene) {
  scene.set("pose.lateral", step.lateral);
  scene.set("pose.yaw", step.yaw);
  scene.set("load.left", step.load[0]);
  scene.set("load.right", step.load[1]);
}

template <class Scene> void set_motion(const ServiceStep& step, Scene& scene) {
  scene.set("motion.speed", step.speed);
  scene.set("motion.lateral", step.lateral_velocity);
  scene.set("motion.yaw", step.yaw_velocity);
}

} // namespace driver
