#include "patches/contact_curve.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {
namespace {

/// Value, and derivative by the fraction t, of the cubic with these ends.
struct Cubic {
  double value;
  double rate;
};

Cubic hermite(double t, double first, double first_rate, double last, double last_rate) {
  const double chord = last - first;
  const double bend = 3.0 * chord - 2.0 * first_rate - last_rate;
  const double twist = first_rate + last_rate - 2.0 * chord;
  return {first + t * (first_rate + t * (bend + t * twist)),
          first_rate + t * (2.0 * bend + 3.0 * t * twist)};
}

double stretch(double slope) {
  return std::sqrt(1.0 + slope * slope);
}

} // namespace

ContactCurve::ContactCurve(std::span<const Node> nodes) {
  for (const Node& node : nodes) {
    const double cosine = 1.0 / stretch(node.slope);
    nodes_.push_back({node.lateral, node.height, cosine, cosine * node.slope});
    laterals_.push_back(node.lateral);
  }
  arcs_.push_back(0.0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Node& a = nodes[i - 1];
    const Node& b = nodes[i];
    const double width = b.lateral - a.lateral;
    const Cubic middle = hermite(0.5, a.height, a.slope * width, b.height, b.slope * width);
    const double length =
        width / 6.0 * (stretch(a.slope) + 4.0 * stretch(middle.rate / width) + stretch(b.slope));
    arcs_.push_back(arcs_.back() + length);
  }
  const double origin = arc_over(0.0);
  for (double& arc : arcs_) {
    arc -= origin;
  }
}

ContactCurve ContactCurve::seen_from(double lateral, double height) const {
  ContactCurve curve = *this;
  const double origin = arc_over(lateral);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    curve.nodes_[i].lateral -= lateral;
    curve.nodes_[i].height -= height;
    curve.laterals_[i] -= lateral;
    curve.arcs_[i] -= origin;
  }
  return curve;
}

ContactCurve::Place ContactCurve::find(const std::vector<double>& ascending, double value) {
  const auto next = std::upper_bound(ascending.begin() + 1, ascending.end() - 1, value);
  const auto piece = static_cast<std::size_t>(next - ascending.begin()) - 1;
  const double length = ascending[piece + 1] - ascending[piece];
  return {piece, (value - ascending[piece]) / length, length};
}

ContactCurve::Point ContactCurve::at(double arc) const {
  const double inside = std::clamp(arc, arcs_.front(), arcs_.back());
  const Place place = find(arcs_, inside);
  const Point& a = nodes_[place.piece];
  const Point& b = nodes_[place.piece + 1];
  const double h = place.length;
  const Cubic lateral = hermite(place.fraction, a.lateral, h * a.cosine, b.lateral, h * b.cosine);
  const Cubic height = hermite(place.fraction, a.height, h * a.sine, b.height, h * b.sine);
  const double length = std::hypot(lateral.rate, height.rate);
  const double cosine = lateral.rate / length;
  const double sine = height.rate / length;
  const double beyond = arc - inside;
  return {lateral.value + beyond * cosine, height.value + beyond * sine, cosine, sine};
}

double ContactCurve::arc_over(double lateral) const {
  const double inside = std::clamp(lateral, laterals_.front(), laterals_.back());
  const Place place = find(laterals_, inside);
  const double first = arcs_[place.piece];
  const double last = arcs_[place.piece + 1];
  const double a = nodes_[place.piece].cosine;
  const double b = nodes_[place.piece + 1].cosine;
  const Cubic arc = hermite(place.fraction, first, place.length / a, last, place.length / b);
  return arc.value + (lateral - inside) * arc.rate / place.length;
}

double ContactCurve::curvature(double arc) const {
  if (arc < arcs_.front() || arc > arcs_.back()) {
    return 0.0;
  }
  const Place place = find(arcs_, arc);
  const Point& a = nodes_[place.piece];
  const Point& b = nodes_[place.piece + 1];
  return std::atan2(a.cosine * b.sine - a.sine * b.cosine, a.cosine * b.cosine + a.sine * b.sine) /
         place.length;
}

} // namespace wrc
