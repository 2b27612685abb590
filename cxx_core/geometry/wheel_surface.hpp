/// The left wheel as a surface of revolution, and its contact locus under yaw and roll.
///
/// A point of the wheel in the wheelset frame is (rho sin t, L/2 + l1 + s, -rho cos t) with
/// rho = r0 + w(s), L the back-to-back distance and l1 the distance taping line - inner face.
/// The contact locus holds, for each s, the angle t at which the wheel's normal has no component
/// along the rail: only there can a rail that is prismatic along x touch the wheel. With the
/// normal (n_rho sin t, n_y, -n_rho cos t) rotated by Rz(yaw) Rx(roll) the condition is
///   A sin t - B cos t = C,  A = n_rho cos(yaw),  B = n_rho sin(yaw) sin(roll),
///   C = n_y sin(yaw) cos(roll),
/// which is closed form (compare Wang 1984, the "trace line" of the wheel, there without roll).
/// Units mm and rad; track frame of geometry/frames.hpp. Thread rule: immutable, safe to share.
#pragma once

#include <optional>

#include "geometry/curve_graph.hpp"
#include "geometry/frames.hpp"
#include "profile/profile.hpp"

namespace wrc {

struct WheelsetDimensions {
  double back_to_back = 1360.0;
  double tape_offset = 70.0; ///< taping line to inner face
  double radius = 460.0;     ///< rolling radius at the taping line
  bool operator==(const WheelsetDimensions&) const = default;
};

/// A point of the contact locus, with the wheelset's centre at height 0.
struct LocusPoint {
  Vector3 position;       ///< track frame
  double tangent_y = 1.0; ///< unit tangent in the y-z plane, towards the field side
  double tangent_z = 0.0;
  double lateral = 0.0;        ///< s on the wheel profile
  double height = 0.0;         ///< w on the wheel profile
  double wheel_angle = 0.0;    ///< t, rad, positive ahead of the axle
  double normal_curvature = 0; ///< of the wheel in its rolling direction, 1/mm
};

class WheelSurface {
public:
  /// Throws Error(invalid_argument) if the dimensions and the profile give radii that are not
  /// positive.
  WheelSurface(const Profile& profile, const WheelsetDimensions& dimensions);

  [[nodiscard]] const CurveGraph& graph() const { return graph_; }
  [[nodiscard]] double radius() const { return radius_; }
  /// Lateral coordinate of the taping line in the wheelset frame.
  [[nodiscard]] double taping_line() const { return taping_line_; }
  /// The locus at a place of the profile; none where the wheel is too steep for this yaw.
  [[nodiscard]] std::optional<LocusPoint> locus(const CurvePoint& profile_point, const Pose& pose,
                                                const Rotation& rotation) const;

private:
  CurveGraph graph_;
  double taping_line_;
  double radius_;
};

} // namespace wrc
