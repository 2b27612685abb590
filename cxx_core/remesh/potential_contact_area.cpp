#include "remesh/potential_contact_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "remesh/depth_estimate.hpp"

namespace wrc {
namespace {

/// Intervals whose mean angles differ by less than this share one plane: each is then tilted by
/// about half of it, which changes distances by 1 - cos(0.1 rad) = 0.5 % ...
constexpr double same_plane_angle = 0.2;
/// ... if they are no farther apart than this, mm: the width of a running band.
constexpr double same_plane_distance = 20.0;

/// An uninterrupted stretch of penetration along the locus.
struct Interval {
  double y_first;
  double y_last;
  double x_first;
  double x_last;
  double half_length;
  double deepest;
  double deepest_lateral; ///< s on the wheel
  double weight;
  double angle_moment;
  double y_moment;

  [[nodiscard]] double mean_angle() const { return angle_moment / weight; }
};

void include(Interval& into, const Interval& other) {
  into.y_first = std::min(into.y_first, other.y_first);
  into.y_last = std::max(into.y_last, other.y_last);
  into.x_first = std::min(into.x_first, other.x_first);
  into.x_last = std::max(into.x_last, other.x_last);
  into.half_length = std::max(into.half_length, other.half_length);
  into.weight += other.weight;
  into.angle_moment += other.angle_moment;
  into.y_moment += other.y_moment;
}

/// The point of first touch as an interval of its own: what a depth too small for the scan leaves.
Interval touch_interval(const ContactCandidate& contact, double depth) {
  const double normal_depth = depth * std::cos(contact.rail_angle);
  const double half_length = std::sqrt(2.0 * normal_depth / contact.wheel.normal_curvature);
  const Vector3 place = contact.wheel.position;
  return {place.y,
          place.y,
          place.x - half_length,
          place.x + half_length,
          half_length,
          depth,
          contact.wheel.lateral,
          depth,
          depth * contact.rail_angle,
          depth * place.y};
}

/// Where the penetration between two neighbouring samples ends, by linear interpolation.
double crossing(const DistanceSample& inside, const DistanceSample& outside, double limit) {
  const double share = (limit - inside.distance) / (outside.distance - inside.distance);
  return inside.wheel.position.y + share * (outside.wheel.position.y - inside.wheel.position.y);
}

std::vector<Interval> penetration_intervals(const ContactScan& scan, double depth) {
  const ContactCandidate& contact = scan.candidates.front();
  const double limit = contact.distance + depth;
  std::vector<Interval> intervals;
  const auto& samples = scan.samples;
  bool open = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const DistanceSample& sample = samples[i];
    const double penetration = limit - sample.distance;
    if (penetration <= 0.0) {
      if (open) {
        intervals.back().y_last = crossing(samples[i - 1], sample, limit);
      }
      open = false;
      continue;
    }
    const double y = sample.wheel.position.y;
    const double cosine = 1.0 / std::sqrt(1.0 + sample.rail_slope * sample.rail_slope);
    const double half_length =
        std::sqrt(2.0 * penetration * cosine / sample.wheel.normal_curvature);
    const double spacing = i > 0 ? std::abs(y - samples[i - 1].wheel.position.y) : 0.0;
    // Penetration integrated along the rail: 4/3 of its depth times the half length.
    const double weight = penetration * half_length * std::max(spacing, 1e-12);
    const Interval here{y,
                        y,
                        sample.wheel.position.x - half_length,
                        sample.wheel.position.x + half_length,
                        half_length,
                        penetration,
                        sample.wheel.lateral,
                        weight,
                        weight * sample.rail_angle(),
                        weight * y};
    if (!open) {
      intervals.push_back(here);
      if (i > 0) {
        intervals.back().y_first = crossing(sample, samples[i - 1], limit);
      }
      open = true;
    } else {
      Interval& interval = intervals.back();
      if (penetration > interval.deepest) {
        interval.deepest = penetration;
        interval.deepest_lateral = sample.wheel.lateral;
      }
      include(interval, here);
    }
  }
  return intervals;
}

} // namespace

