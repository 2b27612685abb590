#include "profile/along_spline.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "profile/constants.hpp"

namespace wrc {
namespace {

void check(std::span<const double> places, double smoothing_length, double period) {
  const std::size_t least = period > 0.0 ? 1 : 2;
  if (places.size() < least) {
    throw_invalid_argument("number of slices", std::to_string(places.size()),
                           "at least " + std::to_string(least));
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!std::isfinite(places[i]) || (i > 0 && !(places[i] > places[i - 1]))) {
      throw_invalid_argument("place of slice " + std::to_string(i + 1), places[i],
                             "a finite number above that of the slice before");
    }
  }
  if (period > 0.0 && !(places.back() - places.front() < period)) {
    throw_invalid_argument("angles of the slices", places.back() - places.front(),
                           "must be less than one revolution, " + short_text_of(period) +
                               ": leave out the last slice if it repeats the first");
  }
  if (!(smoothing_length >= 0.0) || !std::isfinite(smoothing_length)) {
    throw_invalid_argument("smoothing length along", smoothing_length, "0 or more");
  }
}

} // namespace

AlongSpline::AlongSpline(std::span<const double> places, double smoothing_length, double period)
    : period_(period), places_(places.size()) {
  check(places, smoothing_length, period);
  const std::vector<double> knots = add_knots(places);
  double closest = knots.back() - knots.front();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    closest = std::min(closest, knots[i + 1] - knots[i]);
  }
  if (knots.size() > 2 && !(smoothing_length <= longest_along_smoothing * closest)) {
    throw_invalid_argument("smoothing length along", smoothing_length,
                           "at most " + text_of(longest_along_smoothing) +
                               " distances of the closest knots, " + text_of(closest));
  }
  spline_ = ReinschSpline(knots, smoothing_length, is_periodic());
}

std::vector<double> AlongSpline::add_knots(std::span<const double> places) {
  std::vector<double> knots(places.begin(), places.end());
  const auto step = [&knots](std::size_t i) { return knots[i + 1] - knots[i]; };
  if (is_periodic()) {
    knots.push_back(places.front() + period_);
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    place_before_.push_back(i);
  }
  for (bool grew = true; grew;) {
    grew = false;
    std::vector<double> finer{knots.front()};
    std::vector<std::size_t> origin;
    const std::size_t intervals = knots.size() - 1;
    for (std::size_t i = 0; i < intervals; ++i) {
      const bool first = i == 0;
      const bool last = i + 1 == intervals;
      const double left = !first ? step(i - 1) : is_periodic() ? step(intervals - 1) : step(i);
      const double right = !last ? step(i + 1) : is_periodic() ? step(0) : step(i);
      if (step(i) > most_growth * std::min(left, right)) {
        finer.push_back(0.5 * (knots[i] + knots[i + 1]));
        origin.push_back(place_before_[i]);
        grew = true;
      }
      finer.push_back(knots[i + 1]);
      origin.push_back(place_before_[i]);
    }
    if (finer.size() > max_knots) {
      throw_invalid_argument("number of slices, with knots between those far apart",
                             std::to_string(finer.size()), "at most " + std::to_string(max_knots));
    }
    knots = std::move(finer);
    place_before_ = std::move(origin);
  }
  for (std::size_t k = 0; k < place_before_.size(); ++k) {
    const std::size_t i = place_before_[k];
    const double next = i + 1 < places.size() ? places[i + 1] : places.front() + period_;
    share_.push_back((knots[k] - places[i]) / (next - places[i]));
  }
  return knots;
}

AlongSpline::Fit AlongSpline::fit(std::span<const double> values_at_places) const {
  if (values_at_places.size() != places_) {
    throw_invalid_argument("number of values", std::to_string(values_at_places.size()),
                           std::to_string(places_) + ", as there are slices");
  }
  std::vector<double> values;
  values.reserve(knots().size());
  for (std::size_t k = 0; k < place_before_.size(); ++k) {
    const double value = values_at_places[place_before_[k]];
    const double next = values_at_places[(place_before_[k] + 1) % places_];
    values.push_back(value + share_[k] * (next - value));
  }
  values.push_back(is_periodic() ? values_at_places.front() : values_at_places.back());
  return spline_.fit(std::move(values));
}

std::size_t AlongSpline::last_place_knot() const {
  return static_cast<std::size_t>(
      std::lower_bound(place_before_.begin(), place_before_.end(), places_ - 1) -
      place_before_.begin());
}

AlongPlace AlongSpline::locate(double along) const {
  const std::span<const double> knots = this->knots();
  double inside = std::clamp(along, knots.front(), knots.back());
  if (is_periodic() && inside != along) {
    const double turns = std::floor((along - knots.front()) / period_);
    inside = std::clamp(along - turns * period_, knots.front(), knots.back());
  }
  // Not-a-number lands in the last interval.
  const auto found = std::upper_bound(knots.begin() + 1, knots.end() - 1, inside);
  const auto interval = static_cast<std::size_t>(found - knots.begin() - 1);
  const double step = knots[interval + 1] - knots[interval];
  return {interval, step, (inside - knots[interval]) / step};
}

} // namespace wrc
