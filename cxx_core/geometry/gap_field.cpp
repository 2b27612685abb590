#include "geometry/gap_field.hpp"

#include <cmath>
#include <limits>

#include "geometry/constants.hpp"

namespace wrc {

GapField::GapField(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose)
    : wheel_(wheel), rotation_(pose), lateral_(pose.lateral), wheel_line_(wheel, 0.0),
      rail_line_(rail) {}

void GapField::restart() {
  wheel_line_.start_from(0.0);
  rail_line_.restart();
}

std::optional<double> GapField::wheel_at(double x, double y, Vector3& met, double enough) {
  Vector3 from = rotation_.to_body({x, y - lateral_, 0.0});
  from.y -= wheel_.taping_line();
  const Vector3 up = rotation_.to_body({0.0, 0.0, 1.0});
  const auto position = wheel_line_.meet(from, up, enough);
  if (position) {
    met = from + *position * up;
  }
  return position;
}

void GapField::scan(double x, std::span<const double> rows, std::span<double> gaps) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  rail_line_.heights(x, rows, gaps);
  wheel_line_.start_from(0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Vector3 met;
    const auto wheel = gaps[i] > -nowhere ? wheel_at(x, rows[i], met, scan_step) : std::nullopt;
    gaps[i] = wheel ? *wheel - gaps[i] : nowhere;
  }
}

std::optional<GapPoint> GapField::at(double x, double y) {
  const auto rail = rail_line_.height(x, y);
  if (!rail) {
    return std::nullopt;
  }
  Vector3 met;
  const auto position = wheel_at(x, y, met);
  if (!position) {
    return std::nullopt;
  }
  const Vector3 up = rotation_.to_body({0.0, 0.0, 1.0});
  const Vector3 gradient = wheel_line_.gradient(met, wheel_line_.profile());
  const SecondDerivatives second = wheel_line_.second_derivatives(met, wheel_line_.profile());
  const auto twice = [&](const Vector3& a, const Vector3& b) {
    return a.x * (second.xx * b.x + second.xy * b.y + second.xz * b.z) +
           a.y * (second.xy * b.x + second.yy * b.y + second.yz * b.z) +
           a.z * (second.xz * b.x + second.yz * b.y + second.zz * b.z);
  };
  const double facing = 1.0 / dot(gradient, up);
  const Vector3 x_axis = rotation_.to_body({1.0, 0.0, 0.0});
  const Vector3 y_axis = rotation_.to_body({0.0, 1.0, 0.0});
  Graph wheel;
  wheel.value = *position;
  wheel.x = -dot(gradient, x_axis) * facing;
  wheel.y = -dot(gradient, y_axis) * facing;
  // Tangents of the surface.
  const Vector3 along = x_axis + wheel.x * up;
  const Vector3 across = y_axis + wheel.y * up;
  wheel.xx = -twice(along, along) * facing;
  wheel.xy = -twice(along, across) * facing;
  wheel.yy = -twice(across, across) * facing;
  GapPoint point;
  point.rail = {rail->height,    rail->by_along,         rail->by_lateral,
                rail->by_along2, rail->by_along_lateral, rail->by_lateral2};
  point.gap = {wheel.value - point.rail.value, wheel.x - point.rail.x,   wheel.y - point.rail.y,
               wheel.xx - point.rail.xx,       wheel.xy - point.rail.xy, wheel.yy - point.rail.yy};
  point.wheel_lateral = wheel_line_.lateral();
  point.wheel_height = wheel_line_.height();
  point.wheel_angle = std::atan2(met.x, -met.z);
  return point;
}

} // namespace wrc
