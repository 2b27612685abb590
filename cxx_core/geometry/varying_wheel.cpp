#include "geometry/varying_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace wrc {
namespace {

/// A bound of input (not a tuning constant): waves of 3 mm on a wheel of 460 mm.
constexpr int max_order = 1000;
constexpr double revolution = 2.0 * std::numbers::pi;

double checked_radius(double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw_invalid_argument("radius of the wheel", radius, "a positive finite number, mm");
  }
  return radius;
}

double length_on_circumference(const SlicedProfile& profile, double radius,
                               std::optional<double> given) {
  return given ? *given : radius * smoothing_length_of(profile, {});
}

SlicedProfile single(const Curve& curve) {
  SlicedProfile profile;
  profile.kind = ProfileKind::wheel;
  profile.slices.push_back({0.0, curve});
  return profile;
}

} // namespace

VaryingWheel::VaryingWheel(const SlicedProfile& profile, double radius,
                           std::vector<RadiusHarmonic> harmonics,
                           std::optional<double> smoothing_length)
    : radius_(checked_radius(radius)),
      smoothing_length_(length_on_circumference(profile, radius, smoothing_length)),
      harmonics_(std::move(harmonics)),
      sheets_(sheets_of(profile, smoothing_length_ / radius, revolution, {"mm", radius})) {
  check();
}

VaryingWheel::VaryingWheel(const Curve& profile, double radius,
                           std::vector<RadiusHarmonic> harmonics)
    : VaryingWheel(single(profile), radius, std::move(harmonics), 0.0) {}

void VaryingWheel::check() const {
  double depth = 0.0; // of all harmonics together
  for (const RadiusHarmonic& harmonic : harmonics_) {
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
  for (const SurfaceSheet& sheet : sheets_) {
    for (const double theta : sheet.knots()) {
      for (const double across : sheet.starts()) {
        if (const double least = radius_ + sheet.at(across, theta).at[1] - depth; !(least > 0.0)) {
          throw_invalid_argument("radius of the wheel", least, "positive at all angles, mm");
        }
      }
    }
  }
}

VaryingWheel::Wave VaryingWheel::wave(double theta) const {
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

SheetPoint VaryingWheel::at(std::size_t sheet, double across, double theta) const {
  SheetPoint point = sheets_[sheet].at(across, theta);
  const Wave added = wave(theta);
  point.at[1] += added.value;
  point.along[1] += added.first;
  point.along2[1] += added.second;
  return point;
}

std::optional<GraphPoint> VaryingWheel::over(double theta, double lateral) const {
  std::optional<GraphPoint> outermost = highest_over(sheets_, theta, lateral);
  if (outermost) {
    const Wave added = wave(theta);
    outermost->height += added.value;
    outermost->by_along += added.first;
    outermost->by_along2 += added.second;
  }
  return outermost;
}

Curve VaryingWheel::section(double theta) const {
  return widest_section(sheets_, theta).moved(0.0, 0.0, wave(theta).value);
}

} // namespace wrc