PenetrationRegion find_penetration_region(const ContactScan& scan, double depth) {
  const ContactCandidate& contact = scan.candidates.front();
  const double contact_y = contact.wheel.position.y;
  Interval area = touch_interval(contact, depth);
  std::vector<Interval> intervals = penetration_intervals(scan, depth);
  const auto holds_contact = [contact_y](const Interval& interval) {
    return interval.y_first <= contact_y && contact_y <= interval.y_last;
  };
  const auto first = std::find_if(intervals.begin(), intervals.end(), holds_contact);
  if (first != intervals.end()) {
    const Interval touch = area;
    area = *first;
    area.half_length = std::max(area.half_length, touch.half_length);
    area.x_first = std::min(area.x_first, touch.x_first);
    area.x_last = std::max(area.x_last, touch.x_last);
    intervals.erase(first);
  }
  // Join what lies in nearly the same plane, nearest first, until nothing more joins.
  const auto joins = [&area](const Interval& interval) {
    const double apart = std::max(interval.y_first - area.y_last, area.y_first - interval.y_last);
    return apart <= same_plane_distance &&
           std::abs(interval.mean_angle() - area.mean_angle()) <= same_plane_angle;
  };
  for (auto next = std::find_if(intervals.begin(), intervals.end(), joins); next != intervals.end();
       next = std::find_if(intervals.begin(), intervals.end(), joins)) {
    include(area, *next);
    intervals.erase(next);
  }
  PenetrationRegion region;
  region.y_first = area.y_first;
  region.y_last = area.y_last;
  region.x_first = area.x_first;
  region.x_last = area.x_last;
  region.half_length = area.half_length;
  region.mean_angle = area.mean_angle();
  region.mean_y = area.y_moment / area.weight;
  if (!intervals.empty()) {
    region.other_regions = true;
    const auto shallower = [](const auto& a, const auto& b) { return a.deepest < b.deepest; };
    region.other_wheel_lateral =
        std::max_element(intervals.begin(), intervals.end(), shallower)->deepest_lateral;
  }
  return region;
}

double estimate_depth(const ContactScan& scan, double combined_modulus, double normal_load) {
  return estimate_depth(scan, combined_modulus, normal_load, LoadDirection::main_normal);
}

PlaneArea PlaneArea::widened(double share) const {
  return {lateral_first - share * width(), lateral_last + share * width(),
          longitudinal_first - share * length(), longitudinal_last + share * length()};
}

PlaneArea area_of(const PenetrationRegion& region, const RailSurface& rail,
                  const ContactFrame& frame) {
  const double unset = std::numeric_limits<double>::infinity();
  PlaneArea area{unset, -unset, unset, -unset};
  for (const double y : {region.y_first, region.y_last}) {
    const double z = rail.graph().at_lateral(y).height;
    for (const double x : {region.x_first, region.x_last}) {
      const Vector3 from_origin = Vector3{x, y, z} - frame.origin;
      const double lateral = dot(from_origin, frame.lateral);
      const double longitudinal = dot(from_origin, frame.longitudinal);
      area.lateral_first = std::min(area.lateral_first, lateral);
      area.lateral_last = std::max(area.lateral_last, lateral);
      area.longitudinal_first = std::min(area.longitudinal_first, longitudinal);
      area.longitudinal_last = std::max(area.longitudinal_last, longitudinal);
    }
  }
  // An interval between two nodes of the scan has no width of its own: give it a little.
  const double least_width = 1e-3 * area.length();
  if (area.width() < least_width) {
    const double middle = 0.5 * (area.lateral_first + area.lateral_last);
    area.lateral_first = middle - 0.5 * least_width;
    area.lateral_last = middle + 0.5 * least_width;
  }
  return area;
}

Grid grid_over(const PlaneArea& area, std::size_t lateral_count, std::size_t longitudinal_count) {
  Grid grid;
  grid.lateral_count = lateral_count;
  grid.longitudinal_count = longitudinal_count;
  grid.lateral_step = area.width() / static_cast<double>(lateral_count);
  grid.longitudinal_step = area.length() / static_cast<double>(longitudinal_count);
  grid.lateral_first = area.lateral_first + 0.5 * grid.lateral_step;
  grid.longitudinal_first = area.longitudinal_first + 0.5 * grid.longitudinal_step;
  return grid;
}

} // namespace wrc
