#include "remesh/undeformed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wrc {
namespace {

constexpr int newton_limit = 50;
/// Rays are solved to this, mm: a tenth of a thousandth of the smallest approach of interest.
constexpr double ray_tolerance = 1e-12;
/// At a step of a profile, as the rounding of a standard's coefficients leaves it, Newton's method
/// has no root to find: a place this near, mm, is taken.
constexpr double step_tolerance = 2e-3;
/// A rail seen from the ray at a flatter angle than this (its cosine) no longer faces it.
constexpr double least_facing_cosine = 0.02;

/// Intersection of rays with the rail's curve; keeps the last place as the next start.
class RailRay {
public:
  RailRay(const RailSurface& rail, const ContactFrame& frame)
      : curve_(rail.graph().curve()), frame_(frame) {
    point_ = rail.graph().at_lateral(frame.origin.y, start_);
    arc_ = start_;
  }

  void restart() { arc_ = start_; }
  [[nodiscard]] const CurvePoint& point() const { return point_; }

  /// Position along the normal at which the ray through the place meets the rail.
  std::optional<double> solve(double longitudinal, double lateral) {
    const Vector3 base = frame_.to_track(longitudinal, lateral, 0.0);
    const double ny = frame_.normal.y;
    const double nz = frame_.normal.z;
    double arc = arc_;
    double largest_step = 4.0;
    for (int iteration = 0; iteration < newton_limit; ++iteration) {
      point_ = curve_.at(arc);
      const double offset = nz * (base.y - point_.lateral) - ny * (base.z - point_.height);
      const double facing = nz * point_.tangent_lateral - ny * point_.tangent_height;
      if (facing < least_facing_cosine) {
        return std::nullopt;
      }
      const double step = std::clamp(offset / facing, -largest_step, largest_step);
      const double next = std::clamp(arc + step, 0.0, curve_.length());
      const bool at_step = iteration + 1 == newton_limit && std::abs(offset) <= step_tolerance;
      if (std::abs(step) <= ray_tolerance || at_step) {
        arc_ = arc;
        // In a yawed and rolled frame the normal also leans along the rail: (ny, nz) is no unit.
        return (ny * (point_.lateral - base.y) + nz * (point_.height - base.z)) /
               (ny * ny + nz * nz);
      }
      if (next == arc) {
        return std::nullopt; // beyond the profile's end
      }
      arc = next;
      if (iteration > 10) {
        largest_step *= 0.5; // at a kink or a step Newton's method may alternate: close in
      }
    }
    return std::nullopt;
  }

private:
  const Curve& curve_;
  const ContactFrame& frame_;
  double start_ = 0.0;
  double arc_ = 0.0;
  CurvePoint point_;
};

/// Intersection of rays with the wheel's surface of revolution.
class WheelRay {
public:
  WheelRay(const PosedPair& pair, const ContactFrame& frame)
      : wheel_(pair.wheel), rotation_(pair.pose),
        frame_(frame), centre_{0.0, pair.pose.lateral, pair.vertical},
        normal_(rotation_.to_body(frame.normal)),
        lateral_(rotation_.to_body(frame.origin - centre_).y - wheel_.taping_line()),
        height_(wheel_.graph().at_lateral(lateral_).height) {}

  [[nodiscard]] double lateral() const { return lateral_; }
  /// Of the wheel profile where the last ray met it; the next ray starts from there.
  [[nodiscard]] double height() const { return height_; }
  void start_from(double height) { height_ = height; }

