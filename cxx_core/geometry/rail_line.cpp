#include "geometry/rail_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/constants.hpp"

namespace wrc {
namespace {

GraphPoint graph_of(const HeightPoint& point) {
  GraphPoint graph;
  graph.height = point.height;
  graph.by_lateral = point.slope;
  graph.by_lateral2 = point.second;
  return graph;
}

} // namespace

RailLine::RailLine(const RailSurface& rail, double lateral)
    : rail_(rail), is_prismatic_(rail.is_prismatic_along(along_track)),
      cosine_(std::cos(rail.angle())), sine_(std::sin(rail.angle())) {
  if (is_prismatic_) {
    point_ = rail_.graph().at_lateral(lateral, first_arc_);
    arc_of_point_ = first_arc_;
  }
  restart();
}

void RailLine::restart() {
  arc_ = first_arc_;
  piece_ = rail_.graph().curve().piece_at(arc_);
  sheet_.reset();
}

std::optional<double> RailLine::meet(const Vector3& base, const Vector3& direction) {
  if (is_prismatic_) {
    return meet_curve(base, direction);
  }
  if (sheet_) {
    if (const auto position = meet_sheet(*sheet_, last_, base, direction)) {
      return position;
    }
  }
  return meet_highest(base, direction);
}

CurvePoint RailLine::on_curve(double arc) {
  const Curve& curve = rail_.graph().curve();
  const auto starts = curve.starts();
  if (!(arc >= starts[piece_] && arc < starts[piece_ + 1])) {
    piece_ = curve.piece_at(arc);
  }
  return curve.at(piece_, arc - starts[piece_]);
}

std::optional<double> RailLine::meet_curve(const Vector3& base, const Vector3& direction) {
  const double ny = direction.y;
  const double nz = direction.z;
  double arc = arc_;
  double largest_step = longest_newton_step;
  for (int iteration = 0; iteration < max_newton_steps; ++iteration) {
    if (iteration > 0 || arc != arc_of_point_) {
      point_ = on_curve(arc);
      arc_of_point_ = arc;
    }
    const double offset = nz * (base.y - point_.lateral) - ny * (base.z - point_.height);
    const double facing = nz * point_.tangent_lateral - ny * point_.tangent_height;
    // Positions that are not numbers are met by no line either.
    if (!(facing >= min_facing_cosine) || !std::isfinite(offset)) {
      return std::nullopt;
    }
    const double step = std::clamp(offset / facing, -largest_step, largest_step);
    const double next = std::clamp(arc + step, 0.0, rail_.graph().curve().length());
    const bool at_step = iteration + 1 == max_newton_steps && std::abs(offset) <= step_tolerance;
    if (std::abs(step) <= ray_tolerance || at_step) {
      arc_ = arc;
      // In a yawed and rolled frame the normal also leans along the rail: (ny, nz) is no unit.
      return (ny * (point_.lateral - base.y) + nz * (point_.height - base.z)) / (ny * ny + nz * nz);
    }
    if (next == arc) {
      return std::nullopt; // beyond the profile's end
    }
    arc = next;
    if (iteration > free_newton_steps) {
      largest_step *= 0.5;
    }
  }
  return std::nullopt;
}

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

std::optional<double> RailLine::meet_sheet(std::size_t index, Start from, const Vector3& base,
                                           const Vector3& direction) {
  const SurfaceSheet& sheet = rail_.slices_->sheets()[index];
  const Stretch across = sheet.across();
  const Stretch along = sheet.along();
  double largest_step = longest_newton_step;
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
      point_.lateral = point.at[0];
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
    if (at_edge > sheet_edge_steps || (next.across == from.across && next.along == from.along)) {
      return std::nullopt; // beyond the sheet's edge
    }
    from = next;
    if (iteration > free_newton_steps) {
      largest_step *= 0.5;
    }
  }
  return std::nullopt;
}

/// Near the base of the line.
std::optional<double> RailLine::meet_highest(const Vector3& base, const Vector3& direction) {
  double z = base.z;
  std::optional<GraphPoint> found;
  for (int step = 0; step < (sine_ == 0.0 ? 1 : inclined_top_steps); ++step) {
    double lateral = 0.0;
    double height = 0.0;
    rail_.to_profile_frame(base.y, z, lateral, height);
    found = rail_.slices_->over(rail_.along() + base.x, lateral);
    if (!found) {
      return std::nullopt;
    }
    z = sine_ * lateral + cosine_ * found->height + rail_.origin_z();
  }
  return meet_sheet(found->sheet, {found->across, base.x}, base, direction);
}

std::optional<GraphPoint> RailLine::height(double x, double y) {
  if (is_prismatic_) {
    const HeightFunction& heights = rail_.graph().heights();
    return heights.covers(y) ? std::optional(graph_of(heights.at(y))) : std::nullopt;
  }
  const auto height = meet({x, y, 0.0}, {0.0, 0.0, 1.0});
  if (!height) {
    return std::nullopt;
  }
  GraphPoint point = graph_;
  point.height = *height;
  return point;
}

void RailLine::heights(double x, std::span<const double> laterals,
                       std::span<double> heights) const {
  if (is_prismatic_) {
    const HeightFunction& table = rail_.graph().heights();
    std::ranges::transform(laterals, heights.begin(), [&table](double y) {
      return table.covers(y) ? table.at(y).height : -std::numeric_limits<double>::infinity();
    });
    return;
  }
  std::vector<double> places(laterals.size());
  double height = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    rail_.to_profile_frame(laterals[i], 0.0, places[i], height);
  }
  rail_.slices_->heights(rail_.along() + x, places, heights);
  for (std::size_t i = 0; i < places.size(); ++i) {
    heights[i] = sine_ * places[i] + cosine_ * heights[i] + rail_.origin_z();
  }
}

double RailLine::angle() const {
  if (is_prismatic_) {
    return std::atan2(point_.tangent_height, point_.tangent_lateral);
  }
  const double cosine = 1.0 / std::sqrt(1.0 + graph_.by_lateral * graph_.by_lateral);
  return std::atan2(graph_.by_lateral * cosine, cosine);
}

SurfaceNormal RailLine::normal() const {
  if (is_prismatic_) {
    return {{0.0, -point_.tangent_height, point_.tangent_lateral},
            {0.0, point_.tangent_lateral, point_.tangent_height},
            {0.0, -point_.second_height, point_.second_lateral},
            {}};
  }
  return {{-graph_.by_along, -graph_.by_lateral, 1.0},
          {0.0, 1.0, 0.0},
          {-graph_.by_along_lateral, -graph_.by_lateral2, 0.0},
          {-graph_.by_along2, -graph_.by_along_lateral, 0.0}};
}

double RailLine::inclination(const Vector3& lateral, const Vector3& normal) const {
  const Vector3 upwards = this->normal().normal;
  return -dot(upwards, lateral) / dot(upwards, normal);
}

bool RailLine::is_on_graph() const {
  return arc_ >= rail_.graph().arc_begin() && arc_ <= rail_.graph().arc_end();
}

double height_near(const RailSurface& rail, double x, double y) {
  const auto point =
      rail.is_prismatic_along(along_track) ? std::nullopt : RailLine(rail).height(x, y);
  return point ? point->height : rail.graph().at_lateral(y).height;
}

GraphPoint graph_near(const RailSurface& rail, double x, double y) {
  const auto point =
      rail.is_prismatic_along(along_track) ? std::nullopt : RailLine(rail).height(x, y);
  return point ? *point : graph_of(rail.graph().heights().at(y));
}

} // namespace wrc
