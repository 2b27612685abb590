#include "wrc_sweep/conicity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace driver {
namespace {

/// b r0 = 1: y'' = -f(y) with f = dr/2.
class Motion {
public:
  explicit Motion(const RadiusDifference& samples)
      : y_(samples.lateral), force_(samples.difference) {
    for (double& force : force_) {
      force *= 0.5;
    }
    find_rest();
    if (rest_ > 0) {
      potential_.assign(y_.size(), 0.0);
      for (std::size_t i = rest_; i + 1 < y_.size(); ++i) {
        potential_[i + 1] = potential_[i] + step(i);
      }
      for (std::size_t i = rest_; i > 0; --i) {
        potential_[i - 1] = potential_[i] - step(i - 1);
      }
    }
  }

  [[nodiscard]] bool rests() const { return rest_ > 0; }
  [[nodiscard]] double rest() const { return y_[rest_]; }
  [[nodiscard]] double greatest() const { return y_.back(); }

  [[nodiscard]] double potential(double y) const {
    const std::size_t i = segment(y);
    const double part = y - y_[i];
    return potential_[i] + part * (force_[i] + 0.5 * slope(i) * part);
  }

  /// The turning point on the other side of the rest; nothing if the samples end before it or if
  /// the force leads away from the rest on the way.
  [[nodiscard]] std::optional<double> opposite(double turn) const {
    const double level = potential(turn);
    std::size_t i = rest_;
    while (i > 0 && potential_[i - 1] < level) {
      if (force_[i - 1] > 0.0) {
        return std::nullopt;
      }
      --i;
    }
    if (i == 0) {
      return std::nullopt;
    }
    double left = y_[i - 1];
    double right = y_[i];
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = 0.5 * (left + right);
      (potential(middle) > level ? left : right) = middle;
    }
    return right;
  }

  /// Whether the force leads back to the rest everywhere up to a turning point on the right.
  [[nodiscard]] bool leads_back(double turn) const {
    for (std::size_t i = rest_ + 1; i < y_.size() && y_[i] <= turn; ++i) {
      if (force_[i] < 0.0) {
        return false;
      }
    }
    return true;
  }

  /// Way x from one turning point to the other.
  [[nodiscard]] double half_wave(double left, double right) const {
    const double level = potential(right);
    const auto speed = [&](double y) {
      return std::sqrt(2.0 * std::max(level - potential(y), 0.0));
    };
    double sum = 0.0;
    double from = left;
    double speed_from = 0.0; // at rest for an instant
    for (std::size_t i = segment(left); from < right; ++i) {
      const double to = std::min(right, y_[i + 1]);
      const double speed_to = to < right ? speed(to) : 0.0;
      sum += passage(i, from, to, speed_from, speed_to);
      from = to;
      speed_from = speed_to;
    }
    return sum;
  }

private:
  [[nodiscard]] double slope(std::size_t i) const {
    return (force_[i + 1] - force_[i]) / (y_[i + 1] - y_[i]);
  }
  [[nodiscard]] double step(std::size_t i) const {
    return 0.5 * (force_[i] + force_[i + 1]) * (y_[i + 1] - y_[i]);
  }
  [[nodiscard]] std::size_t segment(double y) const {
    const auto above = std::upper_bound(y_.begin() + 1, y_.end() - 1, y);
    return static_cast<std::size_t>(above - y_.begin()) - 1;
  }

  /// The position of rest closest to the centre becomes a sample of its own.
  void find_rest() {
    double closest = std::numeric_limits<double>::infinity();
    std::size_t before = 0;
    for (std::size_t i = 0; i + 1 < y_.size(); ++i) {
      if (force_[i] <= 0.0 && force_[i + 1] > 0.0) {
        const double y = y_[i] - force_[i] * (y_[i + 1] - y_[i]) / (force_[i + 1] - force_[i]);
        if (std::abs(y) < std::abs(closest)) {
          closest = y;
          before = i;
        }
      }
    }
    if (!std::isfinite(closest)) {
      return;
    }
    if (closest == y_[before]) {
      rest_ = before;
      return;
    }
    rest_ = before + 1;
    const auto place = static_cast<std::ptrdiff_t>(rest_);
    y_.insert(y_.begin() + place, closest);
    force_.insert(force_.begin() + place, 0.0);
  }

  /// Way x between two positions of one segment, where y'' = -(f + c (y - y0)): a sine for c > 0, a
  /// hyperbolic sine for c < 0, both measured from the place where the force would be zero.
  [[nodiscard]] double passage(std::size_t i, double from, double to, double speed_from,
                               double speed_to) const {
    const double even = 2.0 * (to - from) / (speed_from + speed_to); // constant force
    const double c = slope(i);
    const double rate = std::sqrt(std::abs(c));
    constexpr double nearly_even = 1e-5; // its square is what is lost
    if (!(rate * even > nearly_even)) {
      return even;
    }
    const double zero = y_[i] - force_[i] / c;
    const double a = rate * (from - zero);
    const double b = rate * (to - zero);
    if (c > 0.0) {
      return (std::atan2(b, speed_to) - std::atan2(a, speed_from)) / rate;
    }
    // v + w z grows as e^(w x), v - w z falls so: the one without cancellation.
    return (a + b > 0.0 ? std::log((speed_to + b) / (speed_from + a))
                        : std::log((speed_from - a) / (speed_to - b))) /
           rate;
  }

  std::vector<double> y_;
  std::vector<double> force_;
  std::vector<double> potential_;
  std::size_t rest_ = 0; ///< sample; 0: there is none
};

} // namespace

double equivalent_conicity(const RadiusDifference& samples, double amplitude) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (samples.lateral.size() < 2 || !(amplitude > 0.0)) {
    return none;
  }
  const Motion motion(samples);
  if (!motion.rests()) {
    return none;
  }
  // The right turning point: the width between both grows with it.
  double least = motion.rest();
  double most = std::min(motion.greatest(), motion.rest() + 2.0 * amplitude);
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = 0.5 * (least + most);
    const auto left = motion.opposite(middle);
    (left && middle - *left < 2.0 * amplitude ? least : most) = middle;
  }
  const auto left = motion.opposite(least);
  constexpr double rounding = 1e-9;
  if (!left || std::abs(least - *left - 2.0 * amplitude) > rounding * amplitude ||
      !motion.leads_back(least)) {
    return none;
  }
  const double wave = 2.0 * motion.half_wave(*left, least);
  return std::pow(2.0 * std::numbers::pi / wave, 2);
}

} // namespace driver
