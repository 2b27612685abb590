/// The search behind patches/contact_patches.hpp, for plain numbers and for numbers with rates.
///
/// What is found, and how, stands there. The same statements run on values that carry derivatives
/// (base/value_with_rates.hpp), which gives the rates of the planes (remesh/plane_rates.hpp); all
/// decisions are those of the values.
/// Units mm and rad; track frame, left-hand side (geometry/frames.hpp).
/// Thread rule: one object, one thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "patches/contact_patches.hpp"

namespace wrc::patch_finding {

// Found by argument for numbers with rates.
using std::abs;
using std::atan;
using std::atan2;
using std::cos;
using std::lerp;
using std::sqrt;

inline double value_of(double value) {
  return value;
}

/// Limits of separation for lobes in one plane: joined below the first, strangers above the second.
inline constexpr double join_separation = 0.1;
inline constexpr double apart_separation = 0.5;
/// The same for lobes whose planes differ by the greater angle or more: joined only where there is
/// hardly a valley (rough profiles have many), strangers once they are apart.
inline constexpr double steep_join_separation = -0.9;
inline constexpr double steep_apart_separation = 0.0;
/// From the one angle to the other the limits move, rad. Tilting two lobes by half the lesser angle
/// changes distances by 1 - cos = 0.5 %, by half the greater one 1 %.
inline constexpr double same_plane_angle = 0.2;
inline constexpr double other_plane_angle = 0.3;
/// Penetration below this share of the deepest is outside contact (Kik & Piotrowski: the virtual
/// penetration is 0.55 of the approach).
inline constexpr double outside_contact_share = 0.45;
/// By how much a top between two nodes may exceed the penetration of both, mm: 0.5 mm of a circle
/// of 1 mm radius.
inline constexpr double max_top_excess = 0.05;

/// Places of the wheel's profile that are no farther apart are one, mm.
inline constexpr double same_place = 1e-6;

template <class Real> Real smoothstep(const Real& t) {
  const Real inside = std::clamp(t, Real(0.0), Real(1.0));
  return inside * inside * (3.0 - 2.0 * inside);
}

/// 0 for lobes that one plane may serve, 1 for those that need planes of their own.
template <class Real> Real turned_apart(const Real& angle_difference) {
  return smoothstep<Real>((abs(angle_difference) - same_plane_angle) /
                          (other_plane_angle - same_plane_angle));
}

/// 1 or more: joined, 0 or less: strangers.
template <class Real> Real affinity(const Real& separation, const Real& angle_difference) {
  const Real turned = turned_apart(angle_difference);
  const Real join = lerp(Real(join_separation), Real(steep_join_separation), turned);
  const Real apart = lerp(Real(apart_separation), Real(steep_apart_separation), turned);
  return (apart - separation) / (apart - join);
}

/// A place of the locus.
template <class Real> struct Place {
  Real x;
  Real y;
  Real z; ///< of the rail
  Real s;
  Real penetration;  ///< vertical, < 0 outside
  Real slope;        ///< of the rail
  Real curvature;    ///< of the wheel in rolling direction
  bool top;          ///< a local maximum: a parabola to both sides
  Real second = 0.0; ///< derivative of the penetration
};

/// Sums over places, weighted.
template <class Real> struct Moments {
  Real weight = 0.0;
  Real cosine = 0.0;
  Real sine = 0.0;
  Real x = 0.0;
  Real y = 0.0;
  Real s = 0.0;

  void add(const Real& share, const Moments& other) {
    weight += share * other.weight;
    cosine += share * other.cosine;
    sine += share * other.sine;
    x += share * other.x;
    y += share * other.y;
    s += share * other.s;
  }
  [[nodiscard]] Real angle() const { return atan2(sine, cosine); }
};

/// Penetration from one local minimum to the next.
template <class Real> struct Lobe {
  std::size_t first_place; ///< of the places, inclusive
  std::size_t last_place;
  Real y_first;
  Real y_last;
  Real z_first;
  Real z_last;
  Real x_first;
  Real x_last;
  Real half_length;
  Place<Real> deepest;
  Moments<Real> moments;
  Real angle;
  Real width;            ///< along the tangent
  Real penetration_next; ///< least one towards the next lobe; 0 if they are apart
  int joined = 1;        ///< lobes in it

  /// Takes in the next one.
  void join(const Lobe& next) {
    last_place = next.last_place;
    joined += next.joined;
    if (next.y_first < y_first) {
      y_first = next.y_first;
      z_first = next.z_first;
    }
    if (next.y_last > y_last) {
      y_last = next.y_last;
      z_last = next.z_last;
    }
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
    width = (y_last - y_first) / cos(angle);
  }
};

/// By how much penetration half way between two places exceeds their mean, times four: that of a
/// parabola with the lesser curvature of the two, without a top of its own in between.
template <class Real> Real bulge_between(const Place<Real>& from, const Place<Real>& to) {
  const Real drop = abs(to.penetration - from.penetration);
  if (from.top || to.top) {
    return drop;
  }
  if (from.second * to.second <= 0.0) {
    return 0.0;
  }
  const Real second = abs(from.second) < abs(to.second) ? from.second : to.second;
  const Real length = to.y - from.y;
  return std::clamp(-0.5 * length * length * second, -drop, drop);
}

/// The share of the way from one place to a lower one after which penetration is down to a level:
/// root of higher - drop t + bulge t (1 - t) = level.
template <class Real>
Real way_down(const Place<Real>& higher, const Place<Real>& lower, const Real& bulge,
              const Real& level) {
  const Real above = higher.penetration - level;
  const Real slope = higher.penetration - lower.penetration - bulge;
  return 2.0 * above / (slope + sqrt(std::max(slope * slope + 4.0 * bulge * above, Real(0.0))));
}

/// Between two places; penetration and top are left to the caller.
template <class Real>
Place<Real> between(const Place<Real>& from, const Place<Real>& to, const Real& share) {
  return {lerp(from.x, to.x, share),
          lerp(from.y, to.y, share),
          lerp(from.z, to.z, share),
          lerp(from.s, to.s, share),
          Real(0.0),
          lerp(from.slope, to.slope, share),
          lerp(from.curvature, to.curvature, share),
          false,
          Real(0.0)};
}

/// Second derivative by differences.
template <class Real>
void set_second(const Place<Real>& before, Place<Real>& here, const Place<Real>& after) {
  const Real length_before = here.y - before.y;
  const Real length_after = after.y - here.y;
  if (length_before > 0.0 && length_after > 0.0) {
    here.second = 2.0 *
                  ((after.penetration - here.penetration) / length_after -
                   (here.penetration - before.penetration) / length_before) /
                  (length_before + length_after);
  }
}

/// Finds the patches of a scan. `Source` knows the numbers and gives the places:
///   using Real = double or one with rates;
///   Place<Real> place_of(const DistanceSample&, double limit): of a node, penetration = limit -
///   distance;
///   Place<Real> place_of(const ContactCandidate&, double penetration): of a locally least
///   distance.
template <class Source> class PatchFinder {
public:
  using Real = typename Source::Real;

  PatchFinder(const ContactScan& scan, double depth, double joining_distance, const Source& source)
      : samples_(scan.samples), source_(source), depth_(depth), joining_distance_(joining_distance),
        limit_(scan.candidates.front().distance + depth), reach_scale_(1.0 / std::sqrt(depth)) {
    for (const ContactCandidate& candidate : scan.candidates) {
      if (candidate.distance <= limit_) {
        tops_.push_back({&candidate, node_after(candidate), &candidate == scan.candidates.data()});
      }
    }
    std::sort(tops_.begin(), tops_.end(), [](const Top& one, const Top& other) {
      return one.contact->wheel.lateral < other.contact->wheel.lateral;
    });
  }

  ContactPatches find() {
    collect_places();
    find_lobes();
    join_lobes();
    ContactPatches result;
    Real weight = 0.0;
    for (const Lobe<Real>& lobe : lobes_) {
      weight += lobe.moments.weight;
    }
    result.patches.reserve(lobes_.size());
    result.links.reserve(lobes_.size());
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
      ContactPatch patch = patch_of(lobes_[k]);
      patch.weight = value_of(lobes_[k].moments.weight / weight);
      if (k > 0) {
        const double border = 0.5 * (patch.y_first + result.patches.back().y_last);
        result.patches.back().limit_last = patch.limit_first = border;
        link_with_next(k - 1);
        result.links.push_back(value_of(links_.back()));
        patch.shares_plane_with_previous = value_of(turns_.back()) >= 1.0;
      }
      if (lobes_[k].first_place <= contact_place_ && contact_place_ <= lobes_[k].last_place) {
        result.main = k;
      }
      result.patches.push_back(patch);
    }
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
      // All in one plane have the same angle, to the last bit.
      angles_.push_back(result.patches[k].shares_plane_with_previous ? angles_.back()
                                                                     : turned_angle(k));
      result.patches[k].angle = value_of(angles_.back());
    }
    return result;
  }

  // Of the patches found, in their order.
  /// Closeness of a patch and the next.
  [[nodiscard]] const Real& link(std::size_t patch) const { return links_[patch]; }
  [[nodiscard]] const Real& angle(std::size_t patch) const { return angles_[patch]; }
  [[nodiscard]] const Moments<Real>& moments(std::size_t patch) const {
    return lobes_[patch].moments;
  }

