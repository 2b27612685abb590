#include "reports/conicity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "support/numbers.hpp"

namespace driver {
namespace {

/// Rolling radius differences below this count as zero, mm. Origin: rounding leaves 4e-13 mm on
/// cylinders (radii of 500 mm), and the last digit of profile files is 1e-7 mm at best. A cone that
/// this hides up to 1 mm has a conicity of 5e-10.
constexpr double zero_difference = 1e-9;

/// Relative, of potentials and amplitudes. Origin: a thousand times what the integrals lose, so
/// that turning points at the ends of the samples count as within.
constexpr double rounding = 1e-9;

/// As of the spreads of results (docs/profiles.md): deviations that hold the truth in 95 of 100
/// cases by ten curves, and the least number of curves.
constexpr double deviations = 2.228;
constexpr std::size_t least_curves = 7;

/// The samples around the centre, up to the first one without a difference on either side.
RadiusDifference known_around_centre(const RadiusDifference& samples) {
  RadiusDifference known;
  RadiusDifference run;
  const auto distance = [](const RadiusDifference& part) {
    double least = std::numeric_limits<double>::infinity();
    for (const double y : part.lateral) {
      least = std::min(least, std::abs(y));
    }
    return least;
  };
  for (std::size_t i = 0; i <= samples.lateral.size(); ++i) {
    if (i < samples.lateral.size() && !std::isnan(samples.difference[i])) {
      run.lateral.push_back(samples.lateral[i]);
      run.difference.push_back(samples.difference[i]);
      continue;
    }
    if (distance(run) < distance(known)) {
      known = run;
    }
    run = {};
  }
  return known;
}

/// b r0 = 1: y'' = -f(y) with f = dr/2.
class Motion {
public:
  explicit Motion(const RadiusDifference& samples) {
    for (std::size_t i = 0; i < samples.lateral.size(); ++i) {
      const double difference = samples.difference[i];
      add(samples.lateral[i], std::abs(difference) <= zero_difference ? 0.0 : 0.5 * difference);
    }
    find_rest();
    if (rests_) {
      potential_.assign(y_.size(), 0.0);
      for (std::size_t i = rest_; i + 1 < y_.size(); ++i) {
        potential_[i + 1] = potential_[i] + step(i);
      }
      for (std::size_t i = rest_; i > 0; --i) {
        potential_[i - 1] = potential_[i] - step(i - 1);
      }
    }
  }

  [[nodiscard]] bool rests() const { return rests_; }
  [[nodiscard]] double rest() const { return y_[rest_]; }
  [[nodiscard]] double least() const { return y_.front(); }
  [[nodiscard]] double greatest() const { return y_.back(); }
  /// The first and last position of the band around the rest where no force acts.
  [[nodiscard]] double band_begin() const { return y_[band_begin_]; }
  [[nodiscard]] double band_end() const { return y_[band_end_]; }

  [[nodiscard]] double potential(double y) const {
    const std::size_t i = segment(y);
    const double part = y - y_[i];
    return potential_[i] + part * (force_[i] + 0.5 * slope(i) * part);
  }

  /// The greatest potential between the rest and a position to the right of it: what it takes to
  /// get there.
  [[nodiscard]] double barrier(double y) const {
    double greatest = potential(y); // monotonic between samples
    for (std::size_t i = rest_; i < y_.size() && y_[i] < y; ++i) {
      greatest = std::max(greatest, potential_[i]);
    }
    return greatest;
  }

  /// The first position left of the rest with this potential; nothing if the samples end before.
  [[nodiscard]] std::optional<double> opposite(double level) const {
    std::size_t i = rest_;
    while (i > 0 && potential_[i - 1] < level) {
      --i;
    }
    if (i == 0) {
      return potential_[0] >= (1.0 - rounding) * level ? std::optional(y_[0]) : std::nullopt;
    }
    double left = y_[i - 1];
    double right = y_[i];
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = 0.5 * (left + right);
      (potential(middle) > level ? left : right) = middle;
    }
    return right;
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
  /// A sample; where the force has changed its sign, also one without a force in between.
  void add(double y, double force) {
    if (!y_.empty() && force_.back() * force < 0.0) {
      const double share = force_.back() / (force_.back() - force);
      const double between = y_.back() + share * (y - y_.back());
      if (between <= y_.back()) {
        force_.back() = 0.0;
      } else if (between >= y) {
        force = 0.0;
      } else {
        y_.push_back(between);
        force_.push_back(0.0);
      }
    }
    y_.push_back(y);
    force_.push_back(force);
  }

