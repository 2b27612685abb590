#include "measured/noise_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "measured/constants.hpp"

namespace wrc {
namespace {

/// Four values of cubic B-splines.
struct Row {
  std::size_t first = 0;
  std::array<double, 4> value{};
};

Row row_at(const SplineBasis& basis, double arc) {
  const double place = std::clamp(arc, 0.0, basis.length) / basis.step();
  Row row;
  row.first = std::min(static_cast<std::size_t>(place), basis.intervals - 1);
  const double t = place - static_cast<double>(row.first);
  const double v = 1.0 - t;
  row.value = {v * v * v / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
               (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, t * t * t / 6.0};
  return row;
}

/// B' B and so on, weighted, which do not depend on sigma and q.
struct Sums {
  BandMatrix matrix;
  std::vector<double> right_side;
  double squares = 0.0;
  double count = 0.0;
};

Sums sums_of(const SplineBasis& basis, const OffsetData& data) {
  Sums sums{BandMatrix(basis.size(), 3), std::vector<double>(basis.size(), 0.0)};
  for (std::size_t i = 0; i < data.arc.size(); ++i) {
    const Row row = row_at(basis, data.arc[i]);
    const double weight = data.weight[i] * data.weight[i];
    for (std::size_t a = 0; a < 4; ++a) {
      sums.right_side[row.first + a] += weight * row.value[a] * data.offset[i];
      for (std::size_t b = 0; b <= a; ++b) {
        sums.matrix.at(row.first + a, row.first + b) += weight * row.value[a] * row.value[b];
      }
    }
    sums.squares += weight * data.offset[i] * data.offset[i];
    sums.count += 1.0;
  }
  return sums;
}

/// Where the unknowns are: coefficients and drifting curvatures by turns.
std::size_t coefficient_index(std::size_t k) {
  return 2 * k;
}
std::size_t drift_index(std::size_t knot) {
  return 2 * knot + 3;
}

/// A sum of a few unknowns.
template <std::size_t count> struct Combination {
  std::array<std::size_t, count> index;
  std::array<double, count> factor;

  [[nodiscard]] double value(const std::vector<double>& unknowns) const {
    double sum = 0.0;
    for (std::size_t a = 0; a < count; ++a) {
      sum += factor[a] * unknowns[index[a]];
    }
    return sum;
  }
  /// Its variance under a covariance.
  [[nodiscard]] double variance(const BandMatrix& covariance) const {
    double sum = 0.0;
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < count; ++b) {
        sum += factor[a] * factor[b] * covariance.value(index[a], index[b]);
      }
    }
    return sum;
  }
  /// Adds weight * (combination - target)^2.
  void add_to(BandMatrix& matrix, std::vector<double>& right_side, double weight,
              double target) const {
    for (std::size_t a = 0; a < count; ++a) {
      right_side[index[a]] += weight * target * factor[a];
      for (std::size_t b = 0; b < count; ++b) {
        if (index[b] <= index[a]) {
          matrix.at(index[a], index[b]) += weight * factor[a] * factor[b];
        }
      }
    }
  }
};

/// A component of the prior: independent values, equally spaced, of variance intensity * unit.
struct Component {
  std::vector<double> intensity;
  double unit = 1.0;
  double usual = 0.0;
  std::vector<double> square{}; ///< of the values, over unit
  std::vector<double> known{};  ///< how much of it the data decide, 0 to 1
};

/// The fixed point of sigma and the intensities.
class Fit {
public:
  Fit(const SplineBasis& basis, const Sums& sums, std::span<const double> curvature, double spacing)
      : basis_(basis), sums_(sums), curvature_(curvature), spacing_(spacing) {
    drift_.unit = basis.step();
    drift_.usual = usual_drift;
    waviness_.unit = 1.0 / basis.step();
    waviness_.usual = usual_waviness;
  }

