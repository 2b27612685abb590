#include "patches/contact_patches.hpp"

#include <algorithm>
#include <cmath>

#include "patches/patch_finder.hpp"

namespace wrc {
namespace {

/// Points as the scan has them.
class PlainPlaces {
public:
  using Real = double;
  using Place = patch_finding::LocusSample<double>;

  explicit PlainPlaces(const ContactScan& scan) : yaw_tangent_(scan.yaw_tangent) {}

  [[nodiscard]] double yaw_tangent() const { return yaw_tangent_; }

  [[nodiscard]] Place place_of(const DistanceSample& sample, double limit) const {
    const Vector3& at = sample.wheel.position;
    return {at.x,
            at.y,
            at.z - sample.distance,
            sample.wheel.lateral,
            limit - sample.distance,
            sample.rail_slope,
            sample.wheel.normal_curvature,
            false,
            0.0};
  }
  [[nodiscard]] Place place_of(const ContactCandidate& contact, double penetration) const {
    const Vector3& at = contact.wheel.position;
    return {at.x,
            at.y,
            at.z - contact.distance,
            contact.wheel.lateral,
            penetration,
            std::tan(contact.rail_angle),
            contact.wheel.normal_curvature,
            true,
            0.0};
  }

private:
  double yaw_tangent_;
};

/// The width that every potential contact area has, over its length.
/// origin: bound: less than an element; penetration at a single point of the scan has none.
constexpr double least_width = 1e-3;

/// About its middle.
PlaneArea widened(PlaneArea area) {
  const double least = least_width * area.length();
  if (area.width() < least) {
    const double middle = 0.5 * (area.lateral_first + area.lateral_last);
    area.lateral_first = middle - 0.5 * least;
    area.lateral_last = middle + 0.5 * least;
  }
  return area;
}

/// The lateral coordinate of the rail's surface at a point of the track.
double lateral_at(double y, const RailSurface& rail, const ContactFrame& frame) {
  const Vector3 place{frame.origin.x, y, rail.graph().heights().at(y).height};
  return dot(place - frame.origin, frame.lateral);
}

} // namespace

double ContactPatches::coupling_weight(std::size_t i, std::size_t j,
                                       Interaction interaction) const {
  if (interaction == Interaction::all) {
    return std::max(0.0, std::cos(patches[i].angle - patches[j].angle));
  }
  double least = 1.0;
  for (std::size_t k = std::min(i, j); k < std::max(i, j); ++k) {
    least = std::min(least, links[k]);
  }
  return least;
}

ContactPatches find_contact_patches(const ContactScan& scan, double depth,
                                    double joining_distance) {
  const PlainPlaces places(scan);
  return patch_finding::PatchFinder(scan, depth, joining_distance, places).find();
}

std::vector<patch_finding::LocusSample<double>> locus_samples(const ContactScan& scan,
                                                              double depth) {
  return patch_finding::LocusSampler(scan, depth, PlainPlaces(scan)).samples();
}

PlaneArea area_of(const ContactPatch& patch, const RailSurface& rail, const ContactFrame& frame) {
  PlaneArea area = PlaneArea::empty();
  for (const double y : {patch.y_first, patch.y_last}) {
    const double z = rail.graph().at_lateral(y).height;
    for (const double x : {patch.x_first, patch.x_last}) {
      const Vector3 from_origin = Vector3{x, y, z} - frame.origin;
      area.include(dot(from_origin, frame.lateral), dot(from_origin, frame.longitudinal));
    }
  }
  return widened(area);
}

PlaneArea within_limits(const PlaneArea& area, const ContactPatch& patch, const RailSurface& rail,
                        const ContactFrame& frame) {
  PlaneArea inside = area;
  // Under yaw neighbours may overlap in y, one of them as a whole beyond the boundary of both.
  const auto limited = [&](double limit) {
    return std::clamp(lateral_at(limit, rail, frame), area.lateral_first, area.lateral_last);
  };
  if (std::isfinite(patch.limit_first)) {
    inside.lateral_first = limited(patch.limit_first);
  }
  if (std::isfinite(patch.limit_last)) {
    inside.lateral_last = limited(patch.limit_last);
  }
  return widened(inside);
}

} // namespace wrc
