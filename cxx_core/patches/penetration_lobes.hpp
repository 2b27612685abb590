/// Lobes of penetration: stretches of the contact locus from one local minimum to the next.
///
/// Each with the integrals over its samples that planes are made of (contact_patches.hpp), by
/// Simpson's rule.
/// Units mm and rad; track frame, left-hand side (geometry/frames.hpp).
/// Thread rule: one object, one thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "patches/locus_samples.hpp"

namespace wrc::patch_finding {

/// Weighted sums over points.
template <class Real> struct Moments {
  Real weight = 0.0;
  Real cosine = 0.0;
  Real sine = 0.0;
  Real x = 0.0;
  Real y = 0.0;
  Real s = 0.0;
  Real rise = 0.0;
  Real ahead = 0.0;

  void add(const Real& share, const Moments& other) {
    weight += share * other.weight;
    cosine += share * other.cosine;
    sine += share * other.sine;
    x += share * other.x;
    y += share * other.y;
    s += share * other.s;
    rise += share * other.rise;
    ahead += share * other.ahead;
  }
  [[nodiscard]] Real angle() const { return atan2(sine, cosine); }
  /// Standard deviation of the angle, from the length of the mean direction (K. V. Mardia,
  /// Statistics of Directional Data, 1972, ch. 2).
  [[nodiscard]] double deviation() const {
    const double length = std::hypot(value_of(cosine), value_of(sine)) / value_of(weight);
    return length < 1.0 ? std::sqrt(-2.0 * std::log(length)) : 0.0;
  }
};

/// Penetration from one local minimum to the next.
template <class Real> struct Lobe {
  std::size_t first_place; ///< of the points, inclusive
  std::size_t last_place;
  Real y_first;
  Real y_last;
  Real z_first;
  Real z_last;
  Real x_first;
  Real x_last;
  Real half_length;
  LocusSample<Real> deepest;
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

template <class Real> class LobeFinder {
public:
  /// `places` must outlive the finder.
  LobeFinder(const std::vector<LocusSample<Real>>& places, std::size_t contact_place, double depth)
      : places_(places), contact_place_(contact_place), depth_(depth),
        reach_scale_(1.0 / std::sqrt(depth)) {}

  std::vector<Lobe<Real>> find() {
    find_lobes();
    return std::move(lobes_);
  }

private:
  /// Where the rail's normal through a point of the wheel meets the rail: under a contact angle
  /// that is not where the vertical does.
  struct Partner {
    Real y;
    Real slope;
    Real cosine;
    Real overlap; ///< along that normal
  };
  /// As if that were where the vertical does.
  static Partner below(const LocusSample<Real>& place) {
    const Real cosine = 1.0 / sqrt(1.0 + place.slope * place.slope);
    return {place.y, place.slope, cosine, place.penetration * cosine};
  }
  static Partner partner_of(const LocusSample<Real>& place) {
    Partner partner = below(place);
    if (place.penetration > 0.0) {
      const Real across = partner.overlap * partner.slope * partner.cosine;
      partner.y = place.y - across;
      partner.slope = place.slope - across * place.slope_rate;
      partner.cosine = 1.0 / sqrt(1.0 + partner.slope * partner.slope);
      partner.overlap = place.penetration * partner.cosine;
    }
    return partner;
  }

  /// Weight of a point per length in y of its partner; also its reach along the rail.
  Moments<Real> density(const LocusSample<Real>& place, const Partner& partner,
                        Lobe<Real>& lobe) const {
    if (!(place.penetration > 0.0)) {
      return {}; // an end, or where the cubic between two ends dips out of the rail
    }
    const Real reach = sqrt(partner.overlap / place.curvature);
    const Real half_length = std::numbers::sqrt2 * reach;
    lobe.half_length = std::max(lobe.half_length, half_length);
    lobe.x_first = std::min(lobe.x_first, place.x - half_length);
    lobe.x_last = std::max(lobe.x_last, place.x + half_length);
    // g^2 x_l ds, made free of the depth's magnitude.
    const Real relative = partner.overlap / depth_;
    const Real level = relative * relative * reach * reach_scale_;
    const Real weight = level / partner.cosine;
    return {weight,
            level,
            level * partner.slope,
            weight * place.x,
            weight * partner.y,
            weight * place.s,
            level * place.rise,
            weight * place.ahead};
  }

  void begin_lobe(std::size_t place, const LocusSample<Real>& begin) {
    Lobe<Real> lobe{};
    lobe.first_place = place;
    lobe.y_first = begin.y;
    lobe.z_first = lobe.z_last = begin.z;
    lobe.x_first = lobe.x_last = begin.x;
    lobe.deepest = begin;
    lobe.moments = {};
    begin_partner_ = partner_of(begin);
    begin_density_ = density(begin, begin_partner_, lobe);
    lobes_.push_back(lobe);
  }

  /// Simpson's rule from where the last one ended.
  void add_to_lobe(const LocusSample<Real>& middle, const LocusSample<Real>& to) {
    Lobe<Real>& lobe = lobes_.back();
    const Partner end_partner = partner_of(to);
    const Moments<Real> end = density(to, end_partner, lobe);
    const Real length = abs(end_partner.y - begin_partner_.y);
    lobe.moments.add(length / 6.0, begin_density_);
    lobe.moments.add(length * 4.0 / 6.0, density(middle, partner_of(middle), lobe));
    lobe.moments.add(length / 6.0, end);
    begin_density_ = end;
    begin_partner_ = end_partner;
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
      if (places_[i].penetration <= 0.0 && places_[i + 1].penetration <= 0.0) {
        open = false;
        continue;
      }
      LocusSample<Real> from = places_[i];
      LocusSample<Real> to = places_[i + 1];
      const bool rising = to.penetration > from.penetration;
      const bool ends = from.penetration > 0.0 && to.penetration <= 0.0;
      Real first = 0.0;
      Real last = 1.0;
      if (from.penetration <= 0.0) {
        first = 1.0 - Rise<Real>(to, from).way_down(Real(0.0));
        from = between(places_[i], to, first);
        open = false;
      } else if (ends) {
        last = Rise<Real>(from, to).way_down(Real(0.0));
        to = between(from, to, last);
      }
      const Real half = 0.5 * (first + last);
      LocusSample<Real> middle = between(places_[i], places_[i + 1], half);
      middle.penetration = Rise<Real>(places_[i], places_[i + 1]).at(half);
      if (!open) {
        falling = false;
        begin_lobe(i, from);
      } else if (falling && rising) {
        lobes_.back().penetration_next = from.penetration;
        begin_lobe(i, from);
      }
      add_to_lobe(middle, to);
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
        // A width of zero, up to rounding.
        lobe.moments.add(std::numeric_limits<double>::epsilon(),
                         density(lobe.deepest, below(lobe.deepest), lobe));
      }
      lobe.settle();
    }
  }

  const std::vector<LocusSample<Real>>& places_;
  std::size_t contact_place_;
  double depth_;
  double reach_scale_;          ///< makes weights free of the depth's magnitude
  Moments<Real> begin_density_; ///< where the next stretch of a lobe begins
  Partner begin_partner_;
  std::vector<Lobe<Real>> lobes_;
};

} // namespace wrc::patch_finding
