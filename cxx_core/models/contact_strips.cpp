#include "models/contact_strips.hpp"

namespace wrc {

std::optional<ContactStrip> ContactStrips::at(double s) const {
  const HeightFunction& profile = wheel_.graph().heights();
  if (!profile.covers(s)) {
    return std::nullopt;
  }
  const HeightPoint wheel = profile.at(s);
  bool exists = false;
  const LocusAngle angle = pose_.angle_at(wheel.slope, exists);
  if (!exists) {
    return std::nullopt;
  }
  const double rho = wheel_.radius() + wheel.height;
  const double turning =
      pose_.along * wheel.second / (pose_.a * angle.cosine + pose_.b * angle.sine);
  const Rotation& rotation = pose_.rotation;
  ContactStrip strip;
  strip.s = s;
  const Vector3 position =
      rotation.to_track({rho * angle.sine, wheel_.taping_line() + s, -rho * angle.cosine});
  const double y = position.y + pose_.lateral;
  const HeightFunction& crown = rail_.graph().heights();
  if (!crown.covers(y)) {
    return std::nullopt;
  }
  const HeightPoint rail = crown.at(y);
  strip.rail = {position.x, y, rail.height};
  strip.distance = position.z - rail.height;
  strip.rail_slope = rail.slope;
  const Vector3 rate =
      rotation.to_track({wheel.slope * angle.sine + rho * angle.cosine * turning, 1.0,
                         rho * angle.sine * turning - wheel.slope * angle.cosine});
  strip.longitudinal_rate = rate.x;
  strip.lateral_rate = rate.y;
  const Vector3 normal = rotation.to_track({angle.sine, -wheel.slope, -angle.cosine});
  const Vector3 normal_rate =
      rotation.to_track({angle.cosine * turning, -wheel.second, angle.sine * turning});
  const double normal_square = normal.y * normal.y + normal.z * normal.z;
  const double outline_curvature = (normal.y * normal_rate.z - normal.z * normal_rate.y) /
                                   (normal_square * std::sqrt(rate.y * rate.y + rate.z * rate.z));
  const double rail_square = 1.0 + rail.slope * rail.slope;
  strip.lateral_curvature =
      outline_curvature - rail.second / (rail_square * std::sqrt(rail_square));
  // Euler: the rail's direction lies between the wheel's rolling direction and its profile's.
  const double profile_square = 1.0 + wheel.slope * wheel.slope;
  const double rolling_curvature = 1.0 / (rho * std::sqrt(profile_square));
  const double profile_curvature = -wheel.second / (profile_square * std::sqrt(profile_square));
  const double cosine = rotation.to_track({angle.cosine, 0.0, angle.sine}).x;
  const double cosine_square = cosine * cosine;
  strip.longitudinal_curvature =
      cosine_square * rolling_curvature + (1.0 - cosine_square) * profile_curvature;
  if (!(strip.longitudinal_curvature > 0.0)) {
    return std::nullopt;
  }
  return strip;
}

} // namespace wrc
