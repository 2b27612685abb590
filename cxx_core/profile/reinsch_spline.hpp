/// A cubic spline that passes through values at its knots, or smooths them.
///
/// Minimises  sum w_i (y_i - f(x_i))^2 + lambda int f''^2 dx  (Reinsch, Smoothing by spline
/// functions, Numerische Mathematik 10, 1967), w_i half the distance between the neighbours of knot
/// i, so that the sum stands for an integral whatever the spacing. A wave of length L is passed by
/// 1 / (1 + lambda (2 pi / L)^4); lambda = (length / 2 pi)^4 halves waves of the smoothing length.
/// Length 0: the spline passes through the values, error O(h^4), of the second derivative O(h^2).
/// C2 in both cases; natural ends (f'' = 0), which pull curvature to zero within a smoothing
/// length, or periodic. Linear in the values: equal values give exactly themselves. Units are the
/// caller's. Thread rule: immutable after construction, safe to share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "profile/banded_system.hpp"

namespace wrc {

class ReinschSpline {
public:
  ReinschSpline() = default;
  /// Knots ascend; of a periodic spline the last is the first, one period on. Throws
  /// Error(internal) if the length is so long against the closest knots that the system is not
  /// positive definite in double precision.
  ReinschSpline(std::vector<double> knots, double length, bool is_periodic);

  [[nodiscard]] std::span<const double> knots() const { return knots_; }
  /// Value and second derivative of the spline at the knots.
  struct Fit {
    std::vector<double> value;
    std::vector<double> second;
  };
  /// One value for each knot.
  [[nodiscard]] Fit fit(std::vector<double> values) const;

private:
  /// The second difference of values about a knot: of those before, at and after it.
  struct Difference {
    double before;
    double at;
    double after;
  };
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

  std::vector<double> knots_;
  bool is_periodic_ = false;
  double lambda_ = 0.0;
  std::vector<BandCholesky> factor_; ///< none without unknowns
};

} // namespace wrc