  void start(double variance, const std::vector<double>& drift,
             const std::vector<double>& waviness) {
    variance_ = variance;
    drift_.intensity = drift;
    waviness_.intensity = waviness;
  }
  void run(int rounds) {
    bool settled = false;
    for (int round = 0; round < rounds && !settled; ++round) {
      solve();
      settled = update();
    }
    solve();
  }
  /// -2 log of the restricted likelihood.
  [[nodiscard]] double deviance() const {
    double sum =
        sums_.count * std::log(variance_) + factor_->log_determinant() + residual() / variance_;
    const auto add = [&](const Component& component, std::size_t j, double value) {
      const double variance = component.intensity[j] * component.unit;
      sum += std::log(variance) + value * value / variance;
    };
    for (std::size_t j = 0; j < basis_.intervals; ++j) {
      add(drift_, j, drift_at(j).value(unknowns_));
    }
    for (std::size_t j = 0; j <= basis_.intervals; ++j) {
      add(waviness_, j, waviness_at(j).value(unknowns_) + curvature_[j]);
    }
    return sum;
  }
  [[nodiscard]] NoiseFit result() const {
    NoiseFit fit;
    fit.basis = basis_;
    fit.deviation = std::sqrt(variance_);
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      fit.coefficients.push_back(unknowns_[coefficient_index(k)]);
    }
    for (std::size_t j = 0; j < basis_.intervals; ++j) {
      fit.wavelength.push_back(wavelength_at(j));
    }
    fit.drift = drift_.intensity;
    fit.waviness = waviness_.intensity;
    fit.precision = factor_;
    return fit;
  }

private:
  [[nodiscard]] static Combination<2> drift_at(std::size_t j) {
    return {{drift_index(j), drift_index(j + 1)}, {-1.0, 1.0}};
  }
  [[nodiscard]] Combination<4> waviness_at(std::size_t j) const {
    const double scale = 1.0 / (basis_.step() * basis_.step());
    return {
        {coefficient_index(j), coefficient_index(j + 1), coefficient_index(j + 2), drift_index(j)},
        {scale, -2.0 * scale, scale, -1.0}};
  }
  [[nodiscard]] double residual() const {
    double sum = sums_.squares;
    const std::size_t n = basis_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double here = unknowns_[coefficient_index(i)];
      double product = 0.0;
      for (std::size_t k = i >= sums_.matrix.width() ? i - sums_.matrix.width() : 0;
           k <= std::min(n - 1, i + sums_.matrix.width()); ++k) {
        product += sums_.matrix.value(i, k) * unknowns_[coefficient_index(k)];
      }
      sum += here * (product - 2.0 * sums_.right_side[i]);
    }
    return std::max(sum, std::max(least_residual * sums_.squares, least_variance * sums_.count));
  }
  void solve() {
    const std::size_t n = basis_.size();
    BandMatrix matrix(2 * n, std::max<std::size_t>(4, 2 * sums_.matrix.width()));
    std::vector<double> right_side(2 * n, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      right_side[coefficient_index(j)] = sums_.right_side[j] / variance_;
      for (std::size_t i = j; i <= std::min(n - 1, j + sums_.matrix.width()); ++i) {
        matrix.at(coefficient_index(i), coefficient_index(j)) = sums_.matrix.at(i, j) / variance_;
      }
    }
    matrix.at(1, 1) = matrix.at(2 * n - 1, 2 * n - 1) = 1.0; // no unknowns
    for (std::size_t j = 0; j < basis_.intervals; ++j) {
      drift_at(j).add_to(matrix, right_side, 1.0 / (drift_.intensity[j] * drift_.unit), 0.0);
    }
    for (std::size_t j = 0; j <= basis_.intervals; ++j) {
      waviness_at(j).add_to(matrix, right_side, 1.0 / (waviness_.intensity[j] * waviness_.unit),
                            -curvature_[j]);
    }
    factor_ = std::make_shared<const BandCholesky>(std::move(matrix));
    unknowns_ = factor_->solve(std::move(right_side));
  }
  /// New sigma and intensities; returns whether they have settled.
  bool update() {
    const BandMatrix covariance = factor_->inverse();
    measure(
        drift_, drift_.intensity.size(), [](std::size_t j) { return drift_at(j); },
        [](std::size_t) { return 0.0; }, covariance);
    measure(
        waviness_, waviness_.intensity.size(), [this](std::size_t j) { return waviness_at(j); },
        [this](std::size_t j) { return curvature_[j]; }, covariance);
    std::vector<double> near_drift;
    std::vector<double> near_waviness;
    for (std::size_t j = 0; j < basis_.intervals; ++j) {
      near_drift.push_back(
          std::clamp(wavelength_at(j), drift_neighbourhood[0], drift_neighbourhood[1]));
      near_waviness.push_back(
          std::max(least_of_waviness, waviness_neighbourhoods * near_drift.back()));
    }
    near_waviness.push_back(near_waviness.back());
    const double variance = residual() / freedom(covariance);
    const double change = std::abs(std::log(variance / variance_));
    variance_ = variance;
    const double drift_change = average(drift_, near_drift);
    const double waviness_change = average(waviness_, near_waviness);
    return change < settled_variance && std::max(drift_change, waviness_change) < settled_intensity;
  }
  /// Points less the parameters that they decide.
  [[nodiscard]] double freedom(const BandMatrix& covariance) const {
    const std::size_t n = basis_.size();
    double trace = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = j; i <= std::min(n - 1, j + sums_.matrix.width()); ++i) {
        trace += (i == j ? 1.0 : 2.0) * sums_.matrix.at(i, j) *
                 covariance.at(coefficient_index(i), coefficient_index(j));
      }
    }
    return std::max(sums_.count - trace / variance_, least_freedom * sums_.count);
  }
  /// A component's squares, and how much of each the data decide.
  template <class At, class Constant>
  void measure(Component& component, std::size_t count, const At& combination_at,
               const Constant& constant, const BandMatrix& covariance) const {
    component.square.resize(count);
    component.known.resize(count);
    for (std::size_t j = 0; j < count; ++j) {
      const auto sum = combination_at(j);
      const double value = sum.value(unknowns_) + constant(j);
      const double variance = component.intensity[j] * component.unit;
      component.square[j] = value * value / component.unit;
      component.known[j] = std::clamp(1.0 - sum.variance(covariance) / variance, 0.0, 1.0);
    }
  }
  /// New intensities, halfway (in logarithms) to the ratio of two averages over a neighbourhood: of
  /// squares and of `known`. Returns the largest change of their logarithms.
  [[nodiscard]] double average(Component& component, std::span<const double> half_lengths) const {
    const std::size_t count = component.intensity.size();
    std::vector<double> next(count);
    double largest = 0.0;
    for (std::size_t j = 0; j < count; ++j) {
      const auto reach = static_cast<std::size_t>(half_lengths[j] / basis_.step());
      double square = prior_count * component.usual;
      double known = prior_count;
      for (std::size_t k = j >= reach ? j - reach : 0; k <= std::min(count - 1, j + reach); ++k) {
        const double weight =
            1.0 - static_cast<double>(k > j ? k - j : j - k) / static_cast<double>(reach + 1);
        square += weight * component.square[k];
        known += weight * component.known[k];
      }
      next[j] = std::sqrt(component.intensity[j] * square / known);
      largest = std::max(largest, std::abs(std::log(next[j] / component.intensity[j])));
    }
    component.intensity = std::move(next);
    return largest;
  }
  /// Of the waves that prior and noise halve between them.
  [[nodiscard]] double wavelength_at(std::size_t j) const {
    const double density = variance_ * spacing_;
    const double number = std::max(std::pow(drift_.intensity[j] / density, 1.0 / 6.0),
                                   std::pow(waviness_.intensity[j] / density, 1.0 / 4.0));
    return 2.0 * std::numbers::pi / number;
  }

  const SplineBasis& basis_;
  const Sums& sums_;
  std::span<const double> curvature_;
  double spacing_;
  double variance_ = 0.0;
  Component drift_;
  Component waviness_;
  std::vector<double> unknowns_;
  std::shared_ptr<const BandCholesky> factor_;
};

} // namespace

