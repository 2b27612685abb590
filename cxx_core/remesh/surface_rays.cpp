#include "remesh/surface_rays.hpp"

#include <algorithm>
#include <cmath>

#include "remesh/constants.hpp"

namespace wrc {
namespace {

/// The section of a surface through one of its points.
CurvePoint section_point(const GraphPoint& graph, double lateral) {
  const double cosine = 1.0 / std::sqrt(1.0 + graph.by_lateral * graph.by_lateral);
  const double sine = graph.by_lateral * cosine;
  const double curvature = graph.by_lateral2 * cosine * cosine * cosine;
  return {lateral, graph.height, cosine, sine, -curvature * sine, curvature * cosine};
}

} // namespace

RailRay::RailRay(const RailSurface& rail, const ContactFrame& frame)
    : graph_(rail.graph()), frame_(frame) {
  point_ = graph_.at_lateral(frame.origin.y, start_);
  arc_of_point_ = start_;
  if (rail.varying() != nullptr) {
    line_.emplace(rail);
  }
  restart();
}

void RailRay::restart() {
  arc_ = start_;
  piece_ = graph_.curve().piece_at(arc_);
  if (line_) {
    line_->restart();
  }
}

bool RailRay::on_graph() const {
  return arc_ >= graph_.arc_begin() && arc_ <= graph_.arc_end();
}

double RailRay::inclination(double lateral) const {
  const ContactFrame::Row row = frame_.row_at(lateral);
  if (line_) { // the section across lies beside the plane of lateral and normal
    const Vector3 gradient{-line_->graph().by_along, -line_->graph().by_lateral, 1.0};
    return -dot(gradient, row.lateral) / dot(gradient, row.normal);
  }
  const Vector3 along{0.0, point_.tangent_lateral, point_.tangent_height};
  return dot(along, row.normal) / dot(along, row.lateral);
}

CurvePoint RailRay::at(double arc) {
  const auto starts = graph_.curve().starts();
  if (!(arc >= starts[piece_] && arc < starts[piece_ + 1])) {
    piece_ = graph_.curve().piece_at(arc);
  }
  return graph_.curve().at(piece_, arc - starts[piece_]);
}

std::optional<double> RailRay::solve(double longitudinal, double lateral) {
  const Vector3 base = frame_.to_track(longitudinal, lateral, 0.0);
  const Vector3 normal = frame_.curve ? frame_.row_at(lateral).normal : frame_.normal;
  if (line_) {
    const auto position = line_->meet(base, normal);
    if (position) {
      point_ = section_point(line_->graph(), base.y + *position * normal.y);
    }
    return position;
  }
  const double ny = normal.y;
  const double nz = normal.z;
  double arc = arc_;
  double largest_step = first_ray_step;
  for (int iteration = 0; iteration < max_newton_steps; ++iteration) {
    if (iteration > 0 || arc != arc_of_point_) {
      point_ = at(arc);
      arc_of_point_ = arc;
    }
    const double offset = nz * (base.y - point_.lateral) - ny * (base.z - point_.height);
    const double facing = nz * point_.tangent_lateral - ny * point_.tangent_height;
    // Positions that are not numbers are met by no ray either.
    if (!(facing >= min_facing_cosine) || !std::isfinite(offset)) {
      return std::nullopt;
    }
    const double step = std::clamp(offset / facing, -largest_step, largest_step);
    const double next = std::clamp(arc + step, 0.0, graph_.curve().length());
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

WheelRay::WheelRay(const PosedPair& pair, const ContactFrame& frame)
    : wheel_(pair.wheel), rotation_(pair.pose),
      frame_(frame), centre_{0.0, pair.pose.lateral, pair.vertical},
      longitudinal_(rotation_.to_body(frame.longitudinal)),
      normal_(rotation_.to_body(frame.normal)),
      line_(pair.wheel, wheel_.graph().heights().at(base(0.0, 0.0).y).height) {}

Vector3 WheelRay::base(double longitudinal, double lateral) const {
  Vector3 base = rotation_.to_body(frame_.to_track(longitudinal, lateral, 0.0) - centre_);
  base.y -= wheel_.taping_line();
  return base;
}

std::optional<double> WheelRay::solve(double longitudinal, double lateral) {
  const Vector3 from = base(longitudinal, lateral);
  if (frame_.curve) {
    normal_ = rotation_.to_body(frame_.row_at(lateral).normal);
  }
  return line_.meet(from, normal_);
}

double WheelRay::inclination(double longitudinal, double lateral, double position) const {
  const Vector3 met = base(longitudinal, lateral) + position * normal_;
  const Vector3 gradient = line_.gradient(met);
  return -dot(gradient, cross(normal_, longitudinal_)) / dot(gradient, normal_);
}

} // namespace wrc
