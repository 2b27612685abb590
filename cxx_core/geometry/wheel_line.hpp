/// Where a straight line meets a wheel, by Newton's method from the height met last.
///
/// In the wheelset's frame, with Y counted from the taping line, the wheel is
///   F = (X^2 + Z^2 - rho^2)/2 = 0,  rho = r0 + w(Y, theta),  theta = atan2(X, -Z) + pitch,
/// w without theta of a round wheel. The form X^2 + (Z - rho)(Z + rho) does not cancel,
/// and needs no root. At a kink or a step of the profile steps are halved after a while, and a
/// point within the step is accepted.
/// Units mm and rad. Not covered: parts of the profile that overhang. Thread rule: one object, one
/// thread.
#pragma once

#include <optional>

#include "geometry/frames.hpp"
#include "geometry/wheel_surface.hpp"

namespace wrc {

/// Symmetric second derivatives in space.
struct SecondDerivatives {
  double xx = 0.0;
  double xy = 0.0;
  double xz = 0.0;
  double yy = 0.0;
  double yz = 0.0;
  double zz = 0.0;
};

class WheelLine {
public:
  /// The wheel must outlive the line. It starts from a height of its profile.
  WheelLine(const WheelSurface& wheel, double height)
      : wheel_(wheel), is_round_(wheel.is_prismatic_along(along_track)), height_(height) {}

  /// Position along a line from `from` at which it meets the wheel from below; none where it does
  /// not. The next line starts from there. Newton's method ends with a step shorter than `enough`,
  /// or with one of ray_tolerance.
  std::optional<double> meet(const Vector3& from, const Vector3& direction, double enough = 0.0);
  void start_from(double height) { height_ = height; }

  /// Position on the wheel's profile where the last line met it, and the profile there.
  [[nodiscard]] double lateral() const { return lateral_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] const GraphPoint& profile() const { return profile_; }
  /// Derivatives of F at a point of the wheel, whose profile may be known.
  [[nodiscard]] Vector3 gradient(const Vector3& point) const {
    return gradient(point, wheel_.over(point).value_or(GraphPoint{}));
  }
  [[nodiscard]] Vector3 gradient(const Vector3& point, const GraphPoint& profile) const;
  [[nodiscard]] SecondDerivatives second_derivatives(const Vector3& point,
                                                     const GraphPoint& profile) const;

private:
  const WheelSurface& wheel_;
  const bool is_round_;
  double lateral_ = 0.0;
  double height_;
  GraphPoint profile_;
};

} // namespace wrc
