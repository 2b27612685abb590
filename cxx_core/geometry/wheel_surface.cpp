#include "geometry/wheel_surface.hpp"

#include <cmath>

#include "error.hpp"

namespace wrc {
namespace {

double seed_of_wheel(const Curve& curve) {
  // The piece that holds the taping line, s = 0, or the middle if the profile does not reach it.
  for (std::size_t piece = 0; piece < curve.piece_count(); ++piece) {
    const double length = curve.starts()[piece + 1] - curve.starts()[piece];
    if (curve.at(piece, 0.0).lateral <= 0.0 && curve.at(piece, length).lateral >= 0.0) {
      return curve.starts()[piece] + 0.5 * length;
    }
  }
  return 0.5 * curve.length();
}

} // namespace

WheelSurface::WheelSurface(const Profile& profile, const WheelsetDimensions& dimensions)
    : graph_(profile.curve, seed_of_wheel(profile.curve)),
      taping_line_(0.5 * dimensions.back_to_back + dimensions.tape_offset),
      radius_(dimensions.radius) {
  for (std::size_t piece = 0; piece < profile.curve.piece_count(); ++piece) {
    if (!(radius_ + profile.curve.at(piece, 0.0).height > 0.0)) {
      throw_invalid_argument("wheelset.radius", radius_,
                             "large enough that the whole wheel profile has a positive radius, mm");
    }
  }
}

std::optional<LocusPoint> WheelSurface::locus(const CurvePoint& profile_point, const Pose& pose,
                                              const Rotation& rotation) const {
  const double normal_radial = profile_point.tangent_lateral;
  const double normal_lateral = -profile_point.tangent_height;
  const double a = normal_radial * rotation.cos_yaw;
  const double b = normal_radial * rotation.sin_yaw * rotation.sin_roll;
  const double c = normal_lateral * rotation.sin_yaw * rotation.cos_roll;
  const double amplitude = std::sqrt(a * a + b * b);
  if (!(std::abs(c) < amplitude)) {
    return std::nullopt;
  }
  const double angle = std::asin(c / amplitude) + std::atan2(b, a);
  const double rho = radius_ + profile_point.height;
  const double sin_angle = std::sin(angle);
  const double cos_angle = std::cos(angle);
  LocusPoint point;
  point.position =
      rotation.to_track({rho * sin_angle, taping_line_ + profile_point.lateral, -rho * cos_angle});
  point.position.y += pose.lateral;
  const Vector3 normal =
      rotation.to_track({normal_radial * sin_angle, normal_lateral, -normal_radial * cos_angle});
  const double length = std::hypot(normal.y, normal.z);
  point.tangent_y = -normal.z / length;
  point.tangent_z = normal.y / length;
  point.lateral = profile_point.lateral;
  point.height = profile_point.height;
  point.wheel_angle = angle;
  point.normal_curvature = normal_radial / rho;
  return point;
}

} // namespace wrc
