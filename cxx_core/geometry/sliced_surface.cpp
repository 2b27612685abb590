#include "geometry/sliced_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "geometry/constants.hpp"
#include "profile/constants.hpp"

namespace wrc {
namespace {

/// A bound of input (not a tuning constant): waves of 3 mm on a wheel of 460 mm.
constexpr int max_order = 1000;
constexpr double revolution = 2.0 * std::numbers::pi;

double distance_along(const SurfaceSheet& sheet, double along) {
  if (sheet.holds(along)) {
    return 0.0;
  }
  const Stretch range = sheet.along();
  return std::max(range.begin - along, along - range.end);
}

double width_at(const SurfaceSheet& sheet, double along) {
  return sheet.at(sheet.across().end, along).at[0] - sheet.at(sheet.across().begin, along).at[0];
}

void check_radius(double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw_invalid_argument("radius of the wheel", radius, "a positive finite number, mm");
  }
}

void check_wheel(std::span<const SurfaceSheet> sheets, double radius,
                 std::span<const RadiusHarmonic> harmonics) {
  double depth = 0.0; // of all harmonics together
  for (const RadiusHarmonic& harmonic : harmonics) {
    const std::string name = "harmonic of order " + std::to_string(harmonic.order);
    if (harmonic.order < 1 || harmonic.order > max_order) {
      throw_invalid_argument(name, std::to_string(harmonic.order),
                             "an order of 1 to " + std::to_string(max_order));
    }
    if (!std::isfinite(harmonic.amplitude) || !std::isfinite(harmonic.phase)) {
      throw_invalid_argument(name, harmonic.amplitude, "a finite amplitude and phase");
    }
    depth += std::abs(harmonic.amplitude);
  }
  for (const SurfaceSheet& sheet : sheets) {
    for (const double theta : sheet.knots()) {
      for (const double across : sheet.starts()) {
        if (const double least = radius + sheet.at(across, theta).at[1] - depth; !(least > 0.0)) {
          throw_invalid_argument("radius of the wheel", least, "positive at all angles, mm");
        }
      }
    }
  }
}

} // namespace

SlicedSurface::SlicedSurface(std::vector<SurfaceSheet> sheets, double period,
                             std::vector<RadiusHarmonic> harmonics)
    : sheets_(std::move(sheets)), period_(period), harmonics_(std::move(harmonics)),
      steepest_along_(std::numeric_limits<double>::infinity()) {
  if (sheets_.size() == 1 && sheets_.front().is_periodic()) {
    steepest_along_ = sheets_.front().steepest_along();
    for (const RadiusHarmonic& harmonic : harmonics_) {
      steepest_along_ += harmonic.order * std::abs(harmonic.amplitude);
    }
  }
}

Stretch SlicedSurface::along() const {
  Stretch range = sheets_.front().along();
  for (const SurfaceSheet& sheet : sheets_) {
    range.begin = std::min(range.begin, sheet.along().begin);
    range.end = std::max(range.end, sheet.along().end);
  }
  return range;
}

double SlicedSurface::distance_to_part(double along) const {
  double distance = std::numeric_limits<double>::infinity();
  for (const SurfaceSheet& sheet : sheets_) {
    distance = std::min(distance, distance_along(sheet, along));
  }
  return distance;
}

std::vector<ConstantStretch> SlicedSurface::constant_stretches() const {
  std::vector<ConstantStretch> stretches;
  if (!harmonics_.empty()) {
    return stretches;
  }
  for (const SurfaceSheet& sheet : sheets_) {
    for (const Stretch& stretch : sheet.constant_stretches(negligible_length)) {
      std::vector<Stretch> alone{stretch};
      double rise = sheet.rise_over(stretch.begin);
      for (const SurfaceSheet& other : sheets_) {
        if (&other == &sheet) {
          continue;
        }
        rise = highest_flange;
        std::vector<Stretch> left;
        for (const Stretch& part : alone) {
          const Stretch taken = other.along();
          left.push_back({part.begin, std::min(part.end, taken.begin)});
          left.push_back({std::max(part.begin, taken.end), part.end});
        }
        alone = std::move(left);
      }
      for (const Stretch& part : alone) {
        if (part.begin < part.end) {
          stretches.push_back({part, rise});
        }
      }
    }
  }
  return stretches;
}

