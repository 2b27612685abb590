#include "remesh/contact_patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wrc {
namespace {

/// Limits of separation for lobes in one plane: joined below the first, strangers above the second.
constexpr double join_separation = 0.1;
constexpr double apart_separation = 0.5;
/// The same for lobes whose planes differ by the greater angle or more: joined only where there is
/// hardly a valley (rough profiles have many), strangers once they are apart.
constexpr double steep_join_separation = -0.9;
constexpr double steep_apart_separation = 0.0;
/// From the one angle to the other the limits move, rad. Tilting two lobes by half the lesser angle
/// changes distances by 1 - cos = 0.5 %, by half the greater one 1 %.
constexpr double same_plane_angle = 0.2;
constexpr double other_plane_angle = 0.3;
/// Penetration below this share of the deepest is outside contact (Kik & Piotrowski: the virtual
/// penetration is 0.55 of the approach).
constexpr double outside_contact_share = 0.45;
/// By how much a top between two nodes may exceed the penetration of both, mm: 0.5 mm of a circle
/// of 1 mm radius.
constexpr double highest_top = 0.05;

/// Places of the wheel's profile that are no farther apart are one, mm.
constexpr double same_place = 1e-6;

double smoothstep(double t) {
  const double inside = std::clamp(t, 0.0, 1.0);
  return inside * inside * (3.0 - 2.0 * inside);
}

/// 1 or more: joined, 0 or less: strangers.
double affinity(double separation, double angle_difference) {
  const double turned = smoothstep((std::abs(angle_difference) - same_plane_angle) /
                                   (other_plane_angle - same_plane_angle));
  const double join = std::lerp(join_separation, steep_join_separation, turned);
  const double apart = std::lerp(apart_separation, steep_apart_separation, turned);
  return (apart - separation) / (apart - join);
}

/// A place of the locus.
struct Place {
  double x;
  double y;
  double s;
  double penetration;  ///< vertical, < 0 outside
  double slope;        ///< of the rail
  double curvature;    ///< of the wheel in rolling direction
  bool top;            ///< a local maximum: a parabola to both sides
  double second = 0.0; ///< derivative of the penetration
};

/// Sums over places, weighted.
struct Moments {
  double weight = 0.0;
  double cosine = 0.0;
  double sine = 0.0;
  double x = 0.0;
  double y = 0.0;
  double s = 0.0;

  void add(double share, const Moments& other) {
    weight += share * other.weight;
    cosine += share * other.cosine;
    sine += share * other.sine;
    x += share * other.x;
    y += share * other.y;
    s += share * other.s;
  }
  [[nodiscard]] double angle() const { return std::atan2(sine, cosine); }
};

/// Penetration from one local minimum to the next.
struct Lobe {
  std::size_t first_place; ///< of the places, inclusive
  std::size_t last_place;
  double y_first;
  double y_last;
  double x_first;
  double x_last;
  double half_length;
  Place deepest;
  Moments moments;
  double angle;
  double width;            ///< along the tangent
  double penetration_next; ///< least one towards the next lobe; 0 if they are apart

  /// Takes in the next one.
  void join(const Lobe& next) {
    last_place = next.last_place;
    y_first = std::min(y_first, next.y_first);
    y_last = std::max(y_last, next.y_last);
    x_first = std::min(x_first, next.x_first);
    x_last = std::max(x_last, next.x_last);
    half_length = std::max(half_length, next.half_length);
    if (next.deepest.penetration > deepest.penetration) {
      deepest = next.deepest;
    }
    moments.add(1.0, next.moments);
    penetration_next = next.penetration_next;
    settle();
  }
  void settle() {
    angle = moments.angle();
    width = (y_last - y_first) / std::cos(angle);
  }
};

class PatchFinder {
public:
  PatchFinder(const ContactScan& scan, double depth)
      : samples_(scan.samples), contact_(scan.candidates.front()), depth_(depth),
        limit_(contact_.distance + depth), reach_scale_(1.0 / std::sqrt(depth)) {}

