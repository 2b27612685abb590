#include "profile/reinsch_spline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace wrc {

ReinschSpline::ReinschSpline(std::vector<double> knots, double length, bool is_periodic)
    : knots_(std::move(knots)), is_periodic_(is_periodic),
      lambda_(std::pow(length / (2.0 * std::numbers::pi), 4)) {
  if (unknowns() == 0) {
    return;
  }
  try {
    factor_.emplace_back(matrix());
  } catch (const Error&) {
    throw Error(ErrorCode::internal,
                "smoothing wavelength = " + text_of(length) +
                    " mm: too long relative to the spacing of the closest points");
  }
}

std::size_t ReinschSpline::unknowns() const {
  const std::size_t intervals = knots_.size() - 1;
  return is_periodic_ ? (intervals > 1 ? intervals : 0) : intervals - 1;
}

std::size_t ReinschSpline::knot_of(std::size_t unknown) const {
  return is_periodic_ ? unknown : unknown + 1;
}

bool ReinschSpline::has_row(std::size_t knot) const {
  return is_periodic_ || (knot > 0 && knot + 1 < knots_.size());
}

std::size_t ReinschSpline::row_of(std::size_t knot) const {
  if (!is_periodic_) {
    return knot - 1;
  }
  // Knots in turn from both ends of the period, which keeps neighbours around it in a band.
  const std::size_t n = unknowns();
  return knot < (n + 1) / 2 ? 2 * knot : 2 * (n - 1 - knot) + 1;
}

std::size_t ReinschSpline::before(std::size_t knot) const {
  return knot > 0 ? knot - 1 : unknowns() - 1; // of the first only if periodic
}

std::size_t ReinschSpline::after(std::size_t knot) const {
  return is_periodic_ && knot + 1 == unknowns() ? 0 : knot + 1;
}

ReinschSpline::Difference ReinschSpline::difference(std::size_t knot) const {
  const double first = 1.0 / step(before(knot));
  const double last = 1.0 / step(knot);
  return {first, -first - last, last};
}

double ReinschSpline::neighbourhood(std::size_t knot) const {
  const bool has_before = knot > 0 || is_periodic_;
  const bool has_after = knot + 1 < knots_.size();
  return 0.5 * ((has_before ? step(before(knot)) : 0.0) + (has_after ? step(knot) : 0.0));
}

BandMatrix ReinschSpline::matrix() const { // R + lambda Q' W^-1 Q
  const std::size_t n = unknowns();
  BandMatrix result(n, std::min<std::size_t>(n - 1, is_periodic_ ? 4 : 2));
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
  const std::size_t own_knots = is_periodic_ ? n : knots_.size();
  for (std::size_t knot = 0; knot < own_knots; ++knot) {
    // The rows in which the value at this knot stands, with its factor there.
    struct Entry {
      std::size_t row_knot;
      double factor;
    };
    std::vector<Entry> entries;
    if (knot > 0 || is_periodic_) {
      if (const std::size_t other = before(knot); has_row(other)) {
        entries.push_back({other, difference(other).after});
      }
    }
    if (has_row(knot)) {
      entries.push_back({knot, difference(knot).at});
    }
    if (is_periodic_ || knot + 1 < knots_.size()) {
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

ReinschSpline::Fit ReinschSpline::fit(std::vector<double> values) const {
  Fit fit{std::move(values), std::vector<double>(knots_.size(), 0.0)};
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
    const std::size_t own_knots = is_periodic_ ? unknowns() : knots_.size();
    for (std::size_t knot = 0; knot < own_knots; ++knot) {
      fit.value[knot] -= lambda_ / neighbourhood(knot) * change[knot];
    }
  }
  if (is_periodic_) {
    fit.value.back() = fit.value.front();
    fit.second.back() = fit.second.front();
  }
  return fit;
}

} // namespace wrc
