/// A smooth curve through points: cubic splines of lateral and height.
///
/// Not-a-knot end conditions (de Boor, A Practical Guide to Splines, 1978, ch. IV) over cumulative
/// chord length, which is then replaced twice by the arc length of the spline before, so that the
/// parameter is close to the arc length. The curve has nodes at all points and in between, at most
/// `max_node_distance` apart; lengths of pieces by Gauss-Legendre quadrature.
///
/// Units mm, frame of curve.hpp. Does not know: kinks; a kink in the points rings over a few of
/// them. Thread rule: no state.
#pragma once

#include <span>

#include "profile/curve.hpp"
#include "profile/segments.hpp"

namespace wrc {

/// Throws Error(invalid_argument) for fewer than four points, points that coincide with the one
/// before, and lines that turn back on themselves.
Curve curve_through(std::span<const Position> points);

} // namespace wrc
