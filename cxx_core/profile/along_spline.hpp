/// A cubic spline along the track or around a wheel, for many quantities given at the same places.
///
/// That of reinsch_spline.hpp, smoothed or through the values. An interval much longer than its
/// neighbour gets knots in between, on the straight line between both ends: the spline of 5 mm
/// slices would otherwise swing over the metres of plain rail beside them. Linear in the values:
/// equal values give exactly themselves, values on a straight line that line to rounding. Natural
/// ends pull curvature to zero within an interval of the ends. Units are the caller's. Thread rule:
/// immutable after construction, safe to share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "profile/constants.hpp"
#include "profile/reinsch_spline.hpp"

namespace wrc {

/// A place within an interval between two knots.
struct AlongPlace {
  std::size_t interval = 0;
  double step = 0.0;     ///< length of the interval
  double fraction = 0.0; ///< of it
};

class AlongSpline {
public:
  AlongSpline() = default;
  /// `period` 0: not periodic. Throws Error(invalid_argument): places that do not ascend, are fewer
  /// than two (periodic: one) or span more than the period; a smoothing length that is negative, or
  /// too long for the closest places; more than `max_knots` knots.
  AlongSpline(std::span<const double> places, double smoothing_length, double period);

  using Fit = ReinschSpline::Fit;

  /// From the first to the last place, or one period on from the first.
  [[nodiscard]] std::span<const double> knots() const { return spline_.knots(); }
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

  [[nodiscard]] Fit fit(std::span<const double> values_at_places) const;

private:
  std::vector<double> add_knots(std::span<const double> places);

  double period_ = 0.0;
  std::size_t places_ = 0;
  std::vector<std::size_t> place_before_; ///< of intervals
  std::vector<double> share_;             ///< of the way to the next place, at knots
  ReinschSpline spline_;
};

} // namespace wrc
