#include "remesh/surface_rays.hpp"

#include <algorithm>
#include <cmath>

#include "remesh/constants.hpp"

namespace wrc {

RailRay::RailRay(const RailSurface& rail, const ContactFrame& frame)
    : graph_(rail.graph()), frame_(frame) {
  point_ = graph_.at_lateral(frame.origin.y, start_);
  arc_of_point_ = start_;
  restart();
}

void RailRay::restart() {
  arc_ = start_;
  piece_ = graph_.curve().piece_at(arc_);
}

bool RailRay::on_graph() const {
  return arc_ >= graph_.arc_begin() && arc_ <= graph_.arc_end();
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
      normal_(rotation_.to_body(frame.normal)), lateral_(base(0.0, 0.0).y),
      height_(wheel_.graph().heights().at(lateral_).height) {}

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
  // Start: where the ray enters the cylinder of the radius last met.
  const double radius = wheel_.radius() + height_;
  const double a = normal_.x * normal_.x + normal_.z * normal_.z;
  const double b = from.x * normal_.x + from.z * normal_.z;
  const double c = from.x * from.x + (from.z - radius) * (from.z + radius);
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0)) {
    return std::nullopt;
  }
  double position = (-b - std::sqrt(discriminant)) / a;
  double largest_step = first_ray_step;
  const HeightFunction& heights = wheel_.graph().heights();
  for (int iteration = 0; iteration < max_newton_steps; ++iteration) {
    const Vector3 body = from + position * normal_;
    lateral_ = body.y;
    const HeightPoint profile = heights.at(lateral_);
    const double rho = wheel_.radius() + profile.height;
    const double excess = 0.5 * (body.x * body.x + (body.z - rho) * (body.z + rho));
    const double derivative =
        body.x * normal_.x + body.z * normal_.z - rho * profile.slope * normal_.y;
    if (!(derivative < -min_facing_cosine * rho)) {
      return std::nullopt;
    }
    const double step = std::clamp(-excess / derivative, -largest_step, largest_step);
    const bool at_step =
        iteration + 1 == max_newton_steps && std::abs(excess) <= step_tolerance * rho;
    if (std::abs(step) <= ray_tolerance || at_step) {
      if (!heights.covers(lateral_)) {
        return std::nullopt;
      }
      height_ = profile.height;
      return position;
    }
    position += step;
    if (iteration > free_newton_steps) {
      largest_step *= 0.5;
    }
  }
  return std::nullopt;
}

double WheelRay::inclination(double longitudinal, double lateral, double position) const {
  const Vector3 met = base(longitudinal, lateral) + position * normal_;
  const HeightPoint profile = wheel_.graph().heights().at(met.y);
  const Vector3 gradient{met.x, -(wheel_.radius() + profile.height) * profile.slope, met.z};
  return -dot(gradient, cross(normal_, longitudinal_)) / dot(gradient, normal_);
}

} // namespace wrc
