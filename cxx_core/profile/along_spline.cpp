#include "profile/along_spline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
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
                           "allowed is less than one revolution, " + short_text_of(period) +
                               ": leave out the last slice if it repeats the first");
  }
  if (!(smoothing_length >= 0.0) || !std::isfinite(smoothing_length)) {
    throw_invalid_argument("smoothing length along", smoothing_length, "0 or more");
  }
}

} // namespace

AlongSpline::AlongSpline(std::span<const double> places, double smoothing_length, double period)
    : period_(period), lambda_(0.0) {
  check(places, smoothing_length, period);
  lambda_ = std::pow(smoothing_length / (2.0 * std::numbers::pi), 4);
  places_ = places.size();
  add_knots(places);
  if (unknowns() == 0) {
    return;
  }
  double closest = knots_.back() - knots_.front();
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    closest = std::min(closest, step(i));
  }
  if (!(smoothing_length <= longest_smoothing * closest)) {
    throw_invalid_argument("smoothing length along", smoothing_length,
                           "at most " + text_of(longest_smoothing) +
                               " distances of the closest knots, " + text_of(closest));
  }
  factor_.emplace_back(matrix());
}

void AlongSpline::add_knots(std::span<const double> places) {
  knots_.assign(places.begin(), places.end());
  if (is_periodic()) {
    knots_.push_back(places.front() + period_);
  }
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    place_before_.push_back(i);
  }
  for (bool grew = true; grew;) {
    grew = false;
    std::vector<double> finer{knots_.front()};
    std::vector<std::size_t> origin;
    const std::size_t intervals = knots_.size() - 1;
    for (std::size_t i = 0; i < intervals; ++i) {
      const bool first = i == 0;
      const bool last = i + 1 == intervals;
      const double left = !first ? step(i - 1) : is_periodic() ? step(intervals - 1) : step(i);
      const double right = !last ? step(i + 1) : is_periodic() ? step(0) : step(i);
      if (step(i) > most_growth * std::min(left, right)) {
        finer.push_back(0.5 * (knots_[i] + knots_[i + 1]));
        origin.push_back(place_before_[i]);
        grew = true;
      }
      finer.push_back(knots_[i + 1]);
      origin.push_back(place_before_[i]);
    }
    if (finer.size() > max_knots) {
      throw_invalid_argument("number of slices, with knots between those far apart",
                             std::to_string(finer.size()), "at most " + std::to_string(max_knots));
    }
    knots_ = std::move(finer);
    place_before_ = std::move(origin);
  }
  for (std::size_t k = 0; k < place_before_.size(); ++k) {
    const std::size_t i = place_before_[k];
    const double next = i + 1 < places.size() ? places[i + 1] : places.front() + period_;
    share_.push_back((knots_[k] - places[i]) / (next - places[i]));
  }
}

std::size_t AlongSpline::unknowns() const {
  const std::size_t intervals = knots_.size() - 1;
  return is_periodic() ? (intervals > 1 ? intervals : 0) : intervals - 1;
}

std::size_t AlongSpline::knot_of(std::size_t unknown) const {
  return is_periodic() ? unknown : unknown + 1;
}

bool AlongSpline::has_row(std::size_t knot) const {
  return is_periodic() || (knot > 0 && knot + 1 < knots_.size());
}

std::size_t AlongSpline::row_of(std::size_t knot) const {
  if (!is_periodic()) {
    return knot - 1;
  }
  // Knots in turn from both ends of the period, which keeps neighbours around it in a band.
  const std::size_t n = unknowns();
  return knot < (n + 1) / 2 ? 2 * knot : 2 * (n - 1 - knot) + 1;
}

std::size_t AlongSpline::before(std::size_t knot) const {
  return knot > 0 ? knot - 1 : unknowns() - 1; // of the first only if periodic
}

std::size_t AlongSpline::after(std::size_t knot) const {
  return is_periodic() && knot + 1 == unknowns() ? 0 : knot + 1;
}

AlongSpline::Difference AlongSpline::difference(std::size_t knot) const {
  const double first = 1.0 / step(before(knot));
  const double last = 1.0 / step(knot);
  return {first, -first - last, last};
}

double AlongSpline::neighbourhood(std::size_t knot) const {
  const bool has_before = knot > 0 || is_periodic();
  const bool has_after = knot + 1 < knots_.size();
  return 0.5 * ((has_before ? step(before(knot)) : 0.0) + (has_after ? step(knot) : 0.0));
}

