#include "geometry/rail_surface.hpp"

#include <cmath>
#include <optional>

#include "base/error.hpp"

namespace wrc {
namespace {

/// Distance of the axis of a body without gauge face from the place of a gauge face, mm.
/// origin: published: running circles are 1500 mm apart, on a gauge of 1435 mm (EN 15302).
constexpr double axis_distance = 32.5;
/// A gauge face falls at least by this slope.
/// origin: published: gauge corners turn to 87 degrees (EN 13674-1); a crown turns by 19 degrees.
constexpr double least_face_slope = 1.0;

/// Lateral coordinate of the gauge face at a given height, none if there is no face: the point,
/// going from the top towards the gauge side, where the curve first falls below the height.
std::optional<double> lateral_of_gauge_face(const Curve& curve, double top_arc, double height,
                                            double gauge_height) {
  const std::size_t top_piece = curve.piece_at(top_arc);
  for (std::size_t piece = top_piece + 1; piece-- > 0;) {
    if (curve.at(piece, 0.0).height > height) {
      continue;
    }
    double low = 0.0; // below the height
    double high = curve.starts()[piece + 1] - curve.starts()[piece];
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) {
        return curve.at(piece, middle).lateral;
      }
      (curve.at(piece, middle).height <= height ? low : high) = middle;
    }
  }
  const CurvePoint end = curve.at(0.0);
  if (end.tangent_height < least_face_slope * end.tangent_lateral) {
    return std::nullopt;
  }
  throw_invalid_argument("track.gauge_height", gauge_height,
                         "at most the depth of the rail profile's gauge face below its top, mm");
}

} // namespace

RailSurface RailSurface::place(const Profile& profile, const TrackDimensions& track) {
  const Curve inclined = profile.curve.moved(track.cant, 0.0, 0.0);
  const double top_arc = arc_of_highest_point(inclined);
  if (track.origin) {
    CurveGraph placed(profile.curve.without_steps().moved(track.cant, *track.origin, 0.0), top_arc);
    auto whole = std::make_shared<const Curve>(placed.curve());
    return {std::move(placed), std::move(whole), top_arc, track.cant, *track.origin, 0.0};
  }
  const double top = inclined.at(top_arc).height;
  const std::optional<double> face =
      lateral_of_gauge_face(inclined, top_arc, top - track.gauge_height, track.gauge_height);
  const double lateral_shift = 0.5 * track.gauge + (face ? -*face : axis_distance);
  CurveGraph graph(profile.curve.without_steps().moved(track.cant, lateral_shift, -top), top_arc);
  auto nominal = std::make_shared<const Curve>(graph.curve());
  RailSurface surface{std::move(graph), std::move(nominal), top_arc,
                      track.cant,       lateral_shift,      -top};
  surface.is_placed_by_axis_ = !face;
  return surface;
}

RailSurface::RailSurface(const Profile& profile, const TrackDimensions& track)
    : RailSurface(place(profile, track)) {}

RailSurface::RailSurface(std::shared_ptr<const VaryingRail> rail, const Profile& first,
                         const TrackDimensions& track)
    : RailSurface(place(first, track)) {
  varying_ = std::move(rail);
  along_ = varying_->along().begin;
}

void RailSurface::refuse_beyond_slices(double along) const {
  const Stretch slices = varying_->along();
  if (!(along >= slices.begin && along <= slices.end)) {
    throw Error(ErrorCode::no_contact, "pose.longitudinal = " + text_of(along) +
                                           " mm: the slices of the rail reach from " +
                                           text_of(slices.begin) + " to " + text_of(slices.end) +
                                           " mm");
  }
}

RailSurface RailSurface::posed(const RailDisplacement& displacement, double along) const {
  const double angle = angle_ + displacement.roll;
  const double lateral_shift = lateral_shift_ + displacement.lateral;
  const double height_shift = height_shift_ + displacement.height;
  Curve section =
      widest_section(varying_->sheets(), along).moved(angle, lateral_shift, height_shift);
  const double top = arc_of_highest_point(section);
  RailSurface surface{
      CurveGraph(std::move(section), top), nominal_, top, angle, lateral_shift, height_shift};
  surface.varying_ = varying_;
  surface.along_ = along;
  return surface;
}

RailSurface RailSurface::displaced(const RailDisplacement& displacement) const {
  const double lateral_shift = lateral_shift_ + displacement.lateral;
  const double height_shift = height_shift_ + displacement.height;
  if (varying_ != nullptr) {
    return posed(displacement, along_);
  }
  if (displacement.roll == 0.0) {
    return {graph_.shifted(displacement.lateral, displacement.height),
            nominal_,
            top_arc_,
            angle_,
            lateral_shift,
            height_shift};
  }
  const Curve about_origin = graph_.curve().moved(0.0, -lateral_shift_, -height_shift_);
  return {CurveGraph(about_origin.moved(displacement.roll, lateral_shift, height_shift), top_arc_),
          nominal_,
          top_arc_,
          angle_ + displacement.roll,
          lateral_shift,
          height_shift};
}

void RailSurface::to_profile_frame(double y, double z, double& lateral, double& height) const {
  const double along = y - lateral_shift_;
  const double up = z - height_shift_;
  lateral = std::cos(angle_) * along + std::sin(angle_) * up;
  height = std::cos(angle_) * up - std::sin(angle_) * along;
}

} // namespace wrc
