#include "wheel/own_lobes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "base/smoothstep.hpp"
#include "models/elliptic_integrals.hpp"
#include "patches/constants.hpp"
#include "wheel/constants.hpp"

namespace wrc {
namespace {

using patch_finding::LocusSample;

/// Nodes and weights of Gauss' rule over 0 to 1.
/// origin: published: Abramowitz and Stegun, 25.4.30, four nodes.
constexpr std::array<std::pair<double, double>, 4> gauss_nodes{
    {{0.0694318442029737, 0.1739274225687269},
     {0.3300094782075719, 0.3260725774312731},
     {0.6699905217924281, 0.3260725774312731},
     {0.9305681557970263, 0.1739274225687269}}};

/// A sample in the plane of its patch.
struct Place {
  double across = 0.0;
  double along = 0.0;
  double overlap = 0.0; ///< along the rail's normal; < 0 outside
  double curvature = 0.0;
  double y = 0.0;
};

struct OwnLobe {
  double first = 0.0; ///< of the places, in their numbers
  double last = 0.0;
  std::size_t deepest = 0;
  double node_depth = 0.0; ///< largest overlap of a node of the scan, and ...
  double behind = 0.0;     ///< ... the least one towards the next lobe
  int joined = 1;
  double approach = 0.0; ///< e
  double load = 0.0;     ///< over pi E*
  double ratio = 0.0;    ///< of Hertz's axes; 0: not known yet
  double semi_across = 0.0;
  double semi_along = 0.0;
  Place middle;
};

/// What a lobe displaces at a place, mm: a line along the rail with the parabolic loads of Hertz's
/// ellipse, whose width counts by its second moment.
double displacement_by(const OwnLobe& lobe, const Place& at) {
  if (!(lobe.load > 0.0)) {
    return 0.0;
  }
  const double distance = std::max(
      std::hypot(at.across - lobe.middle.across, at.along - lobe.middle.along), lobe.semi_across);
  const double apart = distance / lobe.semi_along;
  const double wide = lobe.semi_across / distance;
  return 0.75 * lobe.load / lobe.semi_along *
         ((2.0 + apart * apart) * std::asinh(1.0 / apart) - std::hypot(1.0, apart)) *
         (1.0 + 0.2 * wide * wide);
}

/// Grids of a patch, and their share of its forces.
struct Way {
  std::vector<ContactPatch> lobes;
  double share = 1.0;
};

class LobesOfPatch {
public:
  LobesOfPatch(const ContactPatch& patch, std::span<const LocusSample<double>> samples)
      : patch_(patch), samples_(samples), cosine_(std::cos(patch.angle)) {
    for (const LocusSample<double>& sample : samples) {
      places_.push_back({sample.y * cosine_ + sample.z * std::sin(patch.angle), sample.x,
                         sample.penetration / std::sqrt(1.0 + sample.slope * sample.slope),
                         sample.curvature, sample.y});
    }
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      bulges_.push_back(patch_finding::bulge_between(samples[i], samples[i + 1]) /
                        std::sqrt(1.0 + samples[i].slope * samples[i].slope));
    }
    find_lobes();
  }

