/// The search behind patches/contact_patches.hpp, for plain numbers and for numbers with rates.
///
/// That header says what is found, and how. The same statements run on values that carry
/// derivatives (base/value_with_rates.hpp), which gives the rates of the planes
/// (derivatives/plane_rates.hpp); all decisions are those of the values. Units mm and rad; track
/// frame, left-hand side (geometry/frames.hpp). Thread rule: one object, one thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/smoothstep.hpp"
#include "patches/constants.hpp"
#include "patches/contact_patch.hpp"
#include "patches/locus_samples.hpp"
#include "patches/penetration_lobes.hpp"

namespace wrc::patch_finding {

/// 0 for lobes that one plane may serve, 1 for those that need planes of their own.
template <class Real> Real turned_apart(const Real& angle_difference) {
  return smoothstep<Real>((abs(angle_difference) - same_plane_angle) /
                          (other_plane_angle - same_plane_angle));
}

/// 1 or more: joined, 0 or less: independent.
template <class Real> Real affinity(const Real& separation, const Real& angle_difference) {
  const Real turned = turned_apart(angle_difference);
  const Real join = lerp(Real(joined_below), Real(steep_joined_below), turned);
  const Real apart = lerp(Real(apart_above), Real(steep_apart_above), turned);
  return (apart - separation) / (apart - join);
}

/// Finds the patches of a scan. `Source`: see LocusSampler.
template <class Source> class PatchFinder {
public:
  using Real = typename Source::Real;

  PatchFinder(const ContactScan& scan, double depth, const PatchOptions& options,
              const Source& source)
      : joining_distance_(options.joining_distance), sampler_(scan, depth, source),
        places_(sampler_.samples()), contact_place_(sampler_.first_contact()),
        lobes_(LobeFinder<Real>(places_, contact_place_, depth).find()) {}

  ContactPatches find() {
    join_lobes();
    ContactPatches result;
    Real weight = 0.0;
    for (const Lobe<Real>& lobe : lobes_) {
      weight += lobe.moments.weight;
    }
    result.weight = value_of(weight);
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

  // Coupling weights of the patches found, in their order.
  /// Coupling weight of a patch and the next.
  [[nodiscard]] const Real& link(std::size_t patch) const { return links_[patch]; }
  [[nodiscard]] const Real& angle(std::size_t patch) const { return angles_[patch]; }
  [[nodiscard]] const Moments<Real>& moments(std::size_t patch) const {
    return lobes_[patch].moments;
  }
  [[nodiscard]] const Lobe<Real>& lobes(std::size_t patch) const { return lobes_[patch]; }

private:
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

  /// Coupling weight of a patch and the next, and how far their planes turn towards each other.
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
    const auto end = [&](std::size_t inside, std::size_t outside,
                         bool at_end) -> LocusSample<Real> {
      const LocusSample<Real>& here = places_[inside];
      if (at_end) {
        return here;
      }
      const LocusSample<Real>& beyond = places_[outside];
      return between(here, beyond, Rise<Real>(here, beyond).way_down(level));
    };
    std::size_t first = lobe.first_place;
    while (first < lobe.last_place && places_[first].penetration < level) {
      ++first;
    }
    std::size_t last = lobe.last_place;
    while (last > lobe.first_place && places_[last].penetration < level) {
      --last;
    }
    const LocusSample<Real> begin = end(first, first - 1, first == lobe.first_place);
    const LocusSample<Real> finish = end(last, last + 1, last == lobe.last_place);
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
    patch.deviation = lobe.moments.deviation();
    patch.rise = value_of(lobe.moments.rise / lobe.moments.weight);
    patch.ahead = value_of(lobe.moments.ahead / lobe.moments.weight);
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
      const Real neighbour = std::max(before, after);
      const Real next = neighbour > 0.0 ? std::min(level, neighbour) : Real(0.0); // not a number: 0
      angle += (level - next) * cluster.angle();
      level = next;
      if (next > 0.0) {
        const bool before_it = first > 0 && (last >= turns_.size() || before >= after);
        cluster.add(1.0, lobes_[before_it ? --first : ++last].moments);
      }
    }
    return angle;
  }

  double joining_distance_;
  LocusSampler<Source> sampler_;
  const std::vector<LocusSample<Real>>& places_;
  std::size_t contact_place_;
  std::vector<Lobe<Real>> lobes_;
  std::vector<Real> affinities_; ///< of each lobe and the next
  std::vector<Real> links_;      ///< coupling weight of each patch and the next
  std::vector<Real> turns_;      ///< likewise, of their planes
  std::vector<Real> angles_;     ///< of the planes
};

} // namespace wrc::patch_finding
