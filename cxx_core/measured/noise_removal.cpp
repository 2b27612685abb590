#include "measured/noise_removal.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <random>

#include "base/error.hpp"
#include "measured/noise_model.hpp"
#include "profile/smoothing.hpp"
#include "profile/spline.hpp"

namespace wrc {
namespace {

/// Wavelength of the first reference and distance of its points, mm.
/// origin: bound: another reference changes the result in the second order of its distance from it.
constexpr double reference_wavelength = 5.0;
constexpr double reference_spacing = 0.2;
/// Intervals of the spline, mm, and how many there are at least.
/// origin: reasoned: a tenth of the shortest waves that matter for contacts.
constexpr double interval_length = 0.25;
constexpr std::size_t least_intervals = 8;
/// Steps towards the foot of a point on the reference, each at most so long, mm.
/// origin: bound: two settle to 1e-6 mm unless the reference is half a mm away.
constexpr int foot_steps = 3;
constexpr double longest_step = 0.5;
/// Intervals on each side of a guess that are searched.
/// origin: reasoned: a curve over a gap of 10 mm may be 3 mm longer than its chord.
constexpr int search_steps = 16;
/// Up to this number of points at an end do not belong to the line if they are this far from the
/// rest, mm and in median distances.
/// origin: measured: an averaged rail of the collection begins with a point 3.6 mm off its side.
constexpr std::size_t most_lone = 4;
constexpr double lone_distance = 2.0;
constexpr double lone_ratio = 5.0;
/// An offset by this share of the radius of curvature is too far from the reference.
/// origin: bound: offsets along normals meet at 1.
constexpr double greatest_turn = 0.7;
/// Shares of the profile that short_wave and long_wave leave out.
/// origin: reasoned: kinks and ends halve waves that say nothing about the rest.
constexpr double left_out = 0.1;

/// The reference, and the points in its coordinates.
struct Offsets {
  OffsetData data;
  SplineBasis basis;
  std::vector<double> curvature;
};

std::vector<Position> thinned(std::span<const Position> points, double least) {
  std::vector<Position> kept;
  for (const Position& point : points)
    if (kept.empty() || std::hypot(point[0] - kept.back()[0], point[1] - kept.back()[1]) >= least)
      kept.push_back(point);
  return kept;
}

/// Point (arc, offset) beside the reference.
Position beside(const Curve& reference, double arc, double offset) {
  const CurvePoint at = reference.at(arc);
  return {at.lateral - offset * at.tangent_height, at.height + offset * at.tangent_lateral};
}

/// Ends without the few points that are far from all others, to which a curve would swing.
std::span<const Position> without_lone_ends(std::span<const Position> points) {
  const auto distance = [&](std::size_t i) {
    return std::hypot(points[i + 1][0] - points[i][0], points[i + 1][1] - points[i][1]);
  };
  std::vector<double> sorted;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    sorted.push_back(distance(i));
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double most = std::max(lone_distance, lone_ratio * *middle);
  std::size_t first = 0;
  std::size_t last = points.size();
  for (std::size_t i = 0; i < most_lone && i + most_lone < points.size(); ++i) {
    if (distance(i) > most)
      first = i + 1;
    if (distance(points.size() - 2 - i) > most)
      last = points.size() - 1 - i;
  }
  return points.subspan(first, last - first);
}

/// Arc of the foot of a point on the reference, next to a guess.
double foot_of(const Curve& reference, const Position& point, double arc) {
  for (int step = 0; step < foot_steps; ++step) {
    const CurvePoint at = reference.at(arc);
    const double along =
        (point[0] - at.lateral) * at.tangent_lateral + (point[1] - at.height) * at.tangent_height;
    arc = std::clamp(arc + std::clamp(along, -longest_step, longest_step), 0.0, reference.length());
  }
  return arc;
}

/// The same where the guess may be off: next to the closest place of a neighbourhood.
double foot_near(const Curve& reference, const Position& point, double arc) {
  double least = HUGE_VAL;
  double closest = arc;
  for (int i = -search_steps; i <= search_steps; ++i) {
    const double tried = std::clamp(arc + interval_length * i, 0.0, reference.length());
    const CurvePoint at = reference.at(tried);
    const double distance = std::hypot(point[0] - at.lateral, point[1] - at.height);
    if (distance < least) {
      least = distance;
      closest = tried;
    }
  }
  return foot_of(reference, point, closest);
}

/// The smoothed points show the way along the reference, so that no foot is mistaken.
Offsets offsets_from(const Curve& reference, std::span<const Position> points,
                     std::span<const Position> smoothed) {
  struct Datum {
    double arc;
    double offset;
  };
  std::vector<Datum> found;
  double passed = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = i == 0 ? 0.0
                                   : std::hypot(smoothed[i][0] - smoothed[i - 1][0],
                                                smoothed[i][1] - smoothed[i - 1][1]);
    passed = foot_near(reference, smoothed[i], passed + distance);
    const double arc = foot_of(reference, points[i], passed);
    const CurvePoint at = reference.at(arc);
    found.push_back({arc, (points[i][1] - at.height) * at.tangent_lateral -
                              (points[i][0] - at.lateral) * at.tangent_height});
  }
  std::sort(found.begin(), found.end(),
            [](const Datum& a, const Datum& b) { return a.arc < b.arc; });
  Offsets result;
  for (const Datum& datum : found) {
    result.data.arc.push_back(datum.arc);
    result.data.offset.push_back(datum.offset);
  }
  result.data.weight.assign(found.size(), 1.0);
  result.basis.length = reference.length();
  result.basis.intervals =
      std::max(least_intervals, static_cast<std::size_t>(reference.length() / interval_length));
  for (std::size_t j = 0; j <= result.basis.intervals; ++j)
    result.curvature.push_back(
        reference.at(result.basis.step() * static_cast<double>(j)).curvature());
  return result;
}

/// None if it turns too fast for the reference.
std::optional<std::vector<Position>> line_of(const Curve& reference, const SplineBasis& basis,
                                             std::span<const double> coefficients) {
  std::vector<Position> line;
  for (std::size_t j = 0; j <= basis.intervals; ++j) {
    const double arc = basis.step() * static_cast<double>(j);
    const double offset = basis.value(coefficients, arc);
    if (!(reference.at(arc).curvature() * offset < greatest_turn))
      return std::nullopt;
    line.push_back(beside(reference, arc, offset));
  }
  return line;
}

/// Normal numbers by Box and Muller. They follow from the points: the same for equal profiles, and
/// independent for different ones.
class NormalNumbers {
public:
  explicit NormalNumbers(std::span<const Position> points) {
    std::uint64_t hash = 14695981039346656037U; // of Fowler, Noll and Vo (FNV-1a)
    for (const Position& point : points)
      for (const double value : point)
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
    engine_.seed(hash);
  }
  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    return radius * std::cos(angle);
  }

private:
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 engine_;
};

} // namespace

