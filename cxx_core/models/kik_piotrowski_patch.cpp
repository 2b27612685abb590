#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "base/root_bracket.hpp"
#include "models/constants.hpp"
#include "models/kik_piotrowski.hpp"
#include "models/patch_model.hpp"

namespace wrc {
namespace {

struct GaussRule {
  std::array<double, penetration_nodes> place; ///< in (0, 1)
  std::array<double, penetration_nodes> weight;
};

/// Gauss-Legendre (Abramowitz & Stegun, 1964, 25.4.30), roots by Newton's method.
const GaussRule& gauss_rule() {
  static const GaussRule rule = [] {
    GaussRule made{};
    for (int i = 0; i < penetration_nodes; ++i) {
      double x = std::cos(std::numbers::pi * (i + 0.75) / (penetration_nodes + 0.5));
      double slope = 1.0;
      for (int step = 0; step < 10; ++step) {
        double before = 1.0;
        double here = x;
        for (int n = 2; n <= penetration_nodes; ++n) {
          const double next = ((2 * n - 1) * x * here - (n - 1) * before) / n;
          before = here;
          here = next;
        }
        slope = penetration_nodes * (x * here - before) / (x * x - 1.0);
        x -= here / slope;
      }
      const auto k = static_cast<std::size_t>(i);
      made.place[k] = 0.5 * (1.0 + x);
      made.weight[k] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    return made;
  }();
  return rule;
}

class KikPiotrowskiPatch final : public PatchModel {
public:
  KikPiotrowskiPatch(const ModelWheel& side, const ContactPatch& place, const ContactFrame& frame,
                     const ContactStrip& contact)
      : PatchModel(frame), side_(side), place_(place), contact_(contact),
        offset_lateral_(dot(contact.rail - frame.origin, frame.lateral)),
        offset_longitudinal_(dot(contact.rail - frame.origin, frame.longitudinal)) {}

  double load(double depth) override { return evaluate(depth) ? virtual_.normal_force : 0.0; }
  ModelledPatch solve(double depth) override;
  [[nodiscard]] std::vector<double> sample(const Grid& grid) const override;

private:
  /// A point of the outline l^2(y), from the contact point.
  struct OutlinePoint {
    double lateral;
    double half_length_square;
    double centre;
  };

  /// Strips and their solution at a depth; false without penetration.
  bool evaluate(double depth);
  template <class Row> [[nodiscard]] double penetration(const Row& row) const {
    return along_normal(depth_ - (side_.first_touch + row.distance), row.rail_slope, row.rail_rise);
  }
  /// Penetration that is left of the virtual one; < 0 outside.
  [[nodiscard]] double left_over(double s) const {
    const auto strip = side_.strips.at(s);
    return strip ? penetration(*strip) - outside_ : -approach_;
  }
  [[nodiscard]] double end_between(double inside, double outside) const;
  /// All regions to one side of the contact point, on which the scan's samples go on.
  template <class Samples> void add_side(Samples samples);
  void add_region(double from, double to, bool from_contact);
  void add_end(double s);
  [[nodiscard]] double validity() const;

  const ModelWheel& side_;
  ContactPatch place_;
  ContactStrip contact_;
  double offset_lateral_; ///< of the contact point in the frame
  double offset_longitudinal_;

  // The depth solved last.
  double depth_ = 0.0;
  double approach_ = 0.0;
  double outside_ = 0.0; ///< penetration that is no contact
  double greatest_square_ = 0.0;
  int regions_ = 0;
  bool cut_ = false; ///< by the end of a profile or a neighbour
  std::vector<KikPiotrowskiStrip> strips_;
  std::vector<OutlinePoint> ends_;
  KikPiotrowskiContact virtual_;
};

double KikPiotrowskiPatch::end_between(double inside, double outside) const {
  const double in = left_over(inside);
  const double out = left_over(outside);
  if (!(in > 0.0)) {
    return inside;
  }
  if (!(out < 0.0)) {
    return outside;
  }
  RootBracket end({inside, in}, {outside, out});
  end.narrow(model_search_accuracy * std::abs(outside - inside), [&](double s) {
    const double rest = left_over(s);
    return std::abs(rest) <= model_search_accuracy * approach_ ? 0.0 : rest;
  });
  return end.middle();
}

void KikPiotrowskiPatch::add_region(double from, double to, bool from_contact) {
  const GaussRule& rule = gauss_rule();
  const double sign = to < from ? -1.0 : 1.0;
  for (std::size_t i = 0; i < rule.place.size(); ++i) {
    // Squared from the contact point on: a logarithm becomes smooth enough for the rule.
    const double share = from_contact ? rule.place[i] * rule.place[i] : rule.place[i];
    const double rate = from_contact ? 2.0 * rule.place[i] : 1.0;
    const auto strip = side_.strips.at(from + (to - from) * share);
    if (!strip) {
      continue;
    }
    const double rest = penetration(*strip) - outside_;
    const double square = 2.0 * std::max(0.0, rest) / strip->longitudinal_curvature;
    const double lateral_rate =
        strip->lateral_rate * (frame_.lateral.y + strip->rail_slope * frame_.lateral.z);
    greatest_square_ = std::max(greatest_square_, square);
    const Vector3 apart = strip->rail - contact_.rail;
    strips_.push_back({dot(apart, frame_.lateral),
                       rule.weight[i] * rate * sign * (to - from) * lateral_rate, square,
                       dot(apart, frame_.longitudinal)});
  }
}

void KikPiotrowskiPatch::add_end(double s) {
  if (const auto strip = side_.strips.at(s)) {
    const Vector3 apart = strip->rail - contact_.rail;
    ends_.push_back({dot(apart, frame_.lateral), 0.0, dot(apart, frame_.longitudinal)});
  }
}

template <class Samples> void KikPiotrowskiPatch::add_side(Samples samples) {
  double begin = contact_.s; // of the region that is open
  double last = contact_.s;
  bool open = true;
  bool from_contact = true;
  const auto close = [&](double end) {
    add_region(begin, end, from_contact);
    add_end(end);
    if (!from_contact) {
      add_end(begin);
      ++regions_;
    }
    open = false;
    from_contact = false;
  };
  for (const DistanceSample& sample : samples) {
    const double y = sample.wheel.position.y;
    const double s = sample.wheel.lateral;
    if (s == last) {
      continue;
    }
    if (y < place_.limit_first || y > place_.limit_last) {
      break;
    }
    const double rest = penetration(sample) - outside_;
    if (open && rest <= 0.0) {
      close(end_between(last, s));
    } else if (!open && rest > 0.0) {
      begin = end_between(s, last);
      open = true;
    }
    last = s;
    if (!open && (y < place_.y_first || y > place_.y_last)) {
      break;
    }
  }
  if (open) {
    cut_ = true;
    close(last);
  }
}

/// A range of the scan's samples in either direction.
template <class Iterator> struct SampleRange {
  Iterator first;
  Iterator last;
  [[nodiscard]] Iterator begin() const { return first; }
  [[nodiscard]] Iterator end() const { return last; }
};
template <class Iterator> SampleRange(Iterator, Iterator) -> SampleRange<Iterator>;

bool KikPiotrowskiPatch::evaluate(double depth) {
  depth_ = depth;
  approach_ = penetration(contact_);
  if (!(approach_ > 0.0)) {
    return false;
  }
  outside_ = (1.0 - virtual_penetration_share) * approach_;
  strips_.clear();
  ends_.clear();
  regions_ = 1;
  cut_ = false;
  greatest_square_ = 2.0 * virtual_penetration_share * approach_ / contact_.longitudinal_curvature;
  const auto& samples = side_.scan.samples;
  const auto after = std::upper_bound(
      samples.begin(), samples.end(), contact_.s,
      [](double s, const DistanceSample& sample) { return s < sample.wheel.lateral; });
  add_side(SampleRange{after, samples.end()});
  add_side(SampleRange{std::make_reverse_iterator(after), samples.rend()});
  virtual_ = solve_virtual_penetration(strips_, std::sqrt(greatest_square_), side_.combined_modulus,
                                       approach_);
  return true;
}

double KikPiotrowskiPatch::validity() const {
  if (regions_ > 1 || cut_) {
    return 0.0;
  }
  double volume = 0.0;
  double moment = 0.0;
  for (const KikPiotrowskiStrip& strip : strips_) {
    volume += strip.weight * strip.half_length_square;
    moment += strip.weight * strip.half_length_square * strip.lateral;
  }
  const double centre = moment / volume;
  const double half_length = std::sqrt(greatest_square_);
  const double half_width = virtual_.area / (std::numbers::pi * half_length);
  double difference = side_.strips.difference_along(contact_, frame_.longitudinal.x * half_length);
  const auto compare = [&](double lateral, double square) {
    const double place = (lateral - centre) / half_width;
    difference = std::max(difference, std::abs(square / greatest_square_ - (1.0 - place * place)));
  };
  for (const KikPiotrowskiStrip& strip : strips_) {
    compare(strip.lateral, strip.half_length_square);
  }
  for (const OutlinePoint& end : ends_) {
    compare(end.lateral, end.half_length_square);
  }
  return std::max(0.0, 1.0 - difference);
}

ModelledPatch KikPiotrowskiPatch::solve(double depth) {
  ModelledPatch patch;
  if (!evaluate(depth)) {
    return patch;
  }
  patch.normal_force = virtual_.normal_force;
  patch.peak_pressure = virtual_.peak_pressure;
  patch.area = virtual_.area;
  patch.approach = approach_;
  patch.validity = validity();
  patch.centroid_longitudinal = offset_longitudinal_ + virtual_.centroid_longitudinal;
  patch.centroid_lateral = offset_lateral_ + virtual_.centroid_lateral;
  patch.semi_axis_longitudinal = virtual_.semi_axis_longitudinal;
  patch.semi_axis_lateral = virtual_.semi_axis_lateral;
  patch.extent = PlaneArea::empty();
  const auto include = [&](double lateral, double half_length_square, double centre) {
    const double y = offset_lateral_ + lateral / virtual_.stretch;
    const double reach = virtual_.stretch * std::sqrt(half_length_square);
    const double x = offset_longitudinal_ + centre;
    patch.extent.include({y, y, x - reach, x + reach});
  };
  for (const KikPiotrowskiStrip& strip : strips_) {
    include(strip.lateral, strip.half_length_square, strip.centre);
  }
  for (const OutlinePoint& end : ends_) {
    include(end.lateral, end.half_length_square, end.centre);
  }
  include(0.0, greatest_square_, 0.0);
  return patch;
}

std::vector<double> KikPiotrowskiPatch::sample(const Grid& grid) const {
  // l^2 and centres are linear between strips and ends: between two ends there is nothing.
  std::vector<OutlinePoint> outline = ends_;
  for (const KikPiotrowskiStrip& strip : strips_) {
    outline.push_back({strip.lateral, strip.half_length_square, strip.centre});
  }
  std::sort(outline.begin(), outline.end(),
            [](const auto& one, const auto& other) { return one.lateral < other.lateral; });
  std::vector<double> pressure(grid.element_count(), 0.0);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double lateral = (grid.lateral(row) - offset_lateral_) * virtual_.stretch;
    const auto next =
        std::lower_bound(outline.begin(), outline.end(), lateral,
                         [](const OutlinePoint& point, double y) { return point.lateral < y; });
    if (next == outline.begin() || next == outline.end()) {
      continue;
    }
    const OutlinePoint& before = *(next - 1);
    const double share = (lateral - before.lateral) / (next->lateral - before.lateral);
    const double square = virtual_.stretch * virtual_.stretch *
                          std::lerp(before.half_length_square, next->half_length_square, share);
    const double centre = offset_longitudinal_ + std::lerp(before.centre, next->centre, share);
    double* values = pressure.data() + row * grid.longitudinal_count;
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const double x = grid.longitudinal(column) - centre;
      values[column] = virtual_.pressure_factor * std::sqrt(std::max(0.0, square - x * x));
    }
  }
  return pressure;
}

} // namespace

std::unique_ptr<PatchModel> make_kik_piotrowski_patch(const ModelWheel& side,
                                                      const ContactPatch& place,
                                                      const ContactFrame& frame) {
  return std::make_unique<KikPiotrowskiPatch>(
      side, place, frame, side.strips.touching_at(place.deepest_s, "kik-piotrowski"));
}

} // namespace wrc
