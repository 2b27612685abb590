/// The curve midway between wheel and rail, along which the rows of a patch may lie.
///
/// Both sections at the frame's x = 0 are functions g_r and g_w over the patch's plane, and
///   m = (g_r + g_w) / 2
/// is the curve. Bodies that are alike deform to it, and both are inclined to it by the same small
/// angle, half the slope of the gap between them: rows need no scale (remesh/row_scales.hpp), and
/// the exact choice of the curve has only a second-order effect. Points are equally spaced over the
/// plane, with the slopes of both surfaces there. Below 1 `share` is the part taken of its heights
/// and slopes: anything from the plane to the curve, continuous in the share. Units mm; frame of
/// patches/contact_frame.hpp. Thread rule: a pure function. Not known here: curvature along the
/// rail, which the half-space neglects.
#pragma once

#include <memory>
#include <string>

#include "patches/contact_curve.hpp"
#include "patches/contact_frame.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

struct MeanCurve {
  std::shared_ptr<const ContactCurve> curve; ///< none: the plane
  /// Why there is no curve: the bodies overlap so deeply that its normals cross before they meet
  /// them, or fewer than two normals of the plane meet both. Empty where it is straight.
  std::string refusal;
};

/// Over a stretch of the frame's plane. Where a body ends the curve goes on straight.
MeanCurve mean_curve(const PosedPair& pair, const ContactFrame& frame, double first, double last,
                     double share = 1.0);

} // namespace wrc
