#include "geometry/rail_surface.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/constants.hpp"

namespace wrc {
namespace {

/// Least lateral coordinate of a curve between two arc lengths: where it turns back, or at an end.
double least_lateral_of(const Curve& curve, double from, double to) {
  double least = std::min(curve.at(from).lateral, curve.at(to).lateral);
  for (std::size_t piece = curve.piece_at(from); piece <= curve.piece_at(to); ++piece) {
    double low = std::max(curve.starts()[piece], from);
    double high = std::min(curve.starts()[piece + 1], to);
    if (!(curve.at(low).tangent_lateral < 0.0 && curve.at(high).tangent_lateral >= 0.0)) {
      continue;
    }
    for (double middle = 0.5 * (low + high); middle > low && middle < high;
         middle = 0.5 * (low + high)) {
      (curve.at(middle).tangent_lateral < 0.0 ? low : high) = middle;
    }
    least = std::min(least, curve.at(low).lateral);
  }
  return least;
}

/// Lateral coordinate of the gauge face, none if there is no face: the least one between the top
/// and the point, going from there towards the gauge side, where the curve first falls below the
/// height. Gauges are the least distances within this depth (EN 13848-1), and worn rails have lips.
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
        return std::min(curve.at(piece, middle).lateral,
                        least_lateral_of(curve, curve.starts()[piece] + middle, top_arc));
      }
      (curve.at(piece, middle).height <= height ? low : high) = middle;
    }
  }
  const CurvePoint end = curve.at(0.0);
  if (end.tangent_height < least_gauge_face_slope * end.tangent_lateral) {
    return std::nullopt;
  }
  throw_invalid_argument("track.gauge_height", gauge_height,
                         "at most the depth of the rail profile's gauge face below its top, mm");
}

} // namespace

struct RailSurface::Prism {
  ConstantStretch where;
  RailSurface rail;
};

RailSurface RailSurface::place(const Curve& profile, const TrackDimensions& track) {
  const Curve inclined = profile.moved(track.inclination, 0.0, 0.0);
  const double top_arc = arc_of_crown(inclined);
  if (track.origin) {
    CurveGraph placed(profile.without_steps().moved(track.inclination, *track.origin, 0.0),
                      top_arc);
    auto whole = std::make_shared<const Curve>(placed.curve());
    return {std::move(placed), std::move(whole), top_arc, track.inclination, *track.origin, 0.0};
  }
  const double top = inclined.at(top_arc).height;
  const std::optional<double> face =
      lateral_of_gauge_face(inclined, top_arc, top - track.gauge_height, track.gauge_height);
  const double lateral_shift = 0.5 * track.gauge + (face ? -*face : axis_from_gauge_face);
  CurveGraph graph(profile.without_steps().moved(track.inclination, lateral_shift, -top), top_arc);
  auto nominal = std::make_shared<const Curve>(graph.curve());
  RailSurface surface{std::move(graph),  std::move(nominal), top_arc,
                      track.inclination, lateral_shift,      -top};
  surface.is_placed_by_axis_ = !face;
  return surface;
}

RailSurface::RailSurface(const Profile& profile, const TrackDimensions& track)
    : RailSurface(place(profile.curve, track)) {}

RailSurface::RailSurface(std::shared_ptr<const SlicedSurface> slices, const Curve& first,
                         const TrackDimensions& track)
    : RailSurface(place(first, track)) {
  slices_ = std::move(slices);
  along_ = slices_->along().begin;
  std::vector<Prism> prisms;
  for (const ConstantStretch& where : slices_->constant_stretches()) {
    RailSurface prism = posed({}, where.along.begin).as_prism();
    prism.is_placed_by_axis_ = is_placed_by_axis_;
    prisms.push_back({where, std::move(prism)});
  }
  prisms_ = std::make_shared<const std::vector<Prism>>(std::move(prisms));
}

