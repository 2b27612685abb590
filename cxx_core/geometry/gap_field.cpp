#include "geometry/gap_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc {

GapField::GapField(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose)
    : wheel_(wheel), rail_(rail), rotation_(pose), lateral_(pose.lateral), wheel_line_(wheel, 0.0) {
  if (rail.varying() != nullptr) {
    rail_line_.emplace(rail);
  }
}

void GapField::restart() {
  wheel_line_.start_from(0.0);
  if (rail_line_) {
    rail_line_->restart();
  }
}

std::optional<Graph> GapField::rail_at(double x, double y) {
  if (!rail_line_) {
    const HeightFunction& heights = rail_.graph().heights();
    if (!heights.covers(y)) {
      return std::nullopt;
    }
    const HeightPoint point = heights.at(y);
    return Graph{point.height, 0.0, point.slope, 0.0, 0.0, point.second};
  }
  const auto height = rail_line_->meet({x, y, 0.0}, {0.0, 0.0, 1.0});
  if (!height) {
    return std::nullopt;
  }
  const GraphPoint& point = rail_line_->graph();
  return Graph{*height,         point.by_along,         point.by_lateral,
               point.by_along2, point.by_along_lateral, point.by_lateral2};
}

std::optional<double> GapField::wheel_at(double x, double y, Vector3& met) {
  Vector3 from = rotation_.to_body({x, y - lateral_, 0.0});
  from.y -= wheel_.taping_line();
  const Vector3 up = rotation_.to_body({0.0, 0.0, 1.0});
  const auto position = wheel_line_.meet(from, up);
  if (position) {
    met = from + *position * up;
  }
  return position;
}

void GapField::scan(double x, std::span<const double> rows, std::span<double> gaps) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  if (rail_line_) {
    laterals_.resize(rows.size());
    double height = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rail_.to_profile_frame(rows[i], 0.0, laterals_[i], height);
    }
    std::ranges::fill(gaps, none);
    for (const SurfaceSheet& sheet : rail_.varying()->sheets()) {
      sheet.raise_to(rail_.along() + x, laterals_, gaps);
    }
  }
  const double sine = std::sin(rail_.angle());
  const double cosine = std::cos(rail_.angle());
  wheel_line_.start_from(0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& heights = rail_.graph().heights();
    const double rail = rail_line_ ? sine * laterals_[i] + cosine * gaps[i] + rail_.origin_z()
                        : heights.covers(rows[i]) ? heights.at(rows[i]).height
                                                  : none;
    Vector3 met;
    const auto wheel = rail > none ? wheel_at(x, rows[i], met) : std::nullopt;
    gaps[i] = wheel ? *wheel - rail : -none;
  }
}

std::optional<GapPoint> GapField::at(double x, double y) {
  const auto rail = rail_at(x, y);
  if (!rail) {
    return std::nullopt;
  }
  Vector3 met;
  const auto position = wheel_at(x, y, met);
  if (!position) {
    return std::nullopt;
  }
  const Vector3 up = rotation_.to_body({0.0, 0.0, 1.0});
  const Vector3 gradient = wheel_line_.gradient(met);
  const SecondDerivatives second = wheel_line_.second_derivatives(met);
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
  point.rail = *rail;
  point.gap = {wheel.value - rail->value, wheel.x - rail->x,   wheel.y - rail->y,
               wheel.xx - rail->xx,       wheel.xy - rail->xy, wheel.yy - rail->yy};
  point.wheel_lateral = wheel_line_.lateral();
  point.wheel_height = wheel_line_.height();
  point.wheel_angle = std::atan2(met.x, -met.z);
  return point;
}

} // namespace wrc