  ContactPatches find();

private:
  [[nodiscard]] Place place_of(const DistanceSample& sample) const {
    const Vector3& at = sample.wheel.position;
    return {at.x,
            at.y,
            sample.wheel.lateral,
            limit_ - sample.distance,
            sample.rail_slope,
            sample.wheel.normal_curvature,
            false,
            0.0};
  }
  [[nodiscard]] Place first_contact() const {
    const Vector3& at = contact_.wheel.position;
    return {at.x,
            at.y,
            contact_.wheel.lateral,
            depth_,
            std::tan(contact_.rail_angle),
            contact_.wheel.normal_curvature,
            true,
            0.0};
  }
  void collect_places();
  void collect_run(std::size_t first, std::size_t last);
  void add_top();
  [[nodiscard]] Moments density(const Place& place, Lobe& lobe) const;
  void find_lobes();
  void begin_lobe(std::size_t place, const Place& begin);
  void add_to_lobe(const Place& from, const Place& to, double length, double bulge);
  [[nodiscard]] double affinity_with_next(std::size_t lobe) const;
  void join_lobes();
  [[nodiscard]] ContactPatch patch_of(const Lobe& lobe) const;
  void find_contact_ends(const Lobe& lobe, ContactPatch& patch) const;
  [[nodiscard]] double turned_angle(std::size_t lobe, const std::vector<double>& links) const;

