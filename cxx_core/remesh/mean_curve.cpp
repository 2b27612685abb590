#include "remesh/mean_curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "remesh/constants.hpp"

namespace wrc {
namespace {

/// A point of the curve, and by how much the bodies overlap there along the plane's normal.
struct Midway {
  ContactCurve::Node node;
  double overlap = 0.0;
};

std::optional<Midway> midway(RailRay& rail, WheelRay& wheel, double lateral) {
  const auto on_rail = rail.solve(0.0, lateral);
  const auto on_wheel = wheel.solve(0.0, lateral);
  if (!on_rail || !on_wheel) {
    return std::nullopt;
  }
  const double wheel_slope = wheel.inclination(0.0, lateral, *on_wheel);
  return Midway{
      {lateral, 0.5 * (*on_rail + *on_wheel), 0.5 * (rail.inclination(lateral) + wheel_slope)},
      *on_rail - *on_wheel};
}

/// Normals of the curve reach half of the overlap to either side. What is wrong, if anything.
std::string check_normals(const std::vector<Midway>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Midway& a = points[i - 1];
    const Midway& b = points[i];
    const double turn = std::abs(std::atan(b.node.slope) - std::atan(a.node.slope));
    const double arc = std::hypot(b.node.lateral - a.node.lateral, b.node.height - a.node.height);
    const double reach = 0.5 * std::min(a.overlap, b.overlap);
    if (reach > 0.0 && reach * turn >= arc) {
      return "normals of the curve cross within an overlap of " + short_text_of(2.0 * reach) +
             " mm";
    }
  }
  return {};
}

} // namespace

MeanCurve mean_curve(const PosedPair& pair, const ContactFrame& frame, double first, double last,
                     double share) {
  if (share == 0.0) {
    return {};
  }
  RailRay rail(pair.rail, frame);
  WheelRay wheel(pair, frame);
  const double first_height = wheel.height();
  const double step = (last - first) / static_cast<double>(penetration_rows - 1);
  std::vector<Midway> points;
  const auto add = [&](std::size_t i) {
    if (auto point = midway(rail, wheel, first + static_cast<double>(i) * step)) {
      points.push_back(*point);
    }
  };
  // Outwards from the frame's origin, each ray from the height that its neighbour met.
  const std::size_t middle = nearest_to_zero(first, step, penetration_rows);
  for (std::size_t i = middle; i-- > 0;) {
    add(i);
  }
  std::ranges::reverse(points);
  rail.restart();
  wheel.start_from(first_height);
  for (std::size_t i = middle; i < penetration_rows; ++i) {
    add(i);
  }
  if (points.size() < 2) {
    return {nullptr, "normals of the plane meet wheel and rail in fewer than two of " +
                         std::to_string(penetration_rows) + " places"};
  }
  if (std::string refusal = check_normals(points); !refusal.empty()) {
    return {nullptr, std::move(refusal)};
  }
  std::vector<ContactCurve::Node> nodes;
  bool straight = true;
  for (const Midway& point : points) {
    nodes.push_back({point.node.lateral, share * point.node.height, share * point.node.slope});
    straight = straight && point.node.slope == 0.0;
  }
  return straight ? MeanCurve{} : MeanCurve{std::make_shared<const ContactCurve>(nodes), {}};
}

} // namespace wrc
