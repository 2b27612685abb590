#include "profile/spline.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "profile/constants.hpp"

namespace wrc {
namespace {

/// Second derivatives at the knots of the not-a-knot cubic spline. The end conditions are
/// eliminated from the first and last interior equation, which stays diagonally dominant.
std::vector<double> second_derivatives(const std::vector<double>& knot,
                                       const std::vector<double>& value) {
  const std::size_t n = knot.size();
  const auto step = [&](std::size_t i) { return knot[i + 1] - knot[i]; };
  const auto slope = [&](std::size_t i) { return (value[i + 1] - value[i]) / step(i); };
  std::vector<double> diagonal(n);
  std::vector<double> upper(n);
  std::vector<double> second(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    double lower = i > 1 ? step(i - 1) : 0.0;
    diagonal[i] = 2.0 * (step(i - 1) + step(i));
    upper[i] = step(i);
    second[i] = 6.0 * (slope(i) - slope(i - 1));
    if (i == 1) {
      const double ratio = step(0) / step(1);
      diagonal[i] += step(0) * (1.0 + ratio);
      upper[i] -= step(0) * ratio;
    }
    if (i + 2 == n) {
      const double ratio = step(i) / step(i - 1);
      diagonal[i] += step(i) * (1.0 + ratio);
      lower -= step(i) * ratio;
    }
    if (i > 1) {
      const double factor = lower / diagonal[i - 1];
      diagonal[i] -= factor * upper[i - 1];
      second[i] -= factor * second[i - 1];
    }
  }
  second[n - 2] /= diagonal[n - 2];
  for (std::size_t i = n - 2; i-- > 1;) {
    second[i] = (second[i] - upper[i] * second[i + 1]) / diagonal[i];
  }
  second[0] = second[1] + (second[1] - second[2]) * (step(0) / step(1));
  second[n - 1] = second[n - 2] + (second[n - 2] - second[n - 3]) * (step(n - 2) / step(n - 3));
  return second;
}

/// One coordinate on one interval of the spline.
struct Values {
  double value;
  double first;
  double second;
};

class PlaneSpline {
public:
  PlaneSpline(std::vector<double> knot, const std::vector<double>& lateral,
              const std::vector<double>& height)
      : knot_(std::move(knot)), lateral_(lateral), height_(height),
        lateral_second_(second_derivatives(knot_, lateral)),
        height_second_(second_derivatives(knot_, height)) {}

  [[nodiscard]] std::size_t intervals() const { return knot_.size() - 1; }

  /// The curve's end at a fraction of an interval, with derivatives by arc length.
  [[nodiscard]] Curve::End at(std::size_t i, double fraction) const {
    const Values l = evaluate(i, fraction, lateral_, lateral_second_);
    const Values h = evaluate(i, fraction, height_, height_second_);
    const double speed = std::hypot(l.first, h.first);
    if (!(speed >= min_speed)) {
      throw_invalid_argument("points near (" + text_of(l.value) + ", " + text_of(h.value) + ")",
                             "turn back on themselves", "a line without cusps");
    }
    const double tangent_lateral = l.first / speed;
    const double tangent_height = h.first / speed;
    const double curvature =
        (tangent_lateral * h.second - tangent_height * l.second) / (speed * speed);
    return {l.value,
            h.value,
            tangent_lateral,
            tangent_height,
            -curvature * tangent_height,
            curvature * tangent_lateral};
  }

  /// Arc length between two fractions of an interval: 4-point rule of Gauss and Legendre
  /// (Abramowitz and Stegun, 1964, table 25.4).
  [[nodiscard]] double length(std::size_t i, double from, double to) const {
    constexpr double node[] = {0.3399810435848563, 0.8611363115940526};
    constexpr double weight[] = {0.6521451548625461, 0.3478548451374538};
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double sum = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      sum += weight[k] * (speed(i, middle - half * node[k]) + speed(i, middle + half * node[k]));
    }
    return sum * half * (knot_[i + 1] - knot_[i]);
  }

private:
  [[nodiscard]] Values evaluate(std::size_t i, double fraction, const std::vector<double>& value,
                                const std::vector<double>& second) const {
    const double step = knot_[i + 1] - knot_[i];
    const double u = fraction * step;
    const double third = (second[i + 1] - second[i]) / step;
    const double first =
        (value[i + 1] - value[i]) / step - step * (2.0 * second[i] + second[i + 1]) / 6.0;
    return {value[i] + u * (first + u * (0.5 * second[i] + u * third / 6.0)),
            first + u * (second[i] + 0.5 * u * third), second[i] + u * third};
  }
  [[nodiscard]] double speed(std::size_t i, double fraction) const {
    return std::hypot(evaluate(i, fraction, lateral_, lateral_second_).first,
                      evaluate(i, fraction, height_, height_second_).first);
  }

  std::vector<double> knot_;
  const std::vector<double>& lateral_;
  const std::vector<double>& height_;
  std::vector<double> lateral_second_;
  std::vector<double> height_second_;
};

std::size_t parts_for(double length) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / max_node_distance)));
}

std::vector<double> arc_lengths(const PlaneSpline& spline) {
  std::vector<double> knot = {0.0};
  for (std::size_t i = 0; i < spline.intervals(); ++i) {
    knot.push_back(knot.back() + spline.length(i, 0.0, 1.0));
  }
  return knot;
}

/// A curve through sensible points is hardly longer than their chords. Points that jump back and
/// forth, or a wide gap among close ones, make the spline swing, the more so each time its
/// parameter follows its length.
void check_detour(double length, double chords) {
  if (!(length <= max_detour * chords)) {
    throw_invalid_argument("length of the curve through the points", length,
                           "at most " + text_of(max_detour) + " times that of their chords, " +
                               text_of(chords) +
                               " mm: the points jump back and forth or leave a wide gap");
  }
}

} // namespace

Curve curve_through(std::span<const Position> points) {
  if (points.size() < 4) {
    throw_invalid_argument("number of points", std::to_string(points.size()), "at least 4");
  }
  std::vector<double> lateral;
  std::vector<double> height;
  std::vector<double> knot;
  for (const Position& point : points) {
    const double distance =
        knot.empty() ? 0.0 : std::hypot(point[0] - lateral.back(), point[1] - height.back());
    if (!std::isfinite(distance) || (!knot.empty() && !(distance > 0.0))) {
      throw_invalid_argument("distance of point " + std::to_string(knot.size()) +
                                 " from the previous one",
                             distance, "a positive finite number, mm");
    }
    knot.push_back(knot.empty() ? 0.0 : knot.back() + distance);
    lateral.push_back(point[0]);
    height.push_back(point[1]);
  }
  const double chords = knot.back();
  for (int i = 0; i < reparametrisations; ++i) {
    knot = arc_lengths(PlaneSpline(knot, lateral, height));
    check_detour(knot.back(), chords);
  }
  const PlaneSpline spline(knot, lateral, height);
  check_detour(arc_lengths(spline).back(), chords);

  std::vector<Curve::Piece> pieces;
  for (std::size_t i = 0; i < spline.intervals(); ++i) {
    const std::size_t parts = parts_for(spline.length(i, 0.0, 1.0));
    for (std::size_t part = 0; part < parts; ++part) {
      const double from = static_cast<double>(part) / static_cast<double>(parts);
      const double to = static_cast<double>(part + 1) / static_cast<double>(parts);
      pieces.push_back({spline.at(i, from), spline.at(i, to), spline.length(i, from, to)});
    }
  }
  return Curve{pieces};
}

} // namespace wrc
