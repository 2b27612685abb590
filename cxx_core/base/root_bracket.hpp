/// A root of a function of one variable, between two arguments where its signs differ.
///
/// Regula falsi with the Illinois rule (Dowell & Jarratt, BIT 11, 1971: the value at an end that
/// stays twice is halved), which is of order 1.44 at a smooth root. Every eighth step is a
/// bisection, so that kinks and jumps cost no more than eight times the steps of bisection. Both
/// ends enclose the change of sign at all times.
/// Thread rule: a plain value.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.hpp"

namespace wrc {

class RootBracket {
public:
  struct Point {
    double place = 0.0;
    double value = 0.0;
  };

  enum class End { none, one, other };

  /// The two values differ in sign. `newest`: the end found last, if the search for a bracket was
  /// one for the root as well.
  RootBracket(Point one, Point other, End newest = End::none)
      : one_(one), other_(other), weighted_one_(one.value), weighted_other_(other.value),
        last_(newest) {}

  /// The end on the first point's side of the root, and the one on the second's.
  [[nodiscard]] double one() const { return one_.place; }
  [[nodiscard]] double other() const { return other_.place; }
  [[nodiscard]] double middle() const { return 0.5 * (one_.place + other_.place); }
  [[nodiscard]] double width() const { return std::abs(other_.place - one_.place); }

  /// Narrows the bracket to `tolerance`, unless that takes more than max_bracket_steps. `function`
  /// gives its value, or none to stop; at a value of zero both ends meet.
  template <class Function> void narrow(double tolerance, const Function& function) {
    for (int step = 1; step <= max_bracket_steps && width() > tolerance; ++step) {
      const double place = step % bisection_period == 0 ? middle() : drawn();
      const std::optional<double> value = function(place);
      if (!value) {
        return;
      }
      add({place, *value});
    }
  }

private:
  /// Where the secant through the weighted ends is zero.
  [[nodiscard]] double drawn() const {
    const double place = (one_.place * weighted_other_ - other_.place * weighted_one_) /
                         (weighted_other_ - weighted_one_);
    const auto [low, high] = std::minmax(one_.place, other_.place);
    return place > low && place < high ? place : middle();
  }

  void add(Point found) {
    if (found.value == 0.0) {
      one_ = other_ = found;
    } else if ((found.value < 0.0) == (one_.value < 0.0)) {
      one_ = found;
      weighted_one_ = found.value;
      weighted_other_ = last_ == End::one ? 0.5 * weighted_other_ : other_.value;
      last_ = End::one;
    } else {
      other_ = found;
      weighted_other_ = found.value;
      weighted_one_ = last_ == End::other ? 0.5 * weighted_one_ : one_.value;
      last_ = End::other;
    }
  }

  Point one_;
  Point other_;
  double weighted_one_;
  double weighted_other_;
  End last_; ///< that moved
};

} // namespace wrc
