/// Which part of a line's scatter is noise: a smoothing spline whose penalty follows the place.
///
/// Data are the offsets r_i of points from a reference curve, at arcs s_i along it. The model is
///   r_i = u(s_i) + noise of deviation sigma,
///   curvature of the reference + u'' = drift + waviness,
/// d drift / ds a white noise of intensity q(s), the waviness one of intensity b(s): lines and arcs
/// cost nothing, changes of curvature cost more on a tread than in a flange root, and worn treads
/// have waves that new ones do not have. u is a cubic spline on equal intervals (Eilers and Marx,
/// Flexible smoothing with B-splines and penalties, Statistical Science 11, 1996); drift and u
/// minimise the sum of squares of all three, each over its variance. Noise is independent from
/// point to point, or from a distance on, if an instrument's filter has smoothed it: then points
/// that are that far apart give sigma, q and b, without a model of the filter, and all points with
/// the weight of one in each distance give u.
///
/// sigma, q and b are those of the largest restricted likelihood and follow from the fixed point of
/// Wood and Fasiolo, A generalized Fellner-Schall method for
/// smoothing parameter optimization (Biometrics 73, 2017). q and b are averages over a
/// neighbourhood of about the waves that are halved there (penalties that vary in space:
/// Krivobokova, Crainiceanu and Kauermann, Fast adaptive penalized splines, J. Comput. Graph.
/// Statist. 17, 2008). What remains uncertain of u is its distribution given the data, whose
/// intervals also hold a fixed truth as often as they say (Nychka, Bayesian confidence intervals
/// for smoothing splines, J. Am. Statist. Ass. 83, 1988).
///
/// Cost: linear in the points, about 0.1 s a wheel. Units mm. Points far off
/// have less weight. Does not know: noise that differs from place to place. Thread rule: no state.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "profile/banded_system.hpp"

namespace wrc {

/// Cubic splines on `intervals` equal intervals from 0 to length.
struct SplineBasis {
  double length = 1.0;
  std::size_t intervals = 1;

  [[nodiscard]] double step() const { return length / static_cast<double>(intervals); }
  [[nodiscard]] std::size_t size() const { return intervals + 3; }
  /// The value at an arc, clamped, of the spline with these coefficients.
  [[nodiscard]] double value(std::span<const double> coefficients, double arc) const;
};

struct OffsetData {
  std::vector<double> arc; ///< ascending
  std::vector<double> offset;
  std::vector<double> weight; ///< inverse deviation in sigmas, 1 for most
};

/// Weights of residuals that limit the influence of points far off (Huber, Robust estimation of a
/// location parameter, Ann. Math. Statist. 35, 1964): 1 up to three robust deviations.
std::vector<double> weights_of(std::span<const double> residuals);

struct NoiseFit {
  SplineBasis basis;
  double deviation = 0.0;   ///< sigma, mm
  double distance = 0.0;    ///< at which points have independent noise, mm; 0: their own
  double deviance = 0.0;    ///< -2 log of the restricted likelihood, up to a constant
  double correlation = 0.0; ///< of neighbouring residuals (fit_apart)
  double repetition = 0.0;  ///< largest correlation of others (fit_apart)
  std::vector<double> coefficients;
  std::vector<double> wavelength;                ///< of waves that are halved, mm, per interval
  std::vector<double> drift;                     ///< q, mm^-3, per interval
  std::vector<double> waviness;                  ///< b, mm^-1, per interval's end
  std::shared_ptr<const BandCholesky> precision; ///< inverse of the unknowns' covariance

  /// Offsets less those of the spline.
  [[nodiscard]] std::vector<double> residuals(const OffsetData& data) const;
  /// Coefficients drawn from their distribution; `normal` returns independent normal numbers.
  [[nodiscard]] std::vector<double> draw(const std::function<double()>& normal) const;
};

/// Correlation of residuals that are `lag` places apart, -1 to 1.
double correlation_of(std::span<const double> residuals, std::size_t lag = 1);

/// The noise of each point independent; `data` gets the weights that limit the influence of points
/// far off. `curvature`: of the reference at the ends of the intervals, 1/mm. Throws
/// Error(internal) if a system cannot be solved.
NoiseFit fit_noise(const SplineBasis& basis, OffsetData& data, std::span<const double> curvature);
/// The same from points that are at least this far apart, taking what they scatter as noise.
NoiseFit fit_apart(const SplineBasis& basis, const OffsetData& data,
                   std::span<const double> curvature, double distance);
/// The same for nearly the same data as before, of which all points count.
NoiseFit fit_again(const SplineBasis& basis, const OffsetData& data,
                   std::span<const double> curvature, const NoiseFit& before);

} // namespace wrc