double SplineBasis::value(std::span<const double> coefficients, double arc) const {
  const Row row = row_at(*this, arc);
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += row.value[k] * coefficients[row.first + k];
  }
  return sum;
}

double correlation_of(std::span<const double> residuals, std::size_t lag) {
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = lag; i < residuals.size(); ++i) {
    product += residuals[i - lag] * residuals[i];
    square += 0.5 * (residuals[i - lag] * residuals[i - lag] + residuals[i] * residuals[i]);
  }
  return square > 0.0 ? product / square : 0.0;
}

std::vector<double> weights_of(std::span<const double> residuals) {
  std::vector<double> sizes;
  for (const double residual : residuals) {
    sizes.push_back(std::abs(residual));
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const double limit = std::max(influence_limit * *middle, std::sqrt(least_variance));
  std::vector<double> weights;
  for (const double residual : residuals) {
    weights.push_back(std::sqrt(limit / std::max(limit, std::abs(residual))));
  }
  return weights;
}

std::vector<double> NoiseFit::residuals(const OffsetData& data) const {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < data.arc.size(); ++i) {
    residuals.push_back(data.offset[i] - basis.value(coefficients, data.arc[i]));
  }
  return residuals;
}

std::vector<double> NoiseFit::draw(const std::function<double()>& normal) const {
  std::vector<double> numbers(2 * coefficients.size());
  for (double& number : numbers) {
    number = normal();
  }
  numbers = precision->solve_upper(std::move(numbers));
  std::vector<double> drawn;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    drawn.push_back(coefficients[k] + numbers[coefficient_index(k)]);
  }
  return drawn;
}

