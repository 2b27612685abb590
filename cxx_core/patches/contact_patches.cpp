#include "patches/contact_patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rail_line.hpp"
#include "patches/constants.hpp"
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
            -sample.by_y,
            0.0,
            sample.rail_rise,
            sample.ahead};
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
            0.0,
            0.0,
            contact.rail_rise,
            contact.ahead};
  }

private:
  double yaw_tangent_;
};

/// Patches of several scans that overlap, seen from above, become one.
void join_overlapping(std::vector<ContactPatch>& patches) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < patches.size() && !changed; ++i) {
      for (std::size_t k = i + 1; k < patches.size() && !changed; ++k) {
        const ContactPatch& a = patches[i];
        const ContactPatch& b = patches[k];
        if (a.scan != b.scan && a.y_first < b.y_last && b.y_first < a.y_last &&
            a.x_first < b.x_last && b.x_first < a.x_last) {
          patches[i] = joined(a, b);
          patches[i].limit_first = -std::numeric_limits<double>::infinity();
          patches[i].limit_last = std::numeric_limits<double>::infinity();
          patches.erase(patches.begin() + static_cast<std::ptrdiff_t>(k));
          changed = true;
        }
      }
    }
  }
}

/// About its middle.
PlaneArea widened(PlaneArea area) {
  const double least = least_width_over_length * area.length();
  if (area.width() < least) {
    const double middle = 0.5 * (area.lateral_first + area.lateral_last);
    area.lateral_first = middle - 0.5 * least;
    area.lateral_last = middle + 0.5 * least;
  }
  return area;
}

/// The lateral coordinate of the rail's surface at a point of the track.
double lateral_at(double y, const RailSurface& rail, const ContactFrame& frame) {
  const Vector3 place{frame.origin.x, y, graph_near(rail, frame.origin.x, y).height};
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
                                    const PatchOptions& options) {
  const PlainPlaces places(scan);
  return patch_finding::PatchFinder(scan, depth, options, places).find();
}

ContactPatch joined(const ContactPatch& one, const ContactPatch& other) {
  ContactPatch both = one.deepest >= other.deepest ? one : other;
  const auto mean = [&](double of_one, double of_other) {
    return (one.weight * of_one + other.weight * of_other) / (one.weight + other.weight);
  };
  const ContactPatch& first = one.y_first <= other.y_first ? one : other;
  const ContactPatch& last = one.y_last >= other.y_last ? one : other;
  both.y_first = first.y_first;
  both.y_last = last.y_last;
  both.x_first = std::min(one.x_first, other.x_first);
  both.x_last = std::max(one.x_last, other.x_last);
  both.half_length = std::max(one.half_length, other.half_length);
  both.angle_unturned = both.angle = mean(one.angle_unturned, other.angle_unturned);
  const auto square = [&](const ContactPatch& patch) {
    const double apart = patch.angle_unturned - both.angle_unturned;
    return patch.deviation * patch.deviation + apart * apart;
  };
  both.deviation = std::sqrt(mean(square(one), square(other)));
  both.rise = mean(one.rise, other.rise);
  both.ahead = mean(one.ahead, other.ahead);
  both.joins_scans = one.joins_scans || other.joins_scans || one.scan != other.scan;
  both.mean_x = mean(one.mean_x, other.mean_x);
  both.mean_y = mean(one.mean_y, other.mean_y);
  both.mean_s = mean(one.mean_s, other.mean_s);
  both.weight = one.weight + other.weight;
  both.contact_first = first.contact_first;
  both.angle_first = first.angle_first;
  both.contact_last = last.contact_last;
  both.angle_last = last.angle_last;
  return both;
}

ContactPatches find_contact_patches(std::span<const ContactScan* const> scans, double depth,
                                    const PatchOptions& options) {
  ContactPatches all = find_contact_patches(*scans.front(), depth, options);
  const double first_y = scans.front()->candidates.front().wheel.position.y;
  bool changed = false;
  for (std::size_t k = 1; k < scans.size(); ++k) {
    const double of_scan = depth - behind(*scans[k], *scans.front());
    if (!(of_scan > 0.0)) {
      continue;
    }
    ContactPatches found = find_contact_patches(*scans[k], of_scan, options);
    // Weights of a scan are over a power of its depth.
    const double weight = found.weight * std::pow(of_scan / depth, 2.5);
    const double sum = all.weight + weight;
    for (ContactPatch& patch : all.patches) {
      patch.weight *= all.weight / sum;
    }
    for (ContactPatch& patch : found.patches) {
      patch.weight *= weight / sum;
      patch.scan = k;
      all.patches.push_back(patch);
    }
    all.weight = sum;
    changed = true;
  }
  if (changed) {
    join_overlapping(all.patches);
    std::stable_sort(all.patches.begin(), all.patches.end(),
                     [](const auto& one, const auto& other) { return one.mean_y < other.mean_y; });
    all.links.assign(all.patches.size() - 1, 0.0);
    const auto depth_at_first = [&](const ContactPatch& patch) {
      return patch.y_first <= first_y && first_y <= patch.y_last ? patch.deepest : 0.0;
    };
    all.main = static_cast<std::size_t>(std::ranges::max_element(all.patches, {}, depth_at_first) -
                                        all.patches.begin());
  }
  return all;
}

std::vector<patch_finding::LocusSample<double>> locus_samples(const ContactScan& scan,
                                                              double depth) {
  return patch_finding::LocusSampler(scan, depth, PlainPlaces(scan)).samples();
}

PlaneArea area_of(const ContactPatch& patch, const RailSurface& rail, const ContactFrame& frame) {
  PlaneArea area = PlaneArea::empty();
  for (const double y : {patch.y_first, patch.y_last}) {
    for (const double x : {patch.x_first, patch.x_last}) {
      const double z = height_near(rail, x, y);
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