private:
  /// A locally least distance, which is known better than the nodes of the scan tell.
  struct Top {
    const ContactCandidate* contact;
    std::size_t after; ///< the first sample beyond it
    bool is_first;     ///< the least of all
  };

  [[nodiscard]] std::size_t node_after(const ContactCandidate& contact) const {
    const double s = contact.wheel.lateral;
    const auto after =
        std::lower_bound(samples_.begin(), samples_.end(), s, [](const auto& sample, double at) {
          return sample.wheel.lateral < at - same_place;
        });
    return static_cast<std::size_t>(after - samples_.begin());
  }

  /// Whether a top lies just before or just beyond a sample.
  [[nodiscard]] bool beside_top(std::size_t sample) const {
    return std::any_of(tops_.begin(), tops_.end(), [sample](const Top& top) {
      return sample == top.after || sample + 1 == top.after;
    });
  }

  void collect_top(const Top& top) {
    contact_place_ = top.is_first ? places_.size() : contact_place_;
    places_.push_back(
        source_.place_of(*top.contact, top.is_first ? depth_ : limit_ - top.contact->distance));
  }

  /// All stretches of the scan in which there may be penetration.
  void collect_places() {
    const std::size_t count = samples_.size();
    const double least_distance = limit_ + max_top_excess;
    const auto belongs = [&](std::size_t sample) {
      return samples_[sample].distance < least_distance || beside_top(sample);
    };
    std::size_t i = 0;
    while (i < count) {
      if (!belongs(i)) {
        ++i;
        continue;
      }
      const std::size_t first = i > 0 ? i - 1 : 0;
      while (i < count && belongs(i)) {
        ++i;
      }
      collect_run(first, std::min(i, count - 1));
    }
    for (const Top& top : tops_) {
      if (top.after == count) {
        collect_top(top); // beyond the last node: the run before has ended with it
      }
    }
  }

  void collect_run(std::size_t first, std::size_t last) {
    const std::size_t from = places_.size();
    auto top = std::find_if(tops_.begin(), tops_.end(),
                            [first](const Top& one) { return one.after >= first; });
    for (std::size_t i = first; i <= last; ++i) {
      bool is_node = false;
      for (; top != tops_.end() && top->after == i; ++top) {
        collect_top(*top);
        is_node = is_node || samples_[i].wheel.lateral - top->contact->wheel.lateral <= same_place;
      }
      if (is_node) {
        continue;
      }
      places_.push_back(source_.place_of(samples_[i], limit_));
      if (places_.size() >= from + 3) {
        add_top();
      }
    }
    for (std::size_t i = from + 1; i + 1 < places_.size(); ++i) {
      set_second(places_[i - 1], places_[i], places_[i + 1]);
    }
  }

  /// The top of the parabola through the last three places, if the middle one is the highest.
  void add_top() {
    const auto middle = places_.end() - 2;
    const Place<Real> before = *(middle - 1);
    const Place<Real> here = *middle;
    const Place<Real> after = *(middle + 1);
    const Real length_before = here.y - before.y;
    const Real length_after = after.y - here.y;
    if (here.top || here.penetration < before.penetration ||
        here.penetration <= after.penetration || !(length_before > 0.0 && length_after > 0.0)) {
      return;
    }
    const Real slope_before = (here.penetration - before.penetration) / length_before;
    const Real slope_after = (after.penetration - here.penetration) / length_after;
    const Real length = length_before + length_after;
    const Real slope = (slope_before * length_after + slope_after * length_before) / length;
    const Real way = 0.5 * slope * length / (slope_before - slope_after);
    Place<Real> top = way < 0.0 ? between(here, before, -way / length_before)
                                : between(here, after, way / length_after);
    // No place is deeper than the first contact.
    top.penetration = std::min<Real>(here.penetration + 0.5 * slope * way, Real(depth_));
    top.top = true;
    places_.insert(way < 0.0 ? middle : middle + 1, top);
  }

  /// What a place counts per length in y; also its reach along the rail.
  Moments<Real> density(const Place<Real>& place, Lobe<Real>& lobe) const {
    if (!(place.penetration > 0.0)) {
      return {}; // an end, or where the parabola between two ends dips out of the rail
    }
    const Real cosine = 1.0 / sqrt(1.0 + place.slope * place.slope);
    const Real reach = sqrt(place.penetration * cosine / place.curvature);
    const Real half_length = std::numbers::sqrt2 * reach;
    lobe.half_length = std::max(lobe.half_length, half_length);
    lobe.x_first = std::min(lobe.x_first, place.x - half_length);
    lobe.x_last = std::max(lobe.x_last, place.x + half_length);
    // g^2 x_l dy, made free of the depth's magnitude.
    const Real relative = place.penetration / depth_;
    const Real weight = relative * relative * reach * reach_scale_;
    return {weight,           weight * cosine,  weight * place.slope * cosine,
            weight * place.x, weight * place.y, weight * place.s};
  }

  void begin_lobe(std::size_t place, const Place<Real>& begin) {
    Lobe<Real> lobe{};
    lobe.first_place = place;
    lobe.y_first = begin.y;
    lobe.z_first = lobe.z_last = begin.z;
    lobe.x_first = lobe.x_last = begin.x;
    lobe.deepest = begin;
    lobe.moments = {};
    begin_density_ = density(begin, lobe);
    lobes_.push_back(lobe);
  }

  /// Simpson's rule from where the last one ended.
  void add_to_lobe(const Place<Real>& from, const Place<Real>& to, const Real& length,
                   const Real& bulge) {
    Lobe<Real>& lobe = lobes_.back();
    Place<Real> middle = between(from, to, Real(0.5));
    middle.penetration = 0.5 * (from.penetration + to.penetration) + 0.25 * bulge;
    const Moments<Real> end = density(to, lobe);
    lobe.moments.add(length / 6.0, begin_density_);
    lobe.moments.add(length * 4.0 / 6.0, density(middle, lobe));
    lobe.moments.add(length / 6.0, end);
    begin_density_ = end;
    if (to.penetration > lobe.deepest.penetration) {
      lobe.deepest = to;
    }
    lobe.y_last = to.y;
    lobe.z_last = to.z;
  }

  void find_lobes() {
    bool open = false;
    bool falling = false;
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      Place<Real> from = places_[i];
      Place<Real> to = places_[i + 1];
      Real bulge = bulge_between(from, to);
      Real length = abs(to.y - from.y);
      if (from.penetration <= 0.0 && to.penetration <= 0.0) {
        open = false;
        continue;
      }
      const bool rising = to.penetration > from.penetration;
      bool ends = false;
      if (from.penetration <= 0.0) {
        const Real share = way_down(to, from, bulge, Real(0.0));
        from = between(to, from, share);
        length *= share;
        bulge *= share * share;
        open = false;
      } else if (to.penetration <= 0.0) {
        const Real share = way_down(from, to, bulge, Real(0.0));
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
    for (Lobe<Real>& lobe : lobes_) {
      if (!(lobe.moments.weight > 0.0)) {
        // No width that a number could tell from nothing.
        lobe.moments.add(std::numeric_limits<double>::epsilon(), density(lobe.deepest, lobe));
      }
      lobe.settle();
    }
  }

  Real affinity_with_next(std::size_t lobe) const {
    const Lobe<Real>& first = lobes_[lobe];
    const Lobe<Real>& second = lobes_[lobe + 1];
    const Real separation =
        first.penetration_next > 0.0
            ? -first.penetration_next /
                  std::min(first.deepest.penetration, second.deepest.penetration)
            : (second.y_first - first.y_last) /
                  std::max({first.width, second.width, Real(std::numeric_limits<double>::min())});
    return affinity<Real>(separation, second.angle - first.angle);
  }

  /// How far apart the penetrations of a lobe and the next are, across the rail.
  Real distance_to_next(std::size_t lobe) const {
    const Lobe<Real>& first = lobes_[lobe];
    const Lobe<Real>& second = lobes_[lobe + 1];
    if (first.penetration_next > 0.0) {
      return 0.0;
    }
    const Real across = second.y_first - first.y_last;
    const Real up = second.z_first - first.z_last;
    return sqrt(across * across + up * up);
  }

  /// Closeness of a patch and the next, and how far their planes turn towards each other.
  void link_with_next(std::size_t lobe) {
    Real link = smoothstep(affinities_[lobe]);
    Real turn = link;
    if (joining_distance_ > 0.0) {
      const Real one_plane = 1.0 - turned_apart<Real>(lobes_[lobe + 1].angle - lobes_[lobe].angle);
      const Real distances = distance_to_next(lobe) / joining_distance_;
      link = std::max(link, one_plane * std::clamp<Real>(2.0 - distances, 0.0, 1.0));
      turn = std::max(turn, one_plane * std::clamp<Real>(3.0 - distances, 0.0, 1.0));
    }
    links_.push_back(link);
    turns_.push_back(turn);
  }

  /// Joins neighbours, the closest ones first, until none are left that belong together.
  void join_lobes() {
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
        Lobe<Real> lobe = lobes_[k];
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
  void find_contact_ends(const Lobe<Real>& lobe, ContactPatch& patch) const {
    const Real level = outside_contact_share * lobe.deepest.penetration;
    const auto end = [&](std::size_t inside, std::size_t outside, bool at_end) -> Place<Real> {
      const Place<Real>& here = places_[inside];
      if (at_end) {
        return here;
      }
      const Place<Real>& beyond = places_[outside];
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
    const Place<Real> begin = end(first, first - 1, first == lobe.first_place);
    const Place<Real> finish = end(last, last + 1, last == lobe.last_place);
    patch.contact_first = value_of(begin.y);
    patch.contact_last = value_of(finish.y);
    patch.angle_first = value_of(atan(begin.slope));
    patch.angle_last = value_of(atan(finish.slope));
  }

  ContactPatch patch_of(const Lobe<Real>& lobe) const {
    ContactPatch patch;
    patch.lobes = lobe.joined;
    patch.y_first = value_of(lobe.y_first);
    patch.y_last = value_of(lobe.y_last);
    patch.x_first = value_of(lobe.x_first);
    patch.x_last = value_of(lobe.x_last);
    patch.half_length = value_of(lobe.half_length);
    patch.deepest = value_of(lobe.deepest.penetration);
    patch.deepest_y = value_of(lobe.deepest.y);
    patch.deepest_s = value_of(lobe.deepest.s);
    patch.angle_unturned = value_of(lobe.angle);
    patch.mean_x = value_of(lobe.moments.x / lobe.moments.weight);
    patch.mean_y = value_of(lobe.moments.y / lobe.moments.weight);
    patch.mean_s = value_of(lobe.moments.s / lobe.moments.weight);
    find_contact_ends(lobe, patch);
    return patch;
  }

  /// Mean over all levels from 0 to 1 of the plane of those that turn that far towards each other.
  Real turned_angle(std::size_t lobe) const {
    std::size_t first = lobe;
    std::size_t last = lobe;
    Moments<Real> cluster = lobes_[lobe].moments;
    Real level = 1.0;
    Real angle = 0.0;
    while (level > 0.0) {
      const Real before = first > 0 ? turns_[first - 1] : Real(0.0);
      const Real after = last < turns_.size() ? turns_[last] : Real(0.0);
      const Real next = std::min(level, std::max(before, after));
      angle += (level - next) * cluster.angle();
      level = next;
      if (next > 0.0) {
        cluster.add(1.0, lobes_[before >= after ? --first : ++last].moments);
      }
    }
    return angle;
  }

  const std::vector<DistanceSample>& samples_;
  const Source& source_;
  double depth_;
  double joining_distance_;
  double limit_;
  std::vector<Place<Real>> places_; ///< stretches that hold penetration and one place more each end
  std::size_t contact_place_ = 0;   ///< of the first contact
  std::vector<Top> tops_;           ///< along the profile
  double reach_scale_;              ///< makes weights free of the depth's magnitude
  Moments<Real> begin_density_;     ///< where the next stretch of a lobe begins
  std::vector<Real> affinities_;    ///< of each lobe and the next
  std::vector<Lobe<Real>> lobes_;
  std::vector<Real> links_;  ///< coupling weight of each patch and the next
  std::vector<Real> turns_;  ///< likewise, of their planes
  std::vector<Real> angles_; ///< of the planes
};

} // namespace wrc::patch_finding