  const std::vector<DistanceSample>& samples_;
  const ContactCandidate& contact_;
  double depth_;
  double limit_;
  std::vector<Place> places_; ///< stretches that hold penetration and one place more at both ends
  std::size_t after_contact_ = 0; ///< the first sample beyond the first contact
  std::size_t contact_place_ = 0;
  double reach_scale_;             ///< makes weights free of the depth's magnitude
  Moments begin_density_;          ///< where the next stretch of a lobe begins
  std::vector<double> affinities_; ///< of each lobe and the next
  std::vector<Lobe> lobes_;
};

/// By how much penetration half way between two places exceeds their mean, times four: that of a
/// parabola with the lesser curvature of the two, without a top of its own in between.
double bulge_between(const Place& from, const Place& to) {
  const double drop = std::abs(to.penetration - from.penetration);
  if (from.top || to.top) {
    return drop;
  }
  if (from.second * to.second <= 0.0) {
    return 0.0;
  }
  const double second = std::abs(from.second) < std::abs(to.second) ? from.second : to.second;
  const double length = to.y - from.y;
  return std::clamp(-0.5 * length * length * second, -drop, drop);
}

/// The share of the way from one place to a lower one after which penetration is down to a level:
/// root of higher - drop t + bulge t (1 - t) = level.
double way_down(const Place& higher, const Place& lower, double bulge, double level) {
  const double above = higher.penetration - level;
  const double slope = higher.penetration - lower.penetration - bulge;
  return 2.0 * above / (slope + std::sqrt(std::max(slope * slope + 4.0 * bulge * above, 0.0)));
}

/// Between two places; penetration and top are left to the caller.
Place between(const Place& from, const Place& to, double share) {
  return {std::lerp(from.x, to.x, share),
          std::lerp(from.y, to.y, share),
          std::lerp(from.s, to.s, share),
          0.0,
          std::lerp(from.slope, to.slope, share),
          std::lerp(from.curvature, to.curvature, share),
          false,
          0.0};
}

/// Second derivative by differences.
void set_second(const Place& before, Place& here, const Place& after) {
  const double length_before = here.y - before.y;
  const double length_after = after.y - here.y;
  if (length_before > 0.0 && length_after > 0.0) {
    here.second = 2.0 *
                  ((after.penetration - here.penetration) / length_after -
                   (here.penetration - before.penetration) / length_before) /
                  (length_before + length_after);
  }
}

/// All stretches of the scan in which there may be penetration.
void PatchFinder::collect_places() {
  const std::size_t count = samples_.size();
  if (count == 0) {
    places_.push_back(first_contact());
    contact_place_ = 0;
    return;
  }
  const double s = contact_.wheel.lateral;
  after_contact_ =
      static_cast<std::size_t>(std::lower_bound(samples_.begin(), samples_.end(), s,
                                                [](const auto& sample, double at) {
                                                  return sample.wheel.lateral < at - same_place;
                                                }) -
                               samples_.begin());
  const double least_distance = limit_ + highest_top;
  std::size_t i = 0;
  while (i < count) {
    if (samples_[i].distance >= least_distance && i != after_contact_ && i + 1 != after_contact_) {
      ++i;
      continue;
    }
    const std::size_t first = i > 0 ? i - 1 : 0;
    while (i < count && (samples_[i].distance < least_distance || i == after_contact_ ||
                         i + 1 == after_contact_)) {
      ++i;
    }
    collect_run(first, std::min(i, count - 1));
  }
  if (after_contact_ == count) {
    // Beyond the last node: the run before has ended with it.
    contact_place_ = places_.size();
    places_.push_back(first_contact());
  }
}

void PatchFinder::collect_run(std::size_t first, std::size_t last) {
  const std::size_t from = places_.size();
  for (std::size_t i = first; i <= last; ++i) {
    if (i == after_contact_) {
      contact_place_ = places_.size();
      places_.push_back(first_contact());
      if (samples_[i].wheel.lateral - contact_.wheel.lateral <= same_place) {
        continue; // the node itself
      }
    }
    places_.push_back(place_of(samples_[i]));
    if (places_.size() >= from + 3) {
      add_top();
    }
  }
  for (std::size_t i = from + 1; i + 1 < places_.size(); ++i) {
    set_second(places_[i - 1], places_[i], places_[i + 1]);
  }
}

/// The top of the parabola through the last three places, if the middle one is the highest.
void PatchFinder::add_top() {
  const auto middle = places_.end() - 2;
  const Place before = *(middle - 1);
  const Place here = *middle;
  const Place after = *(middle + 1);
  const double length_before = here.y - before.y;
  const double length_after = after.y - here.y;
  if (here.top || here.penetration < before.penetration || here.penetration <= after.penetration ||
      !(length_before > 0.0 && length_after > 0.0)) {
    return;
  }
  const double slope_before = (here.penetration - before.penetration) / length_before;
  const double slope_after = (after.penetration - here.penetration) / length_after;
  const double length = length_before + length_after;
  const double slope = (slope_before * length_after + slope_after * length_before) / length;
  const double way = 0.5 * slope * length / (slope_before - slope_after);
  Place top = way < 0.0 ? between(here, before, -way / length_before)
                        : between(here, after, way / length_after);
  // No place is deeper than the first contact.
  top.penetration = std::min(here.penetration + 0.5 * slope * way, depth_);
  top.top = true;
  places_.insert(way < 0.0 ? middle : middle + 1, top);
}

/// What a place counts per length in y; also its reach along the rail.
Moments PatchFinder::density(const Place& place, Lobe& lobe) const {
  const double cosine = 1.0 / std::sqrt(1.0 + place.slope * place.slope);
  const double reach = std::sqrt(place.penetration * cosine / place.curvature);
  const double half_length = std::numbers::sqrt2 * reach;
  lobe.half_length = std::max(lobe.half_length, half_length);
  lobe.x_first = std::min(lobe.x_first, place.x - half_length);
  lobe.x_last = std::max(lobe.x_last, place.x + half_length);
  // g^2 x_l ds with g = penetration cos, ds = dy / cos; made free of the depth's magnitude.
  const double relative = place.penetration / depth_;
  const double weight = relative * relative * cosine * reach * reach_scale_;
  return {weight,           weight * cosine,  weight * place.slope * cosine,
          weight * place.x, weight * place.y, weight * place.s};
}

void PatchFinder::begin_lobe(std::size_t place, const Place& begin) {
  Lobe lobe{};
  lobe.first_place = place;
  lobe.y_first = begin.y;
  lobe.x_first = lobe.x_last = begin.x;
  lobe.deepest = begin;
  lobe.moments = {};
  begin_density_ = density(begin, lobe);
  lobes_.push_back(lobe);
}

/// Simpson's rule from where the last one ended.
void PatchFinder::add_to_lobe(const Place& from, const Place& to, double length, double bulge) {
  Lobe& lobe = lobes_.back();
  Place middle = between(from, to, 0.5);
  middle.penetration = 0.5 * (from.penetration + to.penetration) + 0.25 * bulge;
  const Moments end = density(to, lobe);
  lobe.moments.add(length / 6.0, begin_density_);
  lobe.moments.add(length * 4.0 / 6.0, density(middle, lobe));
  lobe.moments.add(length / 6.0, end);
  begin_density_ = end;
  if (to.penetration > lobe.deepest.penetration) {
    lobe.deepest = to;
  }
  lobe.y_last = to.y;
}

void PatchFinder::find_lobes() {
  bool open = false;
  bool falling = false;
  for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
    Place from = places_[i];
    Place to = places_[i + 1];
    double bulge = bulge_between(from, to);
    double length = std::abs(to.y - from.y);
    if (from.penetration <= 0.0 && to.penetration <= 0.0) {
      open = false;
      continue;
    }
    const bool rising = to.penetration > from.penetration;
    bool ends = false;
    if (from.penetration <= 0.0) {
      const double share = way_down(to, from, bulge, 0.0);
      from = between(to, from, share);
      length *= share;
      bulge *= share * share;
      open = false;
    } else if (to.penetration <= 0.0) {
      const double share = way_down(from, to, bulge, 0.0);
      to = between(from, to, share);
      length *= share;
      bulge *= share * share;
      ends = true;
    }
    if (!open) {
      falling = false;
      begin_lobe(i, from);
    } else if (falling && rising) {
      lobes_.back().penetration_next = from.penetration;
      begin_lobe(i, from);
    }
    add_to_lobe(from, to, length, bulge);
    lobes_.back().last_place = i + 1;
    open = !ends;
    falling = to.penetration < from.penetration || (falling && !rising);
  }
  if (lobes_.empty()) {
    begin_lobe(contact_place_, places_[contact_place_]);
    lobes_.back().last_place = contact_place_;
    lobes_.back().y_last = lobes_.back().y_first;
  }
  for (Lobe& lobe : lobes_) {
    if (!(lobe.moments.weight > 0.0)) {
      // No width that a number could tell from nothing.
      lobe.moments.add(std::numeric_limits<double>::epsilon(), density(lobe.deepest, lobe));
    }
    lobe.settle();
  }
}

