#include "geometry/frames.hpp"

#include <cmath>

namespace wrc {

Rotation::Rotation(const Pose& pose)
    : sin_yaw(std::sin(pose.yaw)), cos_yaw(std::cos(pose.yaw)), sin_roll(std::sin(pose.roll)),
      cos_roll(std::cos(pose.roll)) {}

Vector3 Rotation::to_track(Vector3 body) const {
  const double y = cos_roll * body.y - sin_roll * body.z;
  const double z = sin_roll * body.y + cos_roll * body.z;
  return {cos_yaw * body.x - sin_yaw * y, sin_yaw * body.x + cos_yaw * y, z};
}

Vector3 Rotation::to_body(Vector3 track) const {
  const double x = cos_yaw * track.x + sin_yaw * track.y;
  const double y = cos_yaw * track.y - sin_yaw * track.x;
  return {x, cos_roll * y + sin_roll * track.z, cos_roll * track.z - sin_roll * y};
}

} // namespace wrc
