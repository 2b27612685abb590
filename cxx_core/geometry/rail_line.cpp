#include "geometry/rail_line.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/constants.hpp"

namespace wrc {
namespace {

/// Searches for the point over which an inclined rail's highest point lies.
/// origin: bound: the height changes the lateral place by the sine of the cant alone.
constexpr int inclined_steps = 3;
/// Steps along an edge of a sheet, after which a line passes beside it.
/// origin: reasoned: lines that meet the edge itself turn back at once.
constexpr int edge_steps = 4;

} // namespace

RailLine::RailLine(const RailSurface& rail)
    : rail_(rail), cosine_(std::cos(rail.angle())), sine_(std::sin(rail.angle())) {}

SheetPoint RailLine::placed(const SurfaceSheet& sheet, double across, double x) const {
  SheetPoint point = sheet.at(across, rail_.along() + x);
  const auto turn = [this](Position& vector) {
    vector = {cosine_ * vector[0] - sine_ * vector[1], sine_ * vector[0] + cosine_ * vector[1]};
  };
  for (Position* vector : {&point.at, &point.across, &point.along, &point.across2,
                           &point.across_along, &point.along2}) {
    turn(*vector);
  }
  point.at[0] += rail_.origin_y();
  point.at[1] += rail_.origin_z();
  return point;
}

std::optional<double> RailLine::newton(std::size_t index, Start from, const Vector3& base,
                                       const Vector3& direction) {
  const SurfaceSheet& sheet = rail_.varying()->sheets()[index];
  const Stretch across = sheet.across();
  const Stretch along = sheet.along();
  double largest_step = first_ray_step;
  int at_edge = 0;
  for (int iteration = 0; iteration < max_newton_steps; ++iteration) {
    const SheetPoint point = placed(sheet, from.across, from.along);
    const Vector3 by_across{0.0, point.across[0], point.across[1]};
    const Vector3 by_along{1.0, point.along[0], point.along[1]};
    const Vector3 normal = cross(by_along, by_across);
    const double facing = dot(direction, normal);
    Vector3 rest = Vector3{from.along, point.at[0], point.at[1]} - base;
    const double position = dot(rest, normal) / facing;
    if (!(facing >= min_facing_cosine * norm(normal)) || !std::isfinite(position)) {
      return std::nullopt;
    }
    rest = rest - position * direction;
    const double speed = norm(by_across);
    const double step_along = std::clamp(-rest.x, -largest_step, largest_step);
    const double step_across =
        std::clamp(-dot(rest - rest.x * by_along, by_across) / speed, -largest_step, largest_step);
    if (std::max(std::abs(step_along), std::abs(step_across)) <= ray_tolerance) {
      sheet_ = index;
      last_ = from;
      graph_ = graph_of(point);
      graph_.sheet = index;
      graph_.across = from.across;
      return position;
    }
    const Start wanted{from.across + step_across / speed, from.along + step_along};
    const Start next{
        std::clamp(wanted.across, across.begin, across.end),
        std::clamp(wanted.along, along.begin - rail_.along(), along.end - rail_.along())};
    const bool is_inside = next.across == wanted.across && next.along == wanted.along;
    at_edge = is_inside ? 0 : at_edge + 1;
    if (at_edge > edge_steps || (next.across == from.across && next.along == from.along)) {
      return std::nullopt; // beyond the sheet's edge
    }
    from = next;
    if (iteration > free_newton_steps) {
      largest_step *= 0.5;
    }
  }
  return std::nullopt;
}

/// Near a point of the line.
std::optional<double> RailLine::from_highest(const Vector3& base, const Vector3& direction,
                                             double position) {
  const Vector3 near = base + position * direction;
  double z = near.z;
  std::optional<GraphPoint> found;
  for (int step = 0; step < (sine_ == 0.0 ? 1 : inclined_steps); ++step) {
    double lateral = 0.0;
    double height = 0.0;
    rail_.to_profile_frame(near.y, z, lateral, height);
    found = rail_.varying()->over(rail_.along() + near.x, lateral);
    if (!found) {
      return std::nullopt;
    }
    z = sine_ * lateral + cosine_ * found->height + rail_.origin_z();
  }
  return newton(found->sheet, {found->across, near.x}, base, direction);
}

std::optional<double> RailLine::meet(const Vector3& base, const Vector3& direction) {
  if (sheet_) {
    if (const auto position = newton(*sheet_, last_, base, direction)) {
      return position;
    }
  }
  return from_highest(base, direction, 0.0);
}

double height_near(const RailSurface& rail, double x, double y) {
  const auto height =
      rail.varying() != nullptr ? RailLine(rail).meet({x, y, 0.0}, {0.0, 0.0, 1.0}) : std::nullopt;
  return height ? *height : rail.graph().at_lateral(y).height;
}

} // namespace wrc
