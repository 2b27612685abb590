/// Samples of the contact locus where wheel and rail may interpenetrate.
///
/// Nodes of the scan and its locally least distances: tops, which are known more accurately than
/// from nodes. Penetration between two samples is a parabola. For plain numbers and for numbers
/// with rates (base/value_with_rates.hpp). Units mm and rad; track frame, left-hand side
/// (geometry/frames.hpp). Thread rule: one object, one thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/value_with_rates.hpp"
#include "geometry/constants.hpp"
#include "geometry/contact_search.hpp"
#include "patches/constants.hpp"

namespace wrc::patch_finding {

// Found by argument for numbers with rates.
using std::abs;
using std::atan;
using std::atan2;
using std::cos;
using std::lerp;
using std::sqrt;

/// A sample of the locus.
template <class Real> struct LocusSample {
  Real x;
  Real y;
  Real z; ///< of the rail
  Real s;
  Real penetration;      ///< vertical, < 0 outside
  Real slope;            ///< of the rail
  Real curvature;        ///< of the wheel in rolling direction; LocusSampler: along the rail
  bool top;              ///< a local maximum: a parabola to both sides
  Real second = 0.0;     ///< derivative of the penetration
  Real slope_rate = 0.0; ///< of the rail's slope, by y
  Real rise = 0.0;       ///< slope of the rail along the track
  Real ahead = 0.0;      ///< of where a round wheel is nearest on a prismatic rail
};

/// From the curvature in rolling direction to that of distances along the rail. With yaw these
/// cross the profile: where z = x'^2/(2 R) + f(y') is turned by the yaw, it follows from dz/dx = 0
/// along the locus that the curvature is k/(1 - tan(yaw) dx/dy) on it.
template <class Real>
void turn_curvature(const LocusSample<Real>& before, LocusSample<Real>& here,
                    const LocusSample<Real>& after, const Real& yaw_tangent) {
  const Real length = after.y - before.y;
  if (abs(length) > same_place) {
    const Real turn = 1.0 - yaw_tangent * (after.x - before.x) / length;
    here.curvature = here.curvature / std::clamp<Real>(turn, 1.0 / max_turn, max_turn);
  }
}

/// By how much penetration half way between two points exceeds their mean, times four: that of a
/// parabola with the lesser curvature of the two, without a maximum in between.
template <class Real>
Real bulge_between(const LocusSample<Real>& from, const LocusSample<Real>& to) {
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

/// The fraction of the way from one point to a lower one at which penetration falls to a level:
/// root of higher - drop t + bulge t (1 - t) = level.
template <class Real>
Real way_down(const LocusSample<Real>& higher, const LocusSample<Real>& lower, const Real& bulge,
              const Real& level) {
  const Real above = higher.penetration - level;
  const Real slope = higher.penetration - lower.penetration - bulge;
  return 2.0 * above / (slope + sqrt(std::max(slope * slope + 4.0 * bulge * above, Real(0.0))));
}

/// Between two points; penetration and top are left to the caller.
template <class Real>
LocusSample<Real> between(const LocusSample<Real>& from, const LocusSample<Real>& to,
                          const Real& share) {
  // Quicker than std::lerp, whose care at the ends is for nothing here.
  const auto mix = [&share](const Real& a, const Real& b) { return Real(a + share * (b - a)); };
  return {mix(from.x, to.x),
          mix(from.y, to.y),
          mix(from.z, to.z),
          mix(from.s, to.s),
          Real(0.0),
          mix(from.slope, to.slope),
          mix(from.curvature, to.curvature),
          false,
          Real(0.0),
          mix(from.slope_rate, to.slope_rate),
          mix(from.rise, to.rise),
          mix(from.ahead, to.ahead)};
}

/// Derivatives by differences.
template <class Real>
void set_derivatives(const LocusSample<Real>& before, LocusSample<Real>& here,
                     const LocusSample<Real>& after) {
  const Real length_before = here.y - before.y;
  const Real length_after = after.y - here.y;
  if (length_before > 0.0 && length_after > 0.0) {
    here.second = 2.0 *
                  ((after.penetration - here.penetration) / length_after -
                   (here.penetration - before.penetration) / length_before) /
                  (length_before + length_after);
  }
  const Real length = after.y - before.y;
  if (abs(length) > same_place) {
    here.slope_rate = (after.slope - before.slope) / length;
  }
}

/// Collects the samples of a scan at a depth. `Source` knows the numbers and gives the samples:
///   using Real = double or one with rates;
///   LocusSample<Real> place_of(const DistanceSample&, double limit): of a node, penetration =
///   limit - distance;
///   LocusSample<Real> place_of(const ContactCandidate&, double penetration): of a locally least
///   distance;
///   Real yaw_tangent().
template <class Source> class LocusSampler {
public:
  using Real = typename Source::Real;

  LocusSampler(const ContactScan& scan, double depth, const Source& source)
      : samples_(scan.samples), source_(source), depth_(depth),
        limit_(scan.candidates.front().distance + depth) {
    for (const ContactCandidate& candidate : scan.candidates) {
      if (candidate.distance <= limit_) {
        tops_.push_back({&candidate, node_after(candidate), &candidate == scan.candidates.data()});
      }
    }
    std::sort(tops_.begin(), tops_.end(), [](const Top& one, const Top& other) {
      return one.contact->wheel.lateral < other.contact->wheel.lateral;
    });
    collect_places();
  }

  /// Stretches that hold penetration, and one sample more at each end.
  [[nodiscard]] const std::vector<LocusSample<Real>>& samples() const { return places_; }
  /// Index of the first contact.
  [[nodiscard]] std::size_t first_contact() const { return contact_place_; }

private:
  /// A local minimum of the distance, known more accurately than from the nodes of the scan.
  struct Top {
    const ContactCandidate* contact;
    std::size_t after; ///< the first sample beyond it
    bool is_first;     ///< the least of all
  };

  [[nodiscard]] std::size_t node_after(const ContactCandidate& contact) const {
    const auto after = std::partition_point(
        samples_.begin(), samples_.end(), [&contact](const DistanceSample& sample) {
          const double s = sample.wheel.lateral - contact.wheel.lateral;
          const double y = sample.wheel.position.y - contact.wheel.position.y;
          return s < -same_place || (s <= same_place && y < -same_place); // several on a ridge
        });
    return static_cast<std::size_t>(after - samples_.begin());
  }

  static bool is_same(const LocusPlace& one, const LocusPlace& other) {
    return std::abs(one.lateral - other.lateral) <= same_place &&
           std::abs(one.position.y - other.position.y) <= same_place;
  }

  /// No point is deeper than the first contact, except for rounding: at the least depths only
  /// rounding would remain.
  void place(LocusSample<Real> sample) {
    if (sample.penetration > depth_) {
      sample.penetration = depth_;
    }
    places_.push_back(sample);
  }

  void collect_top(const Top& top) {
    contact_place_ = top.is_first ? places_.size() : contact_place_;
    place(source_.place_of(*top.contact, top.is_first ? depth_ : limit_ - top.contact->distance));
  }

  /// All stretches of the scan in which there may be penetration.
  void collect_places() {
    const std::size_t count = samples_.size();
    const double least_distance = limit_ + max_top_excess;
    auto next = tops_.begin();
    const auto belongs = [&](std::size_t sample) { // asked in their order
      while (next != tops_.end() && next->after < sample) {
        ++next;
      }
      const bool beside_top = next != tops_.end() && next->after <= sample + 1;
      return beside_top || samples_[sample].distance < least_distance;
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
    places_.reserve(from + last - first + 1 + tops_.size());
    auto top = std::find_if(tops_.begin(), tops_.end(),
                            [first](const Top& one) { return one.after >= first; });
    for (std::size_t i = first; i <= last; ++i) {
      bool is_node = false;
      for (; top != tops_.end() && top->after == i; ++top) {
        collect_top(*top);
        is_node = is_node || is_same(samples_[i].wheel, top->contact->wheel);
      }
      if (!is_node) {
        place(source_.place_of(samples_[i], limit_));
      }
    }
    for (std::size_t i = from; i < places_.size(); ++i) {
      const LocusSample<Real>& before = places_[std::max(i, from + 1) - 1];
      const LocusSample<Real>& after = places_[std::min(i + 1, places_.size() - 1)];
      set_derivatives(before, places_[i], after);
      turn_curvature<Real>(before, places_[i], after, source_.yaw_tangent());
    }
  }

  const std::vector<DistanceSample>& samples_;
  const Source& source_;
  double depth_;
  double limit_;
  std::vector<LocusSample<Real>> places_;
  std::size_t contact_place_ = 0;
  std::vector<Top> tops_; ///< along the profile
};

} // namespace wrc::patch_finding
