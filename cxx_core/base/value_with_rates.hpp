/// A number that carries its derivatives: arithmetic by the rules of differentiation.
///
/// Comparisons are those of the values, so a formula with decisions has the derivatives of the
/// branch taken. Where a root's or a modulus' derivative does not exist, at 0, it is taken as 0.
/// Thread rule: plain values.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>

namespace wrc {

/// Value of a plain number, so that templates can treat it as one with rates.
inline double value_of(double number) {
  return number;
}

template <std::size_t count> struct WithRates {
  double value = 0.0;
  std::array<double, count> rates{};

  WithRates() = default;
  // Constants stand among numbers with rates as they do among plain ones.
  WithRates(double constant) : value(constant) {} // NOLINT(google-explicit-constructor)
  WithRates(double v, const std::array<double, count>& r) : value(v), rates(r) {}
  /// The variable of this index.
  static WithRates variable(double value, std::size_t index) {
    WithRates result(value);
    result.rates[index] = 1.0;
    return result;
  }

  /// A function of one argument or of two, by its value and slopes.
  static WithRates of(double value, double slope, const WithRates& a) {
    WithRates result(value);
    for (std::size_t i = 0; i < count; ++i) {
      result.rates[i] = slope * a.rates[i];
    }
    return result;
  }
  static WithRates of(double value, double by_a, const WithRates& a, double by_b,
                      const WithRates& b) {
    WithRates result(value);
    for (std::size_t i = 0; i < count; ++i) {
      result.rates[i] = by_a * a.rates[i] + by_b * b.rates[i];
    }
    return result;
  }

  friend WithRates operator-(const WithRates& a) { return of(-a.value, -1.0, a); }
  friend WithRates operator+(const WithRates& a, const WithRates& b) {
    return of(a.value + b.value, 1.0, a, 1.0, b);
  }
  friend WithRates operator-(const WithRates& a, const WithRates& b) {
    return of(a.value - b.value, 1.0, a, -1.0, b);
  }
  friend WithRates operator*(const WithRates& a, const WithRates& b) {
    return of(a.value * b.value, b.value, a, a.value, b);
  }
  friend WithRates operator/(const WithRates& a, const WithRates& b) {
    const double ratio = a.value / b.value;
    return of(ratio, 1.0 / b.value, a, -ratio / b.value, b);
  }
  WithRates& operator+=(const WithRates& other) { return *this = *this + other; }
  WithRates& operator*=(const WithRates& other) { return *this = *this * other; }

  friend bool operator==(const WithRates& a, const WithRates& b) { return a.value == b.value; }
  friend auto operator<=>(const WithRates& a, const WithRates& b) { return a.value <=> b.value; }

  friend double value_of(const WithRates& a) { return a.value; }
  friend WithRates abs(const WithRates& a) {
    return of(std::abs(a.value), a.value > 0.0 ? 1.0 : (a.value < 0.0 ? -1.0 : 0.0), a);
  }
  friend WithRates sqrt(const WithRates& a) {
    const double root = std::sqrt(a.value);
    return of(root, root > 0.0 ? 0.5 / root : 0.0, a);
  }
  friend WithRates exp(const WithRates& a) {
    const double power = std::exp(a.value);
    return of(power, power, a);
  }
  friend WithRates sin(const WithRates& a) { return of(std::sin(a.value), std::cos(a.value), a); }
  friend WithRates cos(const WithRates& a) { return of(std::cos(a.value), -std::sin(a.value), a); }
  friend WithRates atan(const WithRates& a) {
    return of(std::atan(a.value), 1.0 / (1.0 + a.value * a.value), a);
  }
  friend WithRates atan2(const WithRates& y, const WithRates& x) {
    const double square = x.value * x.value + y.value * y.value;
    return of(std::atan2(y.value, x.value), x.value / square, y, -y.value / square, x);
  }
  friend WithRates lerp(const WithRates& a, const WithRates& b, const WithRates& t) {
    WithRates result = a + t * (b - a);
    result.value = std::lerp(a.value, b.value, t.value);
    return result;
  }
};

} // namespace wrc