BandMatrix AlongSpline::matrix() const { // R + lambda Q' W^-1 Q
  const std::size_t n = unknowns();
  BandMatrix result(n, std::min<std::size_t>(n - 1, is_periodic() ? 4 : 2));
  const auto add = [&](std::size_t one, std::size_t other, double value) {
    if (row_of(one) >= row_of(other)) {
      result.at(row_of(one), row_of(other)) += value;
    }
  };
  for (std::size_t unknown = 0; unknown < n; ++unknown) {
    const std::size_t knot = knot_of(unknown);
    add(knot, knot, (step(before(knot)) + step(knot)) / 3.0);
    if (has_row(after(knot))) {
      add(knot, after(knot), step(knot) / 6.0);
      add(after(knot), knot, step(knot) / 6.0);
    }
  }
  if (lambda_ == 0.0) {
    return result;
  }
  const std::size_t own_knots = is_periodic() ? n : knots_.size();
  for (std::size_t knot = 0; knot < own_knots; ++knot) {
    // The rows in which the value at this knot stands, with its factor there.
    struct Entry {
      std::size_t row_knot;
      double factor;
    };
    std::vector<Entry> entries;
    if (knot > 0 || is_periodic()) {
      if (const std::size_t other = before(knot); has_row(other)) {
        entries.push_back({other, difference(other).after});
      }
    }
    if (has_row(knot)) {
      entries.push_back({knot, difference(knot).at});
    }
    if (is_periodic() || knot + 1 < knots_.size()) {
      if (const std::size_t other = after(knot); has_row(other)) {
        entries.push_back({other, difference(other).before});
      }
    }
    for (const Entry& one : entries) {
      for (const Entry& other : entries) {
        add(one.row_knot, other.row_knot,
            lambda_ * one.factor * other.factor / neighbourhood(knot));
      }
    }
  }
  return result;
}

AlongSpline::Fit AlongSpline::fit(std::span<const double> values_at_places) const {
  if (values_at_places.size() != places_) {
    throw_invalid_argument("number of values", std::to_string(values_at_places.size()),
                           std::to_string(places_) + ", as there are slices");
  }
  Fit fit;
  fit.value.reserve(knots_.size());
  for (std::size_t k = 0; k < place_before_.size(); ++k) {
    const double value = values_at_places[place_before_[k]];
    const double next = values_at_places[(place_before_[k] + 1) % places_];
    fit.value.push_back(value + share_[k] * (next - value));
  }
  fit.value.push_back(is_periodic() ? values_at_places.front() : values_at_places.back());
  fit.second.assign(knots_.size(), 0.0);
  if (factor_.empty()) {
    return fit;
  }

  std::vector<double> right(unknowns());
  for (std::size_t unknown = 0; unknown < unknowns(); ++unknown) {
    const std::size_t knot = knot_of(unknown);
    right[row_of(knot)] = (fit.value[knot + 1] - fit.value[knot]) / step(knot) -
                          (fit.value[knot] - fit.value[before(knot)]) / step(before(knot));
  }
  right = factor_.front().solve(std::move(right));
  for (std::size_t unknown = 0; unknown < unknowns(); ++unknown) {
    fit.second[knot_of(unknown)] = right[row_of(knot_of(unknown))];
  }
  if (lambda_ > 0.0) {
    std::vector<double> change(knots_.size(), 0.0);
    for (std::size_t unknown = 0; unknown < unknowns(); ++unknown) {
      const std::size_t knot = knot_of(unknown);
      const Difference d = difference(knot);
      change[before(knot)] += d.before * fit.second[knot];
      change[knot] += d.at * fit.second[knot];
      change[after(knot)] += d.after * fit.second[knot];
    }
    const std::size_t own_knots = is_periodic() ? unknowns() : knots_.size();
    for (std::size_t knot = 0; knot < own_knots; ++knot) {
      fit.value[knot] -= lambda_ / neighbourhood(knot) * change[knot];
    }
  }
  if (is_periodic()) {
    fit.value.back() = fit.value.front();
    fit.second.back() = fit.second.front();
  }
  return fit;
}

std::size_t AlongSpline::last_place_knot() const {
  return static_cast<std::size_t>(
      std::lower_bound(place_before_.begin(), place_before_.end(), places_ - 1) -
      place_before_.begin());
}

AlongPlace AlongSpline::locate(double along) const {
  double inside = std::clamp(along, knots_.front(), knots_.back());
  if (is_periodic() && inside != along) {
    const double turns = std::floor((along - knots_.front()) / period_);
    inside = std::clamp(along - turns * period_, knots_.front(), knots_.back());
  }
  // Not-a-number lands in the last interval.
  const auto found = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, inside);
  const auto interval = static_cast<std::size_t>(found - knots_.begin() - 1);
  return {interval, step(interval), (inside - knots_[interval]) / step(interval)};
}

} // namespace wrc
