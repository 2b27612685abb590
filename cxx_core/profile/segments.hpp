/// Profiles as standards define them: lines, arcs and polynomials joined end to end.
///
/// Turns segments into a Curve whose pieces reproduce them to 1e-11 mm in position and 1e-8 in
/// curvature (relative to the segment's largest), checked inside the pieces. Remainder of quintic
/// Hermite interpolation: f^(6) (s (s - h))^3 / 720 (Davis, Interpolation and Approximation, 1963,
/// ch. 3); for an arc of radius R that is R (h/R)^6 / 46080 at mid piece. Arc lengths of
/// polynomials by Gauss-Legendre quadrature.
///
/// Units mm, rad. Frame of curve.hpp: height as the profile defines it, lateral ascending.
/// Segment boundaries are nodes of the curve. Gaps up to `max_junction_gap` are kept as they
/// are: they are what the rounded coefficients of a standard leave.
/// Does not know: wheels and rails, files. Thread rule: no state.
#pragma once

#include <array>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "profile/constants.hpp"
#include "profile/curve.hpp"

namespace wrc {

struct LineSegment {
  Position start;
  Position end;
};

/// An arc taken the short way from start to end; both must lie on the circle within
/// `max_junction_gap` and are moved onto it radially.
struct ArcSegment {
  Position centre;
  double radius = 0.0;
  Position start;
  Position end;
};

/// height(lateral) = sum coefficients[i] (lateral - expansion_point)^i.
struct PolynomialSegment {
  std::vector<double> coefficients;
  double expansion_point = 0.0;
  double lateral_start = 0.0;
  double lateral_end = 0.0;
};

struct Segment {
  std::string label;
  std::variant<LineSegment, ArcSegment, PolynomialSegment> shape;
};

/// Where two neighbouring segments meet.
struct Junction {
  std::string before;
  std::string after;
  double lateral = 0.0; ///< end of `before`
  double height = 0.0;
  double gap = 0.0;  ///< distance between end and begin
  double kink = 0.0; ///< rad by which the tangent turns, positive towards larger height
};

/// The curve of the segments. Throws Error(invalid_argument) naming the segment or the pair of
/// segments at fault.
Curve curve_of(std::span<const Segment> segments);

/// All junctions, in order.
std::vector<Junction> junctions_of(std::span<const Segment> segments);

/// The segments of a symmetric profile from those of its right half, which start at lateral 0.
std::vector<Segment> with_mirrored_half(std::span<const Segment> right_half);

} // namespace wrc