  /// The ways, those with most grids first; the last is one grid.
  std::vector<Way> find() {
    std::vector<Way> ways;
    double left = 1.0;
    while (lobes_.size() > 1 && left > 0.0) {
      settle();
      const std::size_t shallowest = shallowest_valley();
      const double share = left * share_apart(shallowest) * (1.0 - whole());
      if (share > 0.0) {
        std::vector<ContactPatch> found;
        for (std::size_t k = 0; k < lobes_.size(); ++k) {
          if (lobes_[k].approach > -lifted_approach * depth_) {
            found.push_back(patch_of(k));
          }
        }
        if (found.size() < 2) {
          break;
        }
        ways.push_back({std::move(found), share});
        left -= share;
      }
      join_with_next(shallowest);
    }
    ways.push_back({{patch_}, left});
    return ways;
  }

private:
  /// From one local minimum to the next; of many those with the deepest valleys between.
  void find_lobes() {
    const auto inside = [this](std::size_t i) {
      return places_[i].overlap > 0.0 && patch_.y_first <= places_[i].y &&
             places_[i].y <= patch_.y_last;
    };
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (inside(i) && samples_[i].node) {
        nodes.push_back(i);
      }
    }
    double least = std::numeric_limits<double>::infinity(); // since the last lobe
    std::size_t least_node = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const double overlap = places_[nodes[n]].overlap;
      const bool rises = n == 0 || places_[nodes[n - 1]].overlap < overlap;
      const bool falls = n + 1 == nodes.size() || places_[nodes[n + 1]].overlap <= overlap;
      if (rises && falls) {
        if (!lobes_.empty()) {
          lobes_.back().last = saddle_at(least_node);
          lobes_.back().behind = least;
        }
        OwnLobe& lobe = lobes_.emplace_back();
        lobe.first = lobes_.size() > 1 ? lobes_[lobes_.size() - 2].last : 0.0;
        lobe.deepest = nodes[n];
        lobe.node_depth = overlap;
        least = overlap;
      }
      if (overlap < least) {
        least = overlap;
        least_node = nodes[n];
      }
    }
    if (lobes_.empty()) {
      return;
    }
    std::size_t first = lobes_.front().deepest;
    while (first > 0 && inside(first)) {
      --first;
    }
    lobes_.front().first = static_cast<double>(first);
    std::size_t last = lobes_.back().deepest;
    while (last + 1 < places_.size() && inside(last)) {
      ++last;
    }
    lobes_.back().last = static_cast<double>(last);
    for (OwnLobe& lobe : lobes_) {
      for (auto i = static_cast<std::size_t>(std::ceil(lobe.first));
           static_cast<double>(i) <= lobe.last; ++i) {
        lobe.deepest = places_[i].overlap > places_[lobe.deepest].overlap ? i : lobe.deepest;
      }
      depth_ = std::max(depth_, depth_of(lobe));
    }
    if (!advances(lobes_.front().first, lobes_.back().last)) {
      lobes_.clear();
    }
    while (lobes_.size() > most_lobes) {
      join_with_next(shallowest_valley());
    }
  }

  /// Not where the locus turns back, at ridges under yaw.
  [[nodiscard]] bool advances(double first, double last) const {
    for (auto i = static_cast<std::size_t>(first); static_cast<double>(i) < last; ++i) {
      if (!(places_[i + 1].across - places_[i].across > same_place && places_[i].curvature > 0.0)) {
        return false;
      }
    }
    return true;
  }

  /// The vertex of the parabola through the least place and its neighbours.
  [[nodiscard]] double saddle_at(std::size_t least) const {
    const auto slope_before = [this](std::size_t i) {
      return (places_[i].overlap - places_[i - 1].overlap) /
             (places_[i].across - places_[i - 1].across);
    };
    const double falling = slope_before(least);
    const double rising = slope_before(least + 1);
    const double before = places_[least].across - places_[least - 1].across;
    const double after = places_[least + 1].across - places_[least].across;
    // From the middle of the one stretch towards that of the other.
    const double from_least = 0.5 * ((before + after) * falling / (falling - rising) - before);
    return static_cast<double>(least) + from_least / (from_least < 0.0 ? before : after);
  }
  [[nodiscard]] double depth_of(const OwnLobe& lobe) const { return places_[lobe.deepest].overlap; }
  /// Between a lobe and the next.
  [[nodiscard]] Place saddle(std::size_t lobe) const { return place_at(lobes_[lobe].last); }
  [[nodiscard]] Place place_at(double number) const {
    const auto i = static_cast<std::size_t>(number);
    const double t = number - static_cast<double>(i);
    const Place& from = places_[i];
    const Place& to = places_[std::min(i + 1, places_.size() - 1)];
    return {std::lerp(from.across, to.across, t), std::lerp(from.along, to.along, t),
            std::lerp(from.overlap, to.overlap, t), std::lerp(from.curvature, to.curvature, t),
            std::lerp(from.y, to.y, t)};
  }

  /// Below the shallower of a lobe and the next; without tops, which are placed as they appear.
  [[nodiscard]] double valley(std::size_t k) const {
    return std::min(lobes_[k].node_depth, lobes_[k + 1].node_depth) - lobes_[k].behind;
  }

  void join_with_next(std::size_t k) {
    OwnLobe& lobe = lobes_[k];
    const OwnLobe& next = lobes_[k + 1];
    lobe.last = next.last;
    lobe.behind = next.behind;
    lobe.node_depth = std::max(lobe.node_depth, next.node_depth);
    lobe.joined += next.joined;
    if (places_[next.deepest].overlap > places_[lobe.deepest].overlap) {
      lobe.deepest = next.deepest;
    }
    lobe.ratio = 0.0;
    lobes_.erase(lobes_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }

  /// Loads and displacements that belong together.
  void settle() {
    for (OwnLobe& lobe : lobes_) {
      lobe.load = 0.0;
      lobe.middle = places_[lobe.deepest];
    }
    std::vector<std::size_t> order(lobes_.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      order[k] = k;
    }
    std::ranges::stable_sort(order, [this](std::size_t one, std::size_t other) {
      return depth_of(lobes_[one]) > depth_of(lobes_[other]);
    });
    for (int pass = 0; pass < lobe_passes; ++pass) {
      double change = 0.0;
      double sum = 0.0;
      for (const std::size_t k : order) {
        const double before = lobes_[k].load;
        set_load(lobes_[k]);
        change = std::max(change, std::abs(lobes_[k].load - before));
        sum += lobes_[k].load;
      }
      if (change <= lobe_load_accuracy * sum) {
        return;
      }
    }
  }

  void set_load(OwnLobe& lobe) {
    const Place& top = places_[lobe.deepest];
    lobe.approach = top.overlap;
    for (const OwnLobe& other : lobes_) {
      if (&other != &lobe) {
        lobe.approach -= displacement_by(other, lobe.middle);
      }
    }
    // Never quite nothing: the size of its elements.
    const double least = least_lobe_approach * depth_;
    const double approach = 0.5 * (lobe.approach + std::hypot(lobe.approach, 2.0 * least));
    const double virtual_depth = (1.0 - outside_contact_share) * approach;
    const double variance = measure(lobe, top.overlap - virtual_depth);
    // Rows (1 - t^2)^2.5 have an eighth of the square of their half width as variance.
    const double across = virtual_depth / (4.0 * variance);
    const double along = lobe.middle.curvature;
    const auto [smaller, greater] = std::minmax({across, along});
    if (lobe.ratio == 0.0) {
      lobe.ratio = std::pow(smaller / greater, 2.0 / 3.0);
    }
    EllipticIntegrals integrals = elliptic_integrals(lobe.ratio);
    for (int step = 0; step < 2; ++step) { // models/hertz.cpp; the rest with the passes
      lobe.ratio = std::min(1.0, std::sqrt(integrals.c / integrals.d * smaller / greater));
      integrals = elliptic_integrals(lobe.ratio);
    }
    const double longer = std::sqrt(2.0 * approach * integrals.d / (smaller * integrals.k));
    lobe.load = smaller * longer * longer * longer / (3.0 * integrals.d) *
                std::pow(std::max(lobe.approach, 0.0) / approach, 1.5);
    const double shorter = lobe.ratio * longer;
    lobe.semi_across = across <= along ? longer : shorter;
    lobe.semi_along = across <= along ? shorter : longer;
  }

  /// Sets the middle of the overlap beyond a level; returns its variance across the rail.
  double measure(OwnLobe& lobe, double level) const {
    double weights = 0.0;
    double squares = 0.0;
    Place sum;
    for (auto i = static_cast<std::size_t>(lobe.first); static_cast<double>(i) < lobe.last; ++i) {
      const Place& from = places_[i];
      const Place& to = places_[i + 1];
      const double at_first = from.overlap - level;
      const double at_last = to.overlap - level;
      if (at_first <= 0.0 && at_last <= 0.0) {
        continue;
      }
      double begin = std::max(lobe.first - static_cast<double>(i), 0.0);
      double end = std::min(lobe.last - static_cast<double>(i), 1.0);
      if (at_first <= 0.0) {
        begin = std::max(begin, 1.0 - way_down(at_last, at_first, bulges_[i]));
      } else if (at_last <= 0.0) {
        end = std::min(end, way_down(at_first, at_last, bulges_[i]));
      }
      if (begin >= end) {
        continue;
      }
      const double length = (end - begin) * (to.across - from.across);
      for (const auto& [node, share] : gauss_nodes) {
        const double t = begin + (end - begin) * node;
        const double overlap =
            std::max(std::lerp(at_first, at_last, t) + bulges_[i] * t * (1.0 - t), 0.0);
        const double curvature = std::lerp(from.curvature, to.curvature, t);
        const double weight = share * length * overlap * overlap * std::sqrt(overlap / curvature);
        const double across = std::lerp(from.across, to.across, t) - places_[lobe.deepest].across;
        weights += weight;
        squares += weight * across * across;
        sum.across += weight * across;
        sum.along += weight * std::lerp(from.along, to.along, t);
        sum.curvature += weight * curvature;
        sum.y += weight * std::lerp(from.y, to.y, t);
      }
    }
    const double shift = sum.across / weights;
    lobe.middle = {places_[lobe.deepest].across + shift, sum.along / weights, 0.0,
                   sum.curvature / weights, sum.y / weights};
    return squares / weights - shift * shift;
  }

  /// Where a parabola falls to 0 (patches/locus_samples.hpp).
  static double way_down(double higher, double lower, double bulge) {
    const double slope = higher - lower - bulge;
    return 2.0 * higher / (slope + std::sqrt(std::max(slope * slope + 4.0 * bulge * higher, 0.0)));
  }

  /// Of grids that end at the saddle behind a lobe, in the forces.
  [[nodiscard]] double share_apart(std::size_t k) const {
    return smoothstep(valley(k) / (vanishing_valley * depth_));
  }

  [[nodiscard]] std::size_t shallowest_valley() const {
    std::size_t shallowest = 0;
    for (std::size_t k = 1; k + 1 < lobes_.size(); ++k) {
      shallowest = valley(k) < valley(shallowest) ? k : shallowest;
    }
    return shallowest;
  }

  [[nodiscard]] double load() const {
    double sum = 0.0;
    for (const OwnLobe& lobe : lobes_) {
      sum += lobe.load;
    }
    return sum;
  }

  /// Share of one grid in the forces, 1 where one lobe bears all.
  [[nodiscard]] double whole() const {
    double largest = 0.0;
    for (const OwnLobe& lobe : lobes_) {
      largest = std::max(largest, lobe.load);
    }
    return smoothstep((largest / load() - nearly_all) / (1.0 - nearly_all));
  }

  [[nodiscard]] ContactPatch patch_of(std::size_t k) const {
    const OwnLobe& lobe = lobes_[k];
    const double share = lobe.load / load();
    ContactPatch patch = patch_;
    patch.limit_first = k > 0 ? saddle(k - 1).y : patch_.limit_first;
    patch.limit_last = k + 1 < lobes_.size() ? saddle(k).y : patch_.limit_last;
    patch.mean_x = lobe.middle.along;
    patch.mean_y = lobe.middle.y;
    patch.semi_across = lobe.semi_across;
    patch.semi_along = lobe.semi_along;
    const double width = lobe_grid_widths * patch.semi_across * cosine_;
    const double length = lobe_grid_lengths * patch.semi_along;
    patch.y_first = patch.mean_y - width;
    patch.y_last = patch.mean_y + width;
    patch.x_first = patch.mean_x - length;
    patch.x_last = patch.mean_x + length;
    patch.half_length = length;
    patch.deepest = depth_of(lobe);
    patch.weight *= share;
    patch.lobes = lobe.joined;
    return patch;
  }

  const ContactPatch& patch_;
  double depth_ = 0.0; ///< of the deepest lobe
  std::span<const LocusSample<double>> samples_;
  double cosine_;
  std::vector<Place> places_;
  std::vector<double> bulges_; ///< of each place and the next
  std::vector<OwnLobe> lobes_;
};