double PatchFinder::affinity_with_next(std::size_t lobe) const {
  const Lobe& first = lobes_[lobe];
  const Lobe& second = lobes_[lobe + 1];
  const double separation =
      first.penetration_next > 0.0
          ? -first.penetration_next /
                std::min(first.deepest.penetration, second.deepest.penetration)
          : (second.y_first - first.y_last) /
                std::max({first.width, second.width, std::numeric_limits<double>::min()});
  return affinity(separation, second.angle - first.angle);
}

/// Joins neighbours, the closest ones first, until none are left that belong together.
void PatchFinder::join_lobes() {
  affinities_.resize(lobes_.size());
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t k = 0; k + 1 < lobes_.size(); ++k) {
      affinities_[k] = affinity_with_next(k);
    }
    affinities_[lobes_.size() - 1] = -std::numeric_limits<double>::infinity();
    std::size_t out = 0;
    for (std::size_t k = 0; k < lobes_.size(); ++k, ++out) {
      const bool closest = (k == 0 || affinities_[k] >= affinities_[k - 1]) &&
                           (k + 1 == lobes_.size() || affinities_[k] > affinities_[k + 1]);
      Lobe lobe = lobes_[k];
      if (closest && affinities_[k] >= 1.0) {
        lobe.join(lobes_[++k]);
        joined = true;
      }
      lobes_[out] = lobe;
    }
    lobes_.resize(out);
  }
}

/// Where the virtual penetration of a patch begins and ends, from its ends inwards.
void PatchFinder::find_contact_ends(const Lobe& lobe, ContactPatch& patch) const {
  const double level = outside_contact_share * lobe.deepest.penetration;
  const auto end = [&](std::size_t inside, std::size_t outside, bool at_end) {
    const Place& here = places_[inside];
    if (at_end) {
      return here;
    }
    const Place& beyond = places_[outside];
    return between(here, beyond, way_down(here, beyond, bulge_between(here, beyond), level));
  };
  std::size_t first = lobe.first_place;
  while (places_[first].penetration < level) {
    ++first;
  }
  std::size_t last = lobe.last_place;
  while (places_[last].penetration < level) {
    --last;
  }
  const Place begin = end(first, first - 1, first == lobe.first_place);
  const Place finish = end(last, last + 1, last == lobe.last_place);
  patch.contact_first = begin.y;
  patch.contact_last = finish.y;
  patch.angle_first = std::atan(begin.slope);
  patch.angle_last = std::atan(finish.slope);
}

ContactPatch PatchFinder::patch_of(const Lobe& lobe) const {
  ContactPatch patch;
  patch.y_first = lobe.y_first;
  patch.y_last = lobe.y_last;
  patch.x_first = lobe.x_first;
  patch.x_last = lobe.x_last;
  patch.half_length = lobe.half_length;
  patch.deepest = lobe.deepest.penetration;
  patch.deepest_x = lobe.deepest.x;
  patch.deepest_y = lobe.deepest.y;
  patch.deepest_s = lobe.deepest.s;
  patch.own_angle = lobe.angle;
  patch.mean_x = lobe.moments.x / lobe.moments.weight;
  patch.mean_y = lobe.moments.y / lobe.moments.weight;
  patch.mean_s = lobe.moments.s / lobe.moments.weight;
  find_contact_ends(lobe, patch);
  return patch;
}