std::optional<PartEnd> SlicedSurface::nearest_end(double along) const {
  std::optional<PartEnd> nearest;
  for (const SurfaceSheet& sheet : sheets_) {
    if (sheet.is_periodic()) {
      continue;
    }
    for (const double end : {sheet.along().begin, sheet.along().end}) {
      const double apart = period_ > 0.0 ? std::remainder(along - end, period_) : along - end;
      if (!nearest || std::abs(apart) < nearest->distance) {
        nearest = PartEnd{end, std::abs(apart)};
      }
    }
  }
  return nearest;
}

SlicedSurface::Wave SlicedSurface::wave(double theta) const {
  Wave sum;
  for (const RadiusHarmonic& harmonic : harmonics_) {
    const double order = harmonic.order;
    const double angle = std::remainder(order * theta - harmonic.phase, revolution);
    sum.value += harmonic.amplitude * std::cos(angle);
    sum.first -= order * harmonic.amplitude * std::sin(angle);
    sum.second -= order * order * harmonic.amplitude * std::cos(angle);
  }
  return sum;
}

std::optional<GraphPoint> SlicedSurface::over(double along, double lateral) const {
  std::optional<GraphPoint> highest;
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    const std::optional<GraphPoint> point = sheets_[i].over(along, lateral);
    if (point && (!highest || point->height > highest->height)) {
      highest = point;
      highest->sheet = i;
    }
  }
  if (highest) {
    const Wave added = wave(along);
    highest->height += added.value;
    highest->by_along += added.first;
    highest->by_along2 += added.second;
  }
  return highest;
}

void SlicedSurface::heights(double along, std::span<const double> laterals,
                            std::span<double> heights) const {
  std::ranges::fill(heights, -std::numeric_limits<double>::infinity());
  for (const SurfaceSheet& sheet : sheets_) {
    sheet.raise_to(along, laterals, heights);
  }
}

Curve SlicedSurface::section(double along) const {
  const double nearest = distance_to_part(along);
  const SurfaceSheet* widest = sheets_.data();
  double width = 0.0;
  for (const SurfaceSheet& sheet : sheets_) {
    if (distance_along(sheet, along) > nearest) {
      continue;
    }
    if (const double reach = width_at(sheet, along); reach > width) {
      widest = &sheet;
      width = reach;
    }
  }
  Curve section = widest->section(along); // clamped to its ends
  return harmonics_.empty() ? section : section.moved(0.0, 0.0, wave(along).value);
}

std::vector<Curve> SlicedSurface::sections(double along) const {
  std::vector<Curve> sections;
  for (const SurfaceSheet& sheet : sheets_) {
    if (sheet.holds(along)) {
      sections.push_back(sheet.section(along));
    }
  }
  return sections;
}

std::shared_ptr<const SlicedSurface> sliced_rail(const SlicedProfile& profile,
                                                 std::optional<double> smoothing_length) {
  return std::make_shared<const SlicedSurface>(
      sheets_of(profile, smoothing_length_of(profile, smoothing_length), 0.0), 0.0,
      std::vector<RadiusHarmonic>{});
}

std::shared_ptr<const SlicedSurface> sliced_wheel(const SlicedProfile& profile, double radius,
                                                  std::vector<RadiusHarmonic> harmonics,
                                                  std::optional<double> smoothing_length) {
  check_radius(radius);
  const double smoothing = smoothing_length.value_or(radius * smoothing_length_of(profile, {}));
  std::vector<SurfaceSheet> sheets =
      sheets_of(profile, smoothing / radius, revolution, {"mm", radius});
  check_wheel(sheets, radius, harmonics);
  return std::make_shared<const SlicedSurface>(std::move(sheets), revolution, std::move(harmonics));
}

std::shared_ptr<const SlicedSurface> sliced_wheel(const Curve& profile, double radius,
                                                  std::vector<RadiusHarmonic> harmonics) {
  SlicedProfile single;
  single.kind = ProfileKind::wheel;
  single.slices.push_back({0.0, profile});
  return sliced_wheel(single, radius, std::move(harmonics), 0.0);
}

} // namespace wrc