/// Adds what patch k has become.
void append(std::span<const ContactPatch> lobes, const ContactPatches& found, std::size_t k,
            ContactPatches& result) {
  const std::size_t first = result.patches.size();
  std::size_t deepest = first;
  for (ContactPatch lobe : lobes) {
    lobe.whole = k;
    if (!result.patches.empty()) {
      const bool is_first = result.patches.size() == first;
      result.links.push_back(is_first ? found.links[k - 1] : 1.0);
      lobe.shares_plane_with_previous = !is_first || found.patches[k].shares_plane_with_previous;
    }
    result.patches.push_back(lobe);
    deepest = lobe.deepest > result.patches[deepest].deepest ? result.patches.size() - 1 : deepest;
  }
  result.main = k == found.main ? deepest : result.main;
}

} // namespace

std::vector<GridWay> ways_with_own_lobes(const ContactPatches& found,
                                         std::span<const LocusSample<double>> samples) {
  std::vector<GridWay> ways(1);
  ways.front().patches.weight = found.weight;
  for (std::size_t k = 0; k < found.patches.size(); ++k) {
    const ContactPatch& patch = found.patches[k];
    const std::vector<Way> of_patch = LobesOfPatch(patch, samples).find();
    std::vector<GridWay> with_patch;
    for (const GridWay& before : ways) {
      for (const Way& way : of_patch) {
        with_patch.push_back(before);
        with_patch.back().share *= way.share;
        append(way.lobes, found, k, with_patch.back().patches);
      }
    }
    ways = std::move(with_patch);
  }
  return ways;
}

} // namespace wrc
