/// A curve across the rail along which the rows of a patch lie, where its plane is not enough.
///
/// It is a function over the plane, given by points with their slopes, and parametrised by its arc
/// s, counted from the plane's origin towards the field side. Cubic Hermite interpolation over s of
/// both coordinates; Simpson's rule over each piece for its length, which makes s the arc to the
/// fourth power of the points' distance. Beyond its ends the curve goes on straight.
/// Units mm; coordinates of the plane (patches/contact_frame.hpp). Thread rule: immutable.
/// Not known here: the bodies, and how the curve lies to them (remesh/mean_curve.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wrc {

class ContactCurve {
public:
  struct Node {
    double lateral = 0.0;
    double height = 0.0; ///< along the plane's normal
    double slope = 0.0;
  };
  /// A point of the curve, and the direction of its tangent.
  struct Point {
    double lateral = 0.0;
    double height = 0.0;
    double cosine = 1.0;
    double sine = 0.0;
  };

  /// Two nodes or more, by ascending lateral positions.
  explicit ContactCurve(std::span<const Node> nodes);

  [[nodiscard]] Point at(double arc) const;
  /// The same curve from another origin in the plane.
  [[nodiscard]] ContactCurve seen_from(double lateral, double height) const;
  /// The arc over a place of the plane.
  [[nodiscard]] double arc_over(double lateral) const;
  /// Change of the tangent's angle, rad/mm.
  [[nodiscard]] double curvature(double arc) const;

private:
  /// The piece that holds a value of an ascending member, its fraction of it and its length.
  struct Place {
    std::size_t piece;
    double fraction;
    double length;
  };
  [[nodiscard]] static Place find(const std::vector<double>& ascending, double value);

  std::vector<Point> nodes_;
  std::vector<double> arcs_;     ///< of the nodes
  std::vector<double> laterals_; ///< likewise
};

} // namespace wrc
