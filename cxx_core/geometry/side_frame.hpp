/// Signs between the track frame and the left-hand frame of a side.
///
/// On the left both are the same; on the right each is the mirror image y -> -y of the other
/// (geometry/frames.hpp). Vectors, such as places and forces, change the sign of y; moments and
/// turnings that of x and z; components across a patch's plane, and angles about x, their own.
/// The mirror is its own inverse: `mirrored` converts both ways. Units: any. Thread rule: plain
/// values.
#pragma once

#include "geometry/frames.hpp"

namespace wrc {

class SideFrame {
public:
  SideFrame() = default;
  /// `mirror`: 1 on the left, -1 on the right (WheelDetails).
  explicit SideFrame(double mirror) : mirror_(mirror) {}

  [[nodiscard]] double mirror() const { return mirror_; }
  [[nodiscard]] Vector3 mirrored(const Vector3& vector) const {
    return {vector.x, mirror_ * vector.y, vector.z};
  }
  [[nodiscard]] Vector3 mirrored_moment(const Vector3& moment) const {
    return {mirror_ * moment.x, moment.y, mirror_ * moment.z};
  }
  /// A component across, or an angle about x.
  [[nodiscard]] double mirrored_lateral(double component) const { return mirror_ * component; }

private:
  double mirror_ = 1.0;
};

} // namespace wrc
