#include "patches/contact_frame.hpp"

#include <cmath>

namespace wrc {

Vector3 ContactFrame::to_track(double longitudinal_position, double lateral_position,
                               double normal_position) const {
  return origin + longitudinal_position * longitudinal + lateral_position * lateral +
         normal_position * normal;
}

double ContactFrame::angle() const {
  return std::atan2(lateral.z, std::hypot(lateral.x, lateral.y));
}

ContactFrame tangent_frame(Vector3 origin, double contact_angle) {
  const double sine = std::sin(contact_angle);
  const double cosine = std::cos(contact_angle);
  return {origin, {1.0, 0.0, 0.0}, {0.0, cosine, sine}, {0.0, -sine, cosine}, true};
}

ContactFrame vertical_frame(Vector3 origin, const Rotation& wheelset_rotation) {
  return {origin, wheelset_rotation.to_track({1.0, 0.0, 0.0}),
          wheelset_rotation.to_track({0.0, 1.0, 0.0}), wheelset_rotation.to_track({0.0, 0.0, 1.0})};
}

} // namespace wrc
