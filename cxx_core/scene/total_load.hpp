/// The loads on normal pressures under which the contact forces of wheels add up to what is
/// requested.
///
/// The normal problem takes the vertical load P that pressures carry. Creep forces on inclined
/// planes add V(P), and requested is P + V(P) = T. V is nearly proportional to P, so that secants
/// from P = 0 and P = T on find P in 2 to 4 solutions. Where a free pitch rate couples both wheels
/// V depends on both loads: then Broyden's method (Math. Comp. 19, 1965) from the two ratios T/P
/// on, in 3 to 6.
///
/// The totals are met within 1e-6 of themselves and a hundredth of the accuracy. Where V jumps with
/// P, since the number of elements changes there, no load may be that good: then within the
/// accuracy, which such jumps stay below. Units N. Thread rule: one object for each scene that is
/// solved; it depends on that scene alone.
///
/// Not known here: how a wheel is solved at a load.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "keys/scene.hpp"

namespace wrc {

/// The load on the pressures of one wheel, by itself.
class LoadSearch {
public:
  explicit LoadSearch(double total)
      : total_(total), load_(total), last_{0.0, -total}, low_(last_) {}

  /// To solve at.
  [[nodiscard]] double load() const { return load_; }
  [[nodiscard]] double total() const { return total_; }
  /// Takes the total under this load; false if another load is needed. Throws
  /// Error(invalid_argument), which names the key, if no load gives the total.
  bool is_met_by(double total, double accuracy, const char* key);

private:
  struct Point {
    double load;
    double excess; ///< of the total over what is requested
  };
  [[nodiscard]] double next_after(const Point& found) const;

  double total_;
  double load_;
  Point last_;
  Point low_; ///< the total is too small
  std::optional<Point> high_;
  int solutions_ = 0;
};

/// Left and right wheel.
using WheelNumbers = std::array<double, 2>;

/// The loads of both wheels together.
class JointLoadSearch {
public:
  explicit JointLoadSearch(const WheelNumbers& totals) : totals_(totals), loads_(totals) {}

  [[nodiscard]] const WheelNumbers& loads() const { return loads_; }
  /// As LoadSearch.
  bool are_met_by(const WheelNumbers& totals, double accuracy);

private:
  void take_slopes(const WheelNumbers& excess);
  void step(const WheelNumbers& excess);

  WheelNumbers totals_;
  WheelNumbers loads_;
  WheelNumbers last_loads_{};
  WheelNumbers last_excess_{};
  std::array<WheelNumbers, 2> slopes_{}; ///< of the totals by the loads, row by row
  int solutions_ = 0;
};

/// The loads of a scene's wheels, given ones and those to be found.
class WheelLoads {
public:
  /// `left`, `right`: whether there is such a wheel.
  WheelLoads(const Scene& scene, bool left, bool right);

  /// The load on the pressures of a wheel, 0: left, 1: right.
  [[nodiscard]] double load(std::size_t wheel) const;
  /// Whether a wheel has to be solved at its load (again).
  [[nodiscard]] bool is_open(std::size_t wheel) const { return open_[wheel]; }
  [[nodiscard]] bool any_open() const { return open_[0] || open_[1]; }
  /// Whether any load is to be found.
  [[nodiscard]] bool are_sought() const { return joint_ || single_[0] || single_[1]; }
  /// Takes what all contact forces of the wheels carry under these loads.
  void take(const WheelNumbers& totals);

private:
  const Scene& scene_;
  std::array<std::optional<LoadSearch>, 2> single_;
  std::optional<JointLoadSearch> joint_;
  std::array<bool, 2> open_{};
};

} // namespace wrc