void RailSurface::refuse_beyond_slices(double along) const {
  if (slices_ == nullptr) {
    return;
  }
  const Stretch slices = slices_->along();
  if (!(along >= slices.begin && along <= slices.end)) {
    throw Error(ErrorCode::no_contact, "pose.longitudinal = " + text_of(along) +
                                           " mm: the slices of the rail reach from " +
                                           text_of(slices.begin) + " to " + text_of(slices.end) +
                                           " mm");
  }
}

double RailSurface::distance_along() const {
  return slices_ != nullptr ? slices_->distance_to_part(along_) : 0.0;
}

std::optional<PartEnd> RailSurface::nearest_end(double x) const {
  return slices_ != nullptr ? slices_->nearest_end(along_ + x) : std::nullopt;
}

std::vector<Curve> RailSurface::sections() const {
  if (slices_ == nullptr) {
    return {graph_.curve()};
  }
  std::vector<Curve> sections = slices_->sections(along_);
  for (Curve& section : sections) {
    section = section.moved(angle_, lateral_shift_, height_shift_);
  }
  std::ranges::sort(sections, {}, [](const Curve& section) { return section.at(0.0).lateral; });
  return sections;
}

RailSurface RailSurface::posed(const RailDisplacement& displacement, double along) const {
  const double angle = angle_ + displacement.roll;
  const double lateral_shift = lateral_shift_ + displacement.lateral;
  const double height_shift = height_shift_ + displacement.height;
  if (slices_ != nullptr) {
    Curve section = slices_->section(along).moved(angle, lateral_shift, height_shift);
    const double top = arc_of_crown(section);
    RailSurface surface{
        CurveGraph(std::move(section), top), nominal_, top, angle, lateral_shift, height_shift};
    surface.slices_ = slices_;
    surface.along_ = along;
    surface.prisms_ = prisms_;
    return surface;
  }
  if (displacement.roll == 0.0) {
    return {graph_.shifted(displacement.lateral, displacement.height),
            nominal_,
            top_arc_,
            angle,
            lateral_shift,
            height_shift};
  }
  const Curve about_origin = graph_.curve().moved(0.0, -lateral_shift_, -height_shift_);
  return {CurveGraph(about_origin.moved(displacement.roll, lateral_shift, height_shift), top_arc_),
          nominal_,
          top_arc_,
          angle,
          lateral_shift,
          height_shift};
}

const RailSurface* RailSurface::prism_at(double along, const WheelSurface& wheel,
                                         double yaw) const {
  if (prisms_ == nullptr) {
    return nullptr;
  }
  const double of_yaw = wheel.taping_line() * std::abs(std::sin(yaw));
  for (const Prism& prism : *prisms_) {
    const double reach =
        of_yaw + wheel.largest_radius() * wheel.touch_angle(yaw, prism.where.rise,
                                                            !wheel.is_prismatic_along(along_track));
    if (prism.where.along.begin <= along - reach && along + reach <= prism.where.along.end) {
      return &prism.rail;
    }
  }
  return nullptr;
}

RailSurface RailSurface::as_prism() const {
  RailSurface prism = *this;
  prism.slices_.reset();
  prism.prisms_.reset();
  return prism;
}

std::shared_ptr<const RailSurface> posed(const std::shared_ptr<const RailSurface>& rail,
                                         const RailDisplacement& displacement, double along,
                                         const WheelSurface& wheel, double yaw) {
  const RailSurface* prism = rail->prism_at(along, wheel, yaw);
  if (prism == nullptr && rail->is_prismatic_along(along_track) &&
      displacement == RailDisplacement{}) {
    return rail;
  }
  return std::make_shared<const RailSurface>(
      (prism != nullptr ? *prism : *rail).posed(displacement, along));
}

void RailSurface::to_profile_frame(double y, double z, double& lateral, double& height) const {
  const double along = y - lateral_shift_;
  const double up = z - height_shift_;
  lateral = std::cos(angle_) * along + std::sin(angle_) * up;
  height = std::cos(angle_) * up - std::sin(angle_) * along;
}

} // namespace wrc