namespace {

/// Where the fixed point begins.
struct Begin {
  double variance = 0.0;
  std::vector<double> drift;
  std::vector<double> waviness;
};

/// All scatter is noise.
Begin begin_smooth(const SplineBasis& basis, const OffsetData& data) {
  double square = 0.0;
  for (const double offset : data.offset) {
    square += offset * offset;
  }
  const double variance =
      std::max(square / static_cast<double>(data.offset.size()), least_variance);
  return {variance, std::vector<double>(basis.intervals, first_intensity),
          std::vector<double>(basis.intervals + 1, first_intensity)};
}

/// Takes little of the differences from point to point as noise.
Begin begin_rough(const SplineBasis& basis, const OffsetData& data) {
  double square = 0.0;
  for (std::size_t i = 1; i < data.offset.size(); ++i) {
    square += std::pow(data.offset[i] - data.offset[i - 1], 2);
  }
  const double variance =
      std::max(rough_share * square / static_cast<double>(data.offset.size()), least_variance);
  return {variance, std::vector<double>(basis.intervals, rough_drift),
          std::vector<double>(basis.intervals + 1, rough_waviness)};
}

NoiseFit fit_from(const SplineBasis& basis, const OffsetData& data,
                  std::span<const double> curvature, double distance, const Begin& begin,
                  int rounds) {
  const Sums sums = sums_of(basis, data);
  const double spacing = basis.length / static_cast<double>(data.arc.size());
  Fit fit(basis, sums, curvature, std::max(distance, spacing));
  fit.start(begin.variance, begin.drift, begin.waviness);
  fit.run(rounds);
  NoiseFit result = fit.result();
  result.distance = distance;
  result.deviance = fit.deviance();
  return result;
}

Begin begin_with(const NoiseFit& fit) {
  return {fit.deviation * fit.deviation, fit.drift, fit.waviness};
}

/// Every point that is this far from the one before.
OffsetData thinned(const OffsetData& data, double distance) {
  OffsetData few;
  for (std::size_t i = 0; i < data.arc.size(); ++i) {
    if (few.arc.empty() || data.arc[i] - few.arc.back() > distance * (1.0 - place_rounding)) {
      few.arc.push_back(data.arc[i]);
      few.offset.push_back(data.offset[i]);
      few.weight.push_back(data.weight[i]);
    }
  }
  return few;
}

/// All points, of which those within a distance count as one.
OffsetData shared_weights(OffsetData data, double distance) {
  const std::size_t last = data.arc.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double around = 0.5 * (data.arc[std::min(i + 1, last)] - data.arc[i > 0 ? i - 1 : 0]);
    data.weight[i] *= std::sqrt(std::clamp(around / distance, least_point_share, 1.0));
  }
  return data;
}

} // namespace

NoiseFit fit_noise(const SplineBasis& basis, OffsetData& data, std::span<const double> curvature) {
  const Begin smooth = begin_smooth(basis, data);
  NoiseFit best = fit_from(basis, data, curvature, 0.0, smooth, first_rounds);
  const NoiseFit other =
      fit_from(basis, data, curvature, 0.0, begin_rough(basis, data), first_rounds);
  if (other.deviance < best.deviance) {
    best = other;
  }
  for (int i = 1; i < weightings; ++i) {
    data.weight = weights_of(best.residuals(data));
    best = fit_from(basis, data, curvature, 0.0, begin_with(best), later_rounds);
  }
  return best;
}

NoiseFit fit_apart(const SplineBasis& basis, const OffsetData& data,
                   std::span<const double> curvature, double distance) {
  const OffsetData few = thinned(data, distance);
  NoiseFit fit = fit_from(basis, few, curvature, distance, begin_smooth(basis, few), first_rounds);
  const std::vector<double> residuals = fit.residuals(few);
  fit.correlation = correlation_of(residuals);
  for (std::size_t lag = 2; lag <= largest_lag; ++lag) {
    fit.repetition = std::max(fit.repetition, correlation_of(residuals, lag));
  }
  return fit;
}

NoiseFit fit_again(const SplineBasis& basis, const OffsetData& data,
                   std::span<const double> curvature, const NoiseFit& before) {
  Begin begin = begin_with(before);
  // The number of intervals may be another.
  begin.drift.resize(basis.intervals, before.drift.back());
  begin.waviness.resize(basis.intervals + 1, before.waviness.back());
  return before.distance > 0.0 ? fit_from(basis, shared_weights(data, before.distance), curvature,
                                          before.distance, begin, 0)
                               : fit_from(basis, data, curvature, 0.0, begin, later_rounds);
}

} // namespace wrc
