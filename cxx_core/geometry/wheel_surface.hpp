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
/// Divided by n_rho, with the profile's slope m = w'(s) and c = -m sin(yaw) cos(roll):
///   a = cos(yaw), b = sin(yaw) sin(roll), D = a^2 + b^2, r = sqrt(D - c^2),
///   sin t = (a c + b r) / D, cos t = (a r - b c) / D,
/// so that no angle has to be known; c^2 >= D is a wheel too steep for this yaw.
/// Units mm and rad; track frame of geometry/frames.hpp. Thread rule: immutable, safe to share.
/// At a ridge of the profile the locus runs along it under yaw, from the angle t of one flank to
/// that of the other: it is one point of the profile with all slopes in between.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/curve_graph.hpp"
#include "geometry/frames.hpp"
#include "geometry/sliced_surface.hpp"
#include "profile/profile.hpp"

namespace wrc {

struct WheelsetDimensions {
  double back_to_back = 1360.0;
  double tape_offset = 70.0; ///< taping line to inner face
  double radius = 460.0;     ///< rolling radius at the taping line
  bool operator==(const WheelsetDimensions&) const = default;
};

/// A point of the contact locus, with the wheelset's centre at height 0.
struct LocusPlace {
  Vector3 position;            ///< track frame
  double lateral = 0.0;        ///< s on the wheel profile
  double normal_curvature = 0; ///< of the wheel in its rolling direction, 1/mm
};

/// A point of the contact locus with all that is known of it.
struct LocusPoint : LocusPlace {
  double tangent_y = 1.0; ///< unit tangent in the y-z plane, towards the field side
  double tangent_z = 0.0;
  double height = 0.0;      ///< w on the wheel profile
  double wheel_angle = 0.0; ///< t, rad, positive ahead of the axle

  [[nodiscard]] double slope() const { return tangent_z / tangent_y; }
};

/// The angle t of the locus.
struct LocusAngle {
  double sine;
  double cosine;
};

/// What the contact locus needs of a pose, taken once.
struct LocusPose {
  explicit LocusPose(const Pose& pose) : LocusPose(pose, Rotation(pose)) {}
  LocusPose(const Pose& pose, const Rotation& rotation_of_pose);

  /// Angle at a point with this slope of the profile; `exists`: whether there is one.
  [[nodiscard]] LocusAngle angle_at(double slope, bool& exists) const {
    const double c = slope * along;
    const double square = amplitude_square - c * c;
    exists = square > 0.0;
    const double root = std::sqrt(exists ? square : 0.0);
    return {(a * c + b * root) * inverse_square, (a * root - b * c) * inverse_square};
  }

  /// dz/dy of the wheel there, at a place x.
  [[nodiscard]] double slope_at(double slope) const {
    bool exists = false;
    const LocusAngle angle = angle_at(slope, exists);
    const Vector3 normal = rotation.to_track({angle.sine, -slope, -angle.cosine});
    return -normal.y / normal.z;
  }

  Rotation rotation;
  double lateral;
  double a;
  double b;
  double along; ///< c of a slope of 1
  double amplitude_square;
  double inverse_square;
};

/// The nodes of a wheel's profile curve, from flange to field side, as arrays.
struct ProfileNodes {
  std::vector<double> lateral; ///< s
  std::vector<double> height;  ///< w
  std::vector<double> slope;   ///< w', towards the field side
};

/// A node at which the profile turns away from the rail.
struct Ridge {
  std::size_t node = 0;
  double slope_before = 0.0; ///< w' of the flank on its flange side
};

class WheelSurface {
public:
  /// Throws Error(invalid_argument) if the dimensions and the profile give radii that are not
  /// positive.
  WheelSurface(const Profile& profile, const WheelsetDimensions& dimensions);
  /// A wheel through slices, made with the radius of the dimensions, turned by a pitch in rad: the
  /// angle theta of its slices that then points down. The graph is the section there.
  WheelSurface(std::shared_ptr<const SlicedSurface> slices, const WheelsetDimensions& dimensions,
               double pitch);

