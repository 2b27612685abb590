/// A cubic spline along the track or around a wheel, for many quantities given at the same places.
///
/// Minimises  sum w_i (y_i - f(x_i))^2 + lambda int f''^2 dx  (Reinsch, Smoothing by spline
/// functions, Numerische Mathematik 10, 1967), w_i half the distance between the neighbours of
/// place i, lambda = (length / 2 pi)^4: waves of the smoothing length are halved, shorter ones
/// vanish. Length 0: the spline passes through the values, error O(h^4), of the second derivative
/// O(h^2). C2 in both cases; natural ends (f'' = 0), or periodic.
/// An interval much longer than its neighbour gets knots in between, on the straight line between
/// both ends: the spline of 5 mm slices would otherwise swing over the metres of plain rail beside
/// them.
/// Linear in the values: equal values give exactly themselves, values on a straight line that line
/// to rounding. Natural ends pull curvature to zero within an interval of the ends.
/// Units are the caller's. Thread rule: immutable after construction, safe to share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "profile/banded_system.hpp"

namespace wrc {

/// A place within an interval between two knots.
struct AlongPlace {
  std::size_t interval = 0;
  double step = 0.0;     ///< length of the interval
  double fraction = 0.0; ///< of it
};

class AlongSpline {
public:
  /// Longest smoothing length, in distances of the closest places.
  /// origin: derived: the terms of the matrix then differ by (1000 / 2 pi)^4 = 6e8, which leaves
  /// seven digits.
  static constexpr double longest_smoothing = 1000.0;

  AlongSpline() = default;
  /// `period` 0: not periodic. Throws Error(invalid_argument): places that do not ascend, are fewer
  /// than two (periodic: one) or span more than the period; a smoothing length that is negative, or
  /// too long for the closest places; more than `max_knots` knots.
  AlongSpline(std::span<const double> places, double smoothing_length, double period);

  /// From the first to the last place, or one period on from the first.
  [[nodiscard]] std::span<const double> knots() const { return knots_; }
  [[nodiscard]] bool is_periodic() const { return period_ > 0.0; }
  [[nodiscard]] double period() const { return period_; }
  /// Number of the place at the begin of an interval.
  [[nodiscard]] std::size_t place_before(std::size_t interval) const {
    return place_before_[interval];
  }
  /// Number of the knot at the last place: that at the end unless periodic.
  [[nodiscard]] std::size_t last_place_knot() const;
  /// Where an abscissa lies: clamped to the ends, or taken modulo the period.
  [[nodiscard]] AlongPlace locate(double along) const;

  /// Value and second derivative of the spline at the knots.
  struct Fit {
    std::vector<double> value;
    std::vector<double> second;
  };
  [[nodiscard]] Fit fit(std::span<const double> values_at_places) const;

private:
  /// The second difference of values about a knot: of those before, at and after it.
  struct Difference {
    double before;
    double at;
    double after;
  };
  void add_knots(std::span<const double> places);
  [[nodiscard]] std::size_t unknowns() const;
  [[nodiscard]] std::size_t knot_of(std::size_t unknown) const;
  [[nodiscard]] std::size_t row_of(std::size_t knot) const;
  [[nodiscard]] bool has_row(std::size_t knot) const;
  [[nodiscard]] std::size_t before(std::size_t knot) const;
  [[nodiscard]] std::size_t after(std::size_t knot) const;
  [[nodiscard]] double step(std::size_t interval) const {
    return knots_[interval + 1] - knots_[interval];
  }
  [[nodiscard]] Difference difference(std::size_t knot) const;
  [[nodiscard]] double neighbourhood(std::size_t knot) const;
  [[nodiscard]] BandMatrix matrix() const;

  double period_ = 0.0;
  double lambda_ = 0.0;
  std::vector<double> knots_;
  std::vector<std::size_t> place_before_; ///< of intervals
  std::vector<double> share_;             ///< of the way to the next place, at knots
  std::size_t places_ = 0;
  std::vector<BandCholesky> factor_; ///< none without unknowns
};

} // namespace wrc
