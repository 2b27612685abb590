/// Samples of the contact locus where wheel and rail may interpenetrate.
///
/// Nodes of the scan and its locally least distances: tops, which are known more accurately than
/// from nodes. Between two samples penetration is a cubic with their slopes, so that hardly
/// anything changes where a top appears or vanishes. For plain numbers and for numbers with rates
/// (base/value_with_rates.hpp). Units mm and rad; track frame, left-hand side
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
  Real steepness = 0.0;  ///< derivative of the penetration by y; 0 of a local maximum
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

/// Penetration between two samples: the cubic that has their slopes, as far as these are those of
/// one without a top or a valley in between.
template <class Real> class Rise {
public:
  Rise(const LocusSample<Real>& begin, const LocusSample<Real>& end)
      : from_(begin.penetration), rise_(end.penetration - begin.penetration) {
    const Real length = end.y - begin.y;
    const Real first = monotone(begin.steepness * length);
    const Real last = monotone(end.steepness * length);
    bulge_ = 0.5 * (first - last);
    skew_ = 0.5 * (first + last) - rise_;
  }

  /// At a fraction of the way.
  [[nodiscard]] Real at(const Real& share) const {
    return from_ + share * (rise_ + (1.0 - share) * (bulge_ + skew_ * (1.0 - 2.0 * share)));
  }
  /// The fraction of the way at which penetration falls to a level that lies between its ends, of
  /// which the first is the higher one.
  [[nodiscard]] Real way_down(const Real& level) const {
    const Real above = from_ - level;
    if (!(above > 0.0)) {
      return 0.0;
    }
    // Along the parabola of the higher end, from there by Newton's method within bounds.
    const Real down = -(rise_ + bulge_ + skew_);
    const Real bend = bulge_ + 3.0 * skew_;
    Real share = std::min<Real>(
        2.0 * above / (down + sqrt(std::max<Real>(down * down + 4.0 * bend * above, 0.0))), 1.0);
    Real low = 0.0;
    Real high = 1.0;
    for (int step = 0; step < most_way_down_steps; ++step) {
      const Real excess = at(share) - level;
      (excess > 0.0 ? low : high) = share;
      const Real slope = rise_ + (1.0 - 2.0 * share) * (bulge_ + skew_ * (1.0 - 2.0 * share)) -
                         2.0 * share * (1.0 - share) * skew_;
      const Real by_newton = share - excess / slope;
      const Real next = by_newton > low && by_newton < high ? by_newton : 0.5 * (low + high);
      const bool settled = abs(next - share) <= way_down_tolerance * share;
      share = next;
      if (settled) {
        break;
      }
    }
    return share;
  }

private:
  [[nodiscard]] Real monotone(const Real& slope) const {
    const Real steepest = steepest_monotone * rise_;
    return std::clamp<Real>(slope, std::min<Real>(steepest, 0.0), std::max<Real>(steepest, 0.0));
  }

  Real from_;
  Real rise_;
  Real bulge_; ///< by how much half way exceeds the mean, times four
  Real skew_;  ///< what changes the bulge's sides from end to end
};

/// Between two points; the penetration is left to the caller.
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
          mix(from.steepness, to.steepness),
          mix(from.slope_rate, to.slope_rate),
          mix(from.rise, to.rise),
          mix(from.ahead, to.ahead)};
}

/// By differences.
template <class Real>
void set_slope_rate(const LocusSample<Real>& before, LocusSample<Real>& here,
                    const LocusSample<Real>& after) {
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
      set_slope_rate(before, places_[i], after);
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