/// Mean over all levels of closeness of the plane of those that are at least that close.
double PatchFinder::turned_angle(std::size_t lobe, const std::vector<double>& links) const {
  std::size_t first = lobe;
  std::size_t last = lobe;
  Moments cluster = lobes_[lobe].moments;
  double level = 1.0;
  double angle = 0.0;
  while (level > 0.0) {
    const double before = first > 0 ? links[first - 1] : 0.0;
    const double after = last < links.size() ? links[last] : 0.0;
    const double next = std::min(level, std::max(before, after));
    angle += (level - next) * cluster.angle();
    level = next;
    if (next > 0.0) {
      cluster.add(1.0, lobes_[before >= after ? --first : ++last].moments);
    }
  }
  return angle;
}

ContactPatches PatchFinder::find() {
  collect_places();
  find_lobes();
  join_lobes();
  ContactPatches result;
  double weight = 0.0;
  for (const Lobe& lobe : lobes_) {
    weight += lobe.moments.weight;
  }
  result.patches.reserve(lobes_.size());
  result.links.reserve(lobes_.size());
  for (std::size_t k = 0; k < lobes_.size(); ++k) {
    ContactPatch patch = patch_of(lobes_[k]);
    patch.share = lobes_[k].moments.weight / weight;
    if (k > 0) {
      const double border = 0.5 * (patch.y_first + result.patches.back().y_last);
      result.patches.back().territory_last = patch.territory_first = border;
      result.links.push_back(smoothstep(affinities_[k - 1]));
    }
    if (lobes_[k].first_place <= contact_place_ && contact_place_ <= lobes_[k].last_place) {
      result.main = k;
    }
    result.patches.push_back(patch);
  }
  for (std::size_t k = 0; k < lobes_.size(); ++k) {
    result.patches[k].angle = turned_angle(k, result.links);
  }
  return result;
}

/// The lateral coordinate of the rail's surface at a place of the track.
double lateral_at(double y, const RailSurface& rail, const ContactFrame& frame) {
  const Vector3 place{frame.origin.x, y, rail.graph().heights().at(y).height};
  return dot(place - frame.origin, frame.lateral);
}

} // namespace

double ContactPatches::closeness(std::size_t i, std::size_t j) const {
  double least = 1.0;
  for (std::size_t k = std::min(i, j); k < std::max(i, j); ++k) {
    least = std::min(least, links[k]);
  }
  return least;
}

double closeness_of(double separation, double angle_difference) {
  return smoothstep(affinity(separation, angle_difference));
}

ContactPatches find_contact_patches(const ContactScan& scan, double depth) {
  return PatchFinder(scan, depth).find();
}

PlaneArea area_of(const ContactPatch& patch, const RailSurface& rail, const ContactFrame& frame) {
  constexpr double unset = std::numeric_limits<double>::infinity();
  PlaneArea area{unset, -unset, unset, -unset};
  for (const double y : {patch.y_first, patch.y_last}) {
    const double z = rail.graph().at_lateral(y).height;
    for (const double x : {patch.x_first, patch.x_last}) {
      const Vector3 from_origin = Vector3{x, y, z} - frame.origin;
      const double lateral = dot(from_origin, frame.lateral);
      const double longitudinal = dot(from_origin, frame.longitudinal);
      area.lateral_first = std::min(area.lateral_first, lateral);
      area.lateral_last = std::max(area.lateral_last, lateral);
      area.longitudinal_first = std::min(area.longitudinal_first, longitudinal);
      area.longitudinal_last = std::max(area.longitudinal_last, longitudinal);
    }
  }
  // Penetration at a single place of the scan has no width of its own: give it a little.
  const double least_width = 1e-3 * area.length();
  if (area.width() < least_width) {
    const double middle = 0.5 * (area.lateral_first + area.lateral_last);
    area.lateral_first = middle - 0.5 * least_width;
    area.lateral_last = middle + 0.5 * least_width;
  }
  return area;
}

PlaneArea within_territory(const PlaneArea& area, const ContactPatch& patch,
                           const RailSurface& rail, const ContactFrame& frame) {
  PlaneArea inside = area;
  if (std::isfinite(patch.territory_first)) {
    inside.lateral_first =
        std::max(inside.lateral_first, lateral_at(patch.territory_first, rail, frame));
  }
  if (std::isfinite(patch.territory_last)) {
    inside.lateral_last =
        std::min(inside.lateral_last, lateral_at(patch.territory_last, rail, frame));
  }
  inside.lateral_last = std::max(inside.lateral_last, inside.lateral_first);
  return inside;
}

} // namespace wrc