  /// Whether what the rail meets of it stays the same as it rolls in a direction.
  [[nodiscard]] bool is_prismatic_along(const Vector3& direction) const {
    return slices_ == nullptr && direction.y == 0.0 && direction.z == 0.0;
  }
  /// The same wheel turned to a pitch.
  [[nodiscard]] WheelSurface turned(double pitch) const;
  /// The angle of the wheel to both sides of the one that points down, beyond which a rail cannot
  /// touch it; `rise`: by how much wheel and rail are closer there, `varies`: whether the other
  /// body varies, whose slopes move contact. Infinite for large yaws.
  [[nodiscard]] double touch_angle(double yaw, double rise, bool varies) const;
  /// Slope along the track that it has at most where it touches a rail which does not vary.
  [[nodiscard]] double touch_slope(double yaw) const;
  /// The round wheel that a rail meets at a pitch; none where it varies within `touch_angle`.
  [[nodiscard]] std::shared_ptr<const WheelSurface> round_at(double pitch, double yaw,
                                                             bool rail_varies) const;
  /// The round wheel with the section that points down.
  [[nodiscard]] WheelSurface as_round() const;
  /// The profile at a point in the wheelset's frame, Y counted from the taping line: height over
  /// (theta, lateral). None beside the parts of a wheel; one without parts is clamped.
  [[nodiscard]] std::optional<GraphPoint> over(const Vector3& point) const;
  /// The end of a part around the wheel that is nearest to a point x ahead of the axle: its theta,
  /// and how far it is on the circumference; none of a wheel without ends.
  [[nodiscard]] std::optional<PartEnd> nearest_end(double x) const;
  [[nodiscard]] const CurveGraph& graph() const { return graph_; }
  [[nodiscard]] double radius() const { return radius_; }
  /// Lateral coordinate of the taping line in the wheelset frame.
  [[nodiscard]] double taping_line() const { return taping_line_; }
  /// The locus at a point of the profile whose angle is known.
  [[nodiscard]] LocusPoint locus(const CurvePoint& profile_point, const LocusAngle& angle,
                                 const LocusPose& pose) const;
  /// The nodes of the graph: piece i of the graph runs from node i to node i + 1.
  [[nodiscard]] const ProfileNodes& nodes() const { return nodes_; }
  /// From flange to field side.
  [[nodiscard]] const std::vector<Ridge>& ridges() const { return ridges_; }
  /// Largest radius of the graph's nodes.
  [[nodiscard]] double largest_radius() const { return largest_radius_; }

private:
  WheelSurface(const Curve& profile, const WheelsetDimensions& dimensions);

  CurveGraph graph_;
  double taping_line_;
  double radius_;
  double largest_radius_ = 0.0;
  ProfileNodes nodes_;
  std::vector<Ridge> ridges_;
  WheelsetDimensions dimensions_;
  std::shared_ptr<const SlicedSurface> slices_; ///< none: round
  double pitch_ = 0.0;
  struct RoundStretch {
    ConstantStretch where;
    std::shared_ptr<const WheelSurface> wheel;
  };
  std::shared_ptr<const std::vector<RoundStretch>> round_; ///< where slices are the same
};

inline std::optional<GraphPoint> WheelSurface::over(const Vector3& point) const {
  if (slices_ != nullptr) {
    return slices_->over(pitch_ + std::atan2(point.x, -point.z), point.y);
  }
  const HeightPoint section = graph_.heights().at(point.y);
  GraphPoint profile;
  profile.height = section.height;
  profile.by_lateral = section.slope;
  profile.by_lateral2 = section.second;
  return profile;
}

/// The wheel turned to a pitch, as a rail meets it under a yaw: a round one where that is all it
/// meets.
std::shared_ptr<const WheelSurface> turned(const std::shared_ptr<const WheelSurface>& wheel,
                                           double pitch, double yaw, bool rail_varies);

} // namespace wrc
