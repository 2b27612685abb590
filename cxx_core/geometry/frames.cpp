#include "geometry/frames.hpp"

#include <cmath>

namespace wrc {

Rotation::Rotation(const Pose& pose)
    : sin_yaw(std::sin(pose.yaw)), cos_yaw(std::cos(pose.yaw)), sin_roll(std::sin(pose.roll)),
      cos_roll(std::cos(pose.roll)) {}

} // namespace wrc
