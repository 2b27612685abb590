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
#include "measured/constants.hpp"
#include "measured/noise_model.hpp"
#include "measured/profile_shape.hpp"
#include "profile/smoothing.hpp"
#include "profile/spline.hpp"

namespace wrc {
namespace {

/// The reference, and the points in its coordinates.
struct Offsets {
  OffsetData data;
  SplineBasis basis;
  std::vector<double> curvature;
};

/// Point (arc, offset) beside the reference.
Position beside(const Curve& reference, double arc, double offset) {
  const CurvePoint at = reference.at(arc);
  return {at.lateral - offset * at.tangent_height, at.height + offset * at.tangent_lateral};
}

/// Ends without the few points that are far from all others, to which a curve would swing.
std::span<const Position> without_lone_ends(std::span<const Position> points) {
  const auto distance = [&](std::size_t i) {
    return reading::distance_between(points[i], points[i + 1]);
  };
  const double most =
      std::max(lone_distance, farthest_in_spacings * reading::median_spacing(points));
  std::size_t first = 0;
  std::size_t last = points.size();
  for (std::size_t i = 0; i < most_lone && i + most_lone < points.size(); ++i) {
    if (distance(i) > most) {
      first = i + 1;
    }
    if (distance(points.size() - 2 - i) > most) {
      last = points.size() - 1 - i;
    }
  }
  return points.subspan(first, last - first);
}

/// Arc of the foot of a point on the reference, next to a guess.
double foot_of(const Curve& reference, const Position& point, double arc) {
  for (int step = 0; step < foot_steps; ++step) {
    const CurvePoint at = reference.at(arc);
    const double along =
        (point[0] - at.lateral) * at.tangent_lateral + (point[1] - at.height) * at.tangent_height;
    arc = std::clamp(arc + std::clamp(along, -longest_foot_step, longest_foot_step), 0.0,
                     reference.length());
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
  for (std::size_t j = 0; j <= result.basis.intervals; ++j) {
    result.curvature.push_back(
        reference.at(result.basis.step() * static_cast<double>(j)).curvature());
  }
  return result;
}

/// None if it turns too fast for the reference.
std::optional<std::vector<Position>> line_of(const Curve& reference, const SplineBasis& basis,
                                             std::span<const double> coefficients) {
  std::vector<Position> line;
  for (std::size_t j = 0; j <= basis.intervals; ++j) {
    const double arc = basis.step() * static_cast<double>(j);
    const double offset = basis.value(coefficients, arc);
    if (!(reference.at(arc).curvature() * offset < greatest_turn)) {
      return std::nullopt;
    }
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
    for (const Position& point : points) {
      for (const double value : point) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
      }
    }
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

/// The noise of the points, which an instrument may have filtered.
NoiseFit first_fit(Offsets& offsets) {
  NoiseFit fit = fit_noise(offsets.basis, offsets.data, offsets.curvature);
  const double spacing = offsets.basis.length / static_cast<double>(offsets.data.arc.size());
  double correlation = correlation_of(fit.residuals(offsets.data));
  for (const double distance : filter_distances) {
    if (distance > spacing_ratio * spacing) {
      NoiseFit next = fit_apart(offsets.basis, offsets.data, offsets.curvature, distance);
      if (next.repetition < most_repetition &&
          (correlation > 0.0 || next.deviation > more_noise * fit.deviation) &&
          flattening * next.deviation > notable_pressure * distance) {
        correlation = next.correlation;
        fit = std::move(next);
      }
    }
  }
  return fit;
}

} // namespace

NoiseRemoval remove_noise(std::span<const Position> all) {
  const std::span<const Position> points = without_lone_ends(all);
  const std::vector<Position> smoothed = smooth_points(points, reference_wavelength);
  std::vector<Position> thinned = smoothed;
  reading::drop_close_points(thinned, reference_spacing);
  const Curve first = curve_through(thinned);
  Offsets from_first = offsets_from(first, points, smoothed);
  const NoiseFit rough =
      fit_again(from_first.basis, from_first.data, from_first.curvature, first_fit(from_first));

  const auto line = [](const Curve& reference, const NoiseFit& fit) {
    auto found = line_of(reference, fit.basis, fit.coefficients);
    if (!found) {
      throw Error(ErrorCode::internal, "the line turns too fast to be smoothed by its noise");
    }
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
  for (std::size_t i = 0; i < likely_lines; ++i) {
    if (auto drawn = line_of(second, fit.basis, fit.draw(std::ref(normal)))) {
      result.likely.push_back(std::move(*drawn));
    }
  }
  result.deviation = fit.deviation;
  result.distance = fit.distance;
  std::vector<double> waves = fit.wavelength;
  std::sort(waves.begin(), waves.end());
  const auto rest = static_cast<std::size_t>(left_out * static_cast<double>(waves.size()));
  result.short_wave = waves[rest];
  result.long_wave = waves[waves.size() - 1 - rest];
  return result;
}

} // namespace wrc
