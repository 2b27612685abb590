#include "patches/contact_frame.hpp"

#include <cmath>

namespace wrc {

Vector3 ContactFrame::to_track(double longitudinal_position, double lateral_position,
                               double normal_position) const {
  const Row row = row_at(lateral_position);
  return origin + longitudinal_position * longitudinal + row.place + normal_position * row.normal;
}

ContactFrame::Row ContactFrame::row_at(double lateral_position) const {
  if (!curve) {
    return {lateral_position * lateral, lateral, normal};
  }
  const ContactCurve::Point point = curve->at(lateral_position);
  return {point.lateral * lateral + point.height * normal,
          point.cosine * lateral + point.sine * normal,
          point.cosine * normal - point.sine * lateral};
}

double ContactFrame::lateral_of(const Vector3& from_origin) const {
  const double across = dot(from_origin, lateral);
  return curve ? curve->arc_over(across) : across;
}

ContactFrame ContactFrame::seen_from(const Vector3& new_origin) const {
  ContactFrame frame = *this;
  const Vector3 moved = new_origin - origin;
  frame.origin = new_origin;
  if (curve) {
    frame.curve = std::make_shared<const ContactCurve>(
        curve->seen_from(dot(moved, lateral), dot(moved, normal)));
  }
  return frame;
}

std::vector<double> row_angles(const ContactFrame& frame, const Grid& grid) {
  std::vector<double> angles;
  for (std::size_t row = 0; frame.curve && row < grid.lateral_count; ++row) {
    const ContactCurve::Point point = frame.curve->at(grid.lateral(row));
    angles.push_back(std::atan2(point.sine, point.cosine));
  }
  return angles;
}

double ContactFrame::angle() const {
  return tangent ? std::atan2(-normal.y, normal.z)
                 : std::atan2(lateral.z, std::hypot(lateral.x, lateral.y));
}

ContactFrame tangent_frame(Vector3 origin, double contact_angle, double rise) {
  const double sine = std::sin(contact_angle);
  const double cosine = std::cos(contact_angle);
  ContactFrame frame{origin, {1.0, 0.0, 0.0}, {0.0, cosine, sine}, {0.0, -sine, cosine}, true};
  if (rise != 0.0) {
    const double level = 1.0 / std::sqrt(1.0 + rise * rise);
    frame.normal = level * (frame.normal - rise * frame.longitudinal);
    const double reach = std::hypot(cosine, rise);
    frame.longitudinal = {cosine / reach, 0.0, rise / reach};
    frame.lateral = cross(frame.normal, frame.longitudinal);
  }
  return frame;
}

ContactFrame vertical_frame(Vector3 origin, const Rotation& wheelset_rotation) {
  return {origin, wheelset_rotation.to_track({1.0, 0.0, 0.0}),
          wheelset_rotation.to_track({0.0, 1.0, 0.0}), wheelset_rotation.to_track({0.0, 0.0, 1.0})};
}

} // namespace wrc
