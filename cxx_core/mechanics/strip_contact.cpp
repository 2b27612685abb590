#include "mechanics/strip_contact.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>

#include "half_space/fft.hpp"
#include "half_space/influence_coefficients.hpp"
#include "mechanics/constants.hpp"

namespace wrc {
namespace {

/// A product with a symmetric matrix whose elements depend on the difference of indices only.
class Convolution {
public:
  /// `coefficient(i)`: i rows away.
  template <typename Coefficient>
  Convolution(std::size_t count, const Coefficient& coefficient)
      : count_(count), length_(fast_line_length(2 * count)),
        transform_(line_fft<double>(length_, PlannerRigor::estimate)), line_(length_),
        spectral_line_(length_), spectrum_(length_) {
    std::fill_n(line_.data(), length_, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      line_.data()[i] = coefficient(i);
      line_.data()[(length_ - i) % length_] = line_.data()[i];
    }
    transform_.forward(line_.data(), spectral_line_.data());
    for (std::size_t i = 0; i < length_; ++i) {
      spectrum_[i] = spectral_line_.data()[i].real() / static_cast<double>(length_);
    }
  }
  void apply(const std::vector<double>& values, std::vector<double>& sums) {
    std::fill(std::copy(values.begin(), values.end(), line_.data()), line_.data() + length_, 0.0);
    transform_.forward(line_.data(), spectral_line_.data());
    std::transform(spectrum_.begin(), spectrum_.end(), spectral_line_.data(), spectral_line_.data(),
                   std::multiplies<>());
    transform_.backward(spectral_line_.data(), line_.data());
    std::transform(line_.data(), line_.data() + count_, sums.begin(),
                   [](const std::complex<double>& sum) { return sum.real(); });
  }

private:
  std::size_t count_;
  std::size_t length_;
  const LineFft<double>& transform_;
  AlignedArray<std::complex<double>> line_;
  AlignedArray<std::complex<double>> spectral_line_;
  std::vector<double> spectrum_;
};

Convolution influence(double step, double length, double combined_modulus, std::size_t count) {
  return {count, [=](std::size_t i) {
            return influence_coefficient(0.0, static_cast<double>(i) * step, length, step,
                                         combined_modulus);
          }};
}

/// The operator with the spectrum |k|: the inverse of plane strain, except for a factor, and
/// thereby a preconditioner (its coefficients are the integrals of |k| cos(i k) from -pi to pi).
Convolution inverse_of_plane_strain(std::size_t count) {
  return {count, [](std::size_t i) {
            if (i == 0) {
              return 0.25 * std::numbers::pi * std::numbers::pi;
            }
            const auto away = static_cast<double>(i);
            return i % 2 == 0 ? 0.0 : -1.0 / (away * away);
          }};
}

/// Conjugate gradients (Polak & Ribiere) on the strips under pressure or in overlap.
class StripSolver {
public:
  StripSolver(const StripProblem& problem, std::vector<double> pressure)
      : problem_(problem), count_(pressure.size()),
        influence_(influence(problem.step, problem.length, problem.combined_modulus, count_)),
        preconditioner_(inverse_of_plane_strain(count_)), pressure_(std::move(pressure)),
        gap_(count_), masked_(count_), last_masked_(count_), gradient_(count_), direction_(count_),
        response_(count_) {}

  std::vector<double> solve() {
    find_gap();
    for (int step = 0; step < strip_step_limit; ++step) {
      turn_direction();
      const double change = go_down();
      const double largest = *std::max_element(pressure_.begin(), pressure_.end());
      if (change <= problem_.tolerance * largest) {
        break;
      }
    }
    return std::move(pressure_);
  }

private:
  void find_gap() {
    influence_.apply(pressure_, gap_);
    for (std::size_t i = 0; i < count_; ++i) {
      gap_[i] += problem_.undeformed_distance[i] - problem_.approach;
    }
  }
  [[nodiscard]] bool is_active(std::size_t i) const { return pressure_[i] > 0.0 || gap_[i] < 0.0; }

  void turn_direction() {
    std::swap(masked_, last_masked_);
    for (std::size_t i = 0; i < count_; ++i) {
      masked_[i] = is_active(i) ? gap_[i] : 0.0;
    }
    preconditioner_.apply(masked_, gradient_);
    double product = 0.0;
    double carried = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      gradient_[i] = is_active(i) ? gradient_[i] : 0.0;
      product += gradient_[i] * masked_[i];
      carried += gradient_[i] * last_masked_[i];
    }
    const double kept =
        last_product_ > 0.0 ? std::max(0.0, (product - carried) / last_product_) : 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      direction_[i] = is_active(i) ? gradient_[i] + kept * direction_[i] : 0.0;
    }
    last_product_ = product;
  }

  /// The largest change of a pressure.
  double go_down() {
    influence_.apply(direction_, response_);
    double slope = 0.0;
    double curvature = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      slope += gap_[i] * direction_[i];
      curvature += response_[i] * direction_[i];
    }
    const double length = curvature > 0.0 ? slope / curvature : 0.0;
    double change = 0.0;
    bool cut = false;
    for (std::size_t i = 0; i < count_; ++i) {
      const double before = pressure_[i];
      const double after = before - length * direction_[i];
      cut = cut || after < 0.0;
      pressure_[i] = std::max(0.0, after);
      change = std::max(change, std::abs(pressure_[i] - before));
      gap_[i] -= length * response_[i];
    }
    if (cut) {
      find_gap();
    }
    return change;
  }

  const StripProblem& problem_;
  std::size_t count_;
  Convolution influence_;
  Convolution preconditioner_;
  std::vector<double> pressure_;
  std::vector<double> gap_;
  std::vector<double> masked_;      ///< gaps of active strips
  std::vector<double> last_masked_; ///< one step before
  std::vector<double> gradient_;    ///< preconditioned
  std::vector<double> direction_;
  std::vector<double> response_;
  double last_product_ = 0.0;
};

} // namespace

std::vector<double> displacements_of_strips(double step, double length, double combined_modulus,
                                            std::span<const double> pressure) {
  std::vector<double> displacement(pressure.size());
  influence(step, length, combined_modulus, pressure.size())
      .apply({pressure.begin(), pressure.end()}, displacement);
  return displacement;
}

std::vector<double> solve_strips(const StripProblem& problem, std::vector<double> pressure) {
  return StripSolver(problem, std::move(pressure)).solve();
}

} // namespace wrc
