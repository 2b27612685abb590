#include "geometry/rail_surface.hpp"

#include <cmath>

#include "base/error.hpp"

namespace wrc {
namespace {

/// Lateral coordinate of the gauge face at a given height: the place, going from the top towards
/// the gauge side, where the curve first falls below the height.
double lateral_of_gauge_face(const Curve& curve, double top_arc, double height,
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
  throw_invalid_argument("track.gauge_height", gauge_height,
                         "at most the depth of the rail profile's gauge face below its top, mm");
}

} // namespace

RailSurface::Placed RailSurface::place(const Profile& profile, const TrackDimensions& track) {
  const Curve inclined = profile.curve.moved(track.cant, 0.0, 0.0);
  const double top_arc = arc_of_highest_point(inclined);
  const double top = inclined.at(top_arc).height;
  const double face =
      lateral_of_gauge_face(inclined, top_arc, top - track.gauge_height, track.gauge_height);
  const double lateral_shift = 0.5 * track.gauge - face;
  return {CurveGraph(profile.curve.without_steps().moved(track.cant, lateral_shift, -top), top_arc),
          lateral_shift, -top};
}

RailSurface::RailSurface(const Profile& profile, const TrackDimensions& track)
    : RailSurface(place(profile, track), track.cant) {}

RailSurface::RailSurface(Placed placed, double cant)
    : graph_(std::move(placed.graph)), cant_(cant), lateral_shift_(placed.lateral_shift),
      height_shift_(placed.height_shift) {}

void RailSurface::to_profile_frame(double y, double z, double& lateral, double& height) const {
  const double along = y - lateral_shift_;
  const double up = z - height_shift_;
  lateral = std::cos(cant_) * along + std::sin(cant_) * up;
  height = std::cos(cant_) * up - std::sin(cant_) * along;
}

} // namespace wrc
