#include "geometry/wheel_line.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/constants.hpp"

namespace wrc {
namespace {

/// Derivatives of theta = atan2(X, -Z) + pitch.
struct AngleRates {
  explicit AngleRates(const Vector3& point)
      : inverse_square(1.0 / (point.x * point.x + point.z * point.z)), x(-point.z * inverse_square),
        z(point.x * inverse_square), xx(-2.0 * x * z), xz(x * x - z * z) {}
  double inverse_square;
  double x;
  double z;
  double xx; ///< that by z twice is -xx
  double xz;
};

} // namespace

std::optional<double> WheelLine::meet(const Vector3& from, const Vector3& direction,
                                      double enough) {
  // Start: where the line enters the cylinder of the radius last met.
  const double radius = wheel_.radius() + height_;
  const double a = direction.x * direction.x + direction.z * direction.z;
  const double b = from.x * direction.x + from.z * direction.z;
  const double c = from.x * from.x + (from.z - radius) * (from.z + radius);
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0)) {
    return std::nullopt;
  }
  double position = (-b - std::sqrt(discriminant)) / a;
  double largest_step = longest_newton_step;
  for (int iteration = 0; iteration < max_newton_steps; ++iteration) {
    const Vector3 body = from + position * direction;
    lateral_ = body.y;
    const std::optional<GraphPoint> profile = wheel_.over(body);
    if (!profile) {
      return std::nullopt;
    }
    const double rho = wheel_.radius() + profile->height;
    double derivative = body.x * direction.x + body.z * direction.z;
    if (is_round_) {
      derivative -= rho * profile->by_lateral * direction.y;
    } else {
      const AngleRates theta(body);
      derivative -= rho * (profile->by_lateral * direction.y +
                           profile->by_along * (theta.x * direction.x + theta.z * direction.z));
    }
    const double excess = 0.5 * (body.x * body.x + (body.z - rho) * (body.z + rho));
    if (!(derivative < -min_facing_cosine * rho)) {
      return std::nullopt;
    }
    const double step = std::clamp(-excess / derivative, -largest_step, largest_step);
    const bool at_step =
        iteration + 1 == max_newton_steps && std::abs(excess) <= step_tolerance * rho;
    const bool is_enough = std::abs(step) < enough;
    if (std::abs(step) <= ray_tolerance || at_step || is_enough) {
      if (is_round_ && !wheel_.graph().heights().covers(lateral_)) {
        return std::nullopt;
      }
      height_ = profile->height;
      profile_ = *profile;
      return is_enough ? position + step : position;
    }
    position += step;
    if (iteration > free_newton_steps) {
      largest_step *= 0.5;
    }
  }
  return std::nullopt;
}

Vector3 WheelLine::gradient(const Vector3& point, const GraphPoint& profile) const {
  const double rho = wheel_.radius() + profile.height;
  const AngleRates theta(point);
  return {point.x - rho * profile.by_along * theta.x, -rho * profile.by_lateral,
          point.z - rho * profile.by_along * theta.z};
}

SecondDerivatives WheelLine::second_derivatives(const Vector3& point,
                                                const GraphPoint& profile) const {
  const double rho = wheel_.radius() + profile.height;
  // Of rho^2/2.
  const double by_angle = rho * profile.by_along;
  const double by_angle2 = profile.by_along * profile.by_along + rho * profile.by_along2;
  const double by_both = profile.by_along * profile.by_lateral + rho * profile.by_along_lateral;
  const double by_lateral2 = profile.by_lateral * profile.by_lateral + rho * profile.by_lateral2;
  const AngleRates theta(point);
  return {1.0 - by_angle2 * theta.x * theta.x - by_angle * theta.xx,
          -by_both * theta.x,
          -by_angle2 * theta.x * theta.z - by_angle * theta.xz,
          -by_lateral2,
          -by_both * theta.z,
          1.0 - by_angle2 * theta.z * theta.z + by_angle * theta.xx};
}

} // namespace wrc