  /// The rest closest to the centre: one sample or more without a force, with forces that lead
  /// there on both sides, or up to the last sample.
  void find_rest() {
    double closest = std::numeric_limits<double>::infinity();
    for (std::size_t begin = 0; begin < y_.size(); ++begin) {
      if (force_[begin] != 0.0 || (begin > 0 && force_[begin - 1] >= 0.0)) {
        continue;
      }
      std::size_t end = begin;
      std::size_t middle = begin;
      for (; end + 1 < y_.size() && force_[end + 1] == 0.0; ++end) {
        middle = std::abs(y_[end + 1]) < std::abs(y_[middle]) ? end + 1 : middle;
      }
      const bool led_back = end + 1 == y_.size() || force_[end + 1] > 0.0;
      if (led_back && std::abs(y_[middle]) < closest) {
        closest = std::abs(y_[middle]);
        rests_ = true;
        rest_ = middle;
        band_begin_ = begin;
        band_end_ = end;
      }
    }
  }

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

  /// Way x between two positions of one segment, where y'' = -(f + c (y - y0)): a sine for c > 0, a
  /// hyperbolic sine for c < 0, both measured from the position where the force would be zero.
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
  bool rests_ = false;
  std::size_t rest_ = 0; ///< sample; also the two below
  std::size_t band_begin_ = 0;
  std::size_t band_end_ = 0;
};

EquivalentConicity none(const std::string& reason) {
  return {std::numeric_limits<double>::quiet_NaN(), reason};
}

} // namespace

EquivalentConicity equivalent_conicity(const RadiusDifference& samples, double amplitude) {
  const RadiusDifference known = known_around_centre(samples);
  if (known.lateral.size() < 2 || !(amplitude > 0.0)) {
    return none("no rolling radius difference is known");
  }
  const Motion motion(known);
  if (!motion.rests()) {
    return none("the wheelset is led back to no position between y = " + general(motion.least()) +
                " and " + general(motion.greatest()) + " mm");
  }
  const double width = 2.0 * amplitude;
  if (width <= motion.band_end() - motion.band_begin()) {
    return {0.0, ""};
  }
  const auto ends = [](double y) {
    return none("the rolling radius difference is not known beyond y = " + general(y) + " mm");
  };
  // The right turning point: the width between both grows with it.
  double least = motion.band_end();
  double most = std::min(motion.greatest(), motion.band_begin() + width);
  const auto is_too_narrow = [&](double right, double share) {
    const auto left = motion.opposite(motion.barrier(right));
    return left && right - *left < share * width;
  };
  if (most == motion.greatest() && (most == least || is_too_narrow(most, 1.0 - rounding))) {
    return ends(most);
  }
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = 0.5 * (least + most);
    (is_too_narrow(middle, 1.0) ? least : most) = middle;
  }
  const double barrier = motion.barrier(least);
  const auto left = motion.opposite(barrier);
  if (!left || std::abs(least - *left - width) > rounding * width ||
      motion.potential(least) < (1.0 - rounding) * barrier) {
    return motion.opposite(motion.barrier(most))
               ? none("no motion about y = " + fixed(motion.rest(), 2) +
                      " mm is that wide: the wheelset runs away to another position of rest")
               : ends(motion.least());
  }
  const double wave = 2.0 * motion.half_wave(*left, least);
  return {std::pow(2.0 * std::numbers::pi / wave, 2), ""};
}

double conicity_spread(const RadiusDifference& centre, const std::vector<RadiusDifference>& likely,
                       const std::vector<RadiusDifference>& smoothed, double amplitude) {
  const double conicity = equivalent_conicity(centre, amplitude).value;
  const auto squares_of = [&](const std::vector<RadiusDifference>& lines) {
    std::vector<double> squares;
    for (const RadiusDifference& line : lines) {
      const double square = std::pow(equivalent_conicity(line, amplitude).value - conicity, 2);
      if (!std::isnan(square)) {
        squares.push_back(square);
      }
    }
    return squares;
  };
  const std::vector<double> noise = squares_of(likely);
  const std::vector<double> waves = squares_of(smoothed);
  if (noise.size() < least_curves || (waves.empty() && !smoothed.empty())) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return deviations *
         std::sqrt(std::accumulate(noise.begin(), noise.end(), 0.0) /
                       static_cast<double>(noise.size()) +
                   (waves.empty() ? 0.0 : *std::max_element(waves.begin(), waves.end())));
}

} // namespace driver