NoiseRemoval remove_noise(std::span<const Position> all) {
  const std::span<const Position> points = without_lone_ends(all);
  const std::vector<Position> smoothed = smooth_points(points, reference_wavelength);
  const Curve first = curve_through(thinned(smoothed, reference_spacing));
  const Offsets from_first = offsets_from(first, points, smoothed);
  const NoiseFit rough = fit_noise(from_first.basis, from_first.data, from_first.curvature);

  const auto line = [](const Curve& reference, const NoiseFit& fit) {
    auto found = line_of(reference, fit.basis, fit.coefficients);
    if (!found)
      throw Error(ErrorCode::internal, "the line turns too fast to be smoothed by its noise");
    return std::move(*found);
  };
  const Curve second = curve_through(line(first, rough));
  Offsets from_second = offsets_from(second, points, smoothed);
  from_second.data.weight = weights_of(from_second.data.offset);
  const NoiseFit fit = fit_again(from_second.basis, from_second.data, from_second.curvature, rough);
  NoiseRemoval result;
  result.lone_ends = all.size() - points.size();
  result.points = line(second, fit);
  NormalNumbers normal(points);
  for (std::size_t i = 0; i < likely_lines; ++i)
    if (auto drawn = line_of(second, fit.basis, fit.draw(std::ref(normal))))
      result.likely.push_back(std::move(*drawn));
  result.deviation = fit.deviation;
  result.correlation = fit.correlation;
  std::vector<double> waves = fit.wavelength;
  std::sort(waves.begin(), waves.end());
  const auto rest = static_cast<std::size_t>(left_out * static_cast<double>(waves.size()));
  result.short_wave = waves[rest];
  result.long_wave = waves[waves.size() - 1 - rest];
  return result;
}

} // namespace wrc