  /// Position along the normal at which the ray meets the wheel from below.
  std::optional<double> solve(double longitudinal, double lateral) {
    const Vector3 base = rotation_.to_body(frame_.to_track(longitudinal, lateral, 0.0) - centre_);
    // Start: where the ray enters the cylinder of the radius last met.
    const double radius = wheel_.radius() + height_;
    const double a = normal_.x * normal_.x + normal_.z * normal_.z;
    const double b = base.x * normal_.x + base.z * normal_.z;
    const double c = base.x * base.x + base.z * base.z - radius * radius;
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0.0)) {
      return std::nullopt;
    }
    double position = (-b - std::sqrt(discriminant)) / a;
    double largest_step = 4.0;
    for (int iteration = 0; iteration < newton_limit; ++iteration) {
      const Vector3 body = base + position * normal_;
      lateral_ = body.y - wheel_.taping_line();
      const CurvePoint profile = wheel_.graph().at_lateral(lateral_);
      const double distance_to_axis = std::hypot(body.x, body.z);
      const double excess = distance_to_axis - (wheel_.radius() + profile.height);
      const double derivative = (body.x * normal_.x + body.z * normal_.z) / distance_to_axis -
                                profile.slope() * normal_.y;
      if (!(derivative < -least_facing_cosine)) {
        return std::nullopt;
      }
      const double step = std::clamp(-excess / derivative, -largest_step, largest_step);
      const bool at_step = iteration + 1 == newton_limit && std::abs(excess) <= step_tolerance;
      if (std::abs(step) <= ray_tolerance || at_step) {
        if (!wheel_.graph().covers(lateral_)) {
          return std::nullopt;
        }
        height_ = profile.height;
        return position;
      }
      position += step;
      if (iteration > 10) {
        largest_step *= 0.5;
      }
    }
    return std::nullopt;
  }

private:
  const WheelSurface& wheel_;
  const Rotation rotation_;
  const ContactFrame& frame_;
  const Vector3 centre_;
  const Vector3 normal_;
  double lateral_;
  double height_;
};

/// Index of the element whose centre is nearest to the frame's origin.
std::size_t nearest_index(double first, double step, std::size_t count) {
  const double index = std::round(-first / step);
  return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
}

} // namespace

std::vector<double> sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame,
                                               const Grid& grid) {
  std::vector<double> distance(grid.element_count(), no_material_distance);
  const bool rail_constant_along_rows = frame.longitudinal.y == 0.0 && frame.longitudinal.z == 0.0;
  RailRay rail(pair.rail, frame);
  WheelRay wheel(pair, frame);
  const std::size_t middle_row =
      nearest_index(grid.lateral_first, grid.lateral_step, grid.lateral_count);
  const std::size_t middle_column =
      nearest_index(grid.longitudinal_first, grid.longitudinal_step, grid.longitudinal_count);
  const double first_height = wheel.height();
  double row_start = first_height; // height of the wheel profile in the middle of the row before

  const auto sample_row = [&](std::size_t row) {
    const double lateral = grid.lateral(row);
    double* values = distance.data() + row * grid.longitudinal_count;
    std::optional<double> rail_position;
    if (rail_constant_along_rows) {
      rail_position = rail.solve(0.0, lateral);
      if (!rail_position) {
        return;
      }
    }
    wheel.start_from(row_start);
    const auto sample_element = [&](std::size_t column) {
      const double longitudinal = grid.longitudinal(column);
      if (!rail_constant_along_rows) {
        rail_position = rail.solve(longitudinal, lateral);
      }
      const auto wheel_position = wheel.solve(longitudinal, lateral);
      if (wheel_position && rail_position) {
        values[column] = *wheel_position - *rail_position;
      }
    };
    for (std::size_t column = middle_column; column < grid.longitudinal_count; ++column) {
      sample_element(column);
      if (column == middle_column) {
        row_start = wheel.height();
      }
    }
    wheel.start_from(row_start);
    for (std::size_t column = middle_column; column-- > 0;) {
      sample_element(column);
    }
  };

  for (std::size_t row = middle_row; row < grid.lateral_count; ++row) {
    sample_row(row);
  }
  row_start = first_height;
  rail.restart();
  for (std::size_t row = middle_row; row-- > 0;) {
    sample_row(row);
  }
  return distance;
}

SurfacePlace surfaces_at(const PosedPair& pair, const ContactFrame& frame, double longitudinal,
                         double lateral) {
  SurfacePlace place;
  RailRay rail(pair.rail, frame);
  if (const auto position = rail.solve(longitudinal, lateral)) {
    place.on_rail = true;
    place.rail = frame.to_track(longitudinal, lateral, *position);
    place.rail_angle = std::atan2(rail.point().tangent_height, rail.point().tangent_lateral);
  }
  WheelRay wheel(pair, frame);
  if (const auto position = wheel.solve(longitudinal, lateral)) {
    place.on_wheel = true;
    place.wheel = frame.to_track(longitudinal, lateral, *position);
    place.wheel_lateral = wheel.lateral();
    place.wheel_height = wheel.height();
  }
  return place;
}

} // namespace wrc
