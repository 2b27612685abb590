/// The part of a curve that is a graph over its lateral coordinate.
///
/// A wheel pressed down on a rail sees of the rail only what is visible from above, and a wheel's
/// radius is a function of its lateral coordinate only where the profile does not overhang. This
/// class holds that part of a curve, grown from a seed place to both sides until the curve turns
/// steeper than 89.4 degrees, and finds the curve over a given lateral coordinate by Newton's
/// method on the curve's own polynomials.
/// Units and frame are those of the curve. Thread rule: immutable, safe to share.
#pragma once

#include <cstddef>
#include <vector>

#include "profile/curve.hpp"

namespace wrc {

class CurveGraph {
public:
  /// Takes a copy of the curve. Throws Error(invalid_argument) if the curve is vertical at the
  /// seed.
  CurveGraph(Curve curve, double seed_arc);

  [[nodiscard]] const Curve& curve() const { return curve_; }
  [[nodiscard]] double lateral_begin() const { return laterals_.front(); }
  [[nodiscard]] double lateral_end() const { return laterals_.back(); }
  [[nodiscard]] double arc_begin() const { return curve_.starts()[first_piece_]; }
  [[nodiscard]] double arc_end() const {
    return curve_.starts()[first_piece_ + laterals_.size() - 1];
  }
  [[nodiscard]] bool covers(double lateral) const {
    return lateral >= lateral_begin() && lateral <= lateral_end();
  }
  /// The curve over a lateral coordinate, which is clamped to the graph's range.
  [[nodiscard]] CurvePoint at_lateral(double lateral) const;
  /// The same, also telling the arc length.
  [[nodiscard]] CurvePoint at_lateral(double lateral, double& arc) const;

private:
  Curve curve_;
  std::size_t first_piece_ = 0;
  std::vector<double> laterals_; ///< at the nodes of the graph's pieces, ascending
};

/// Arc length of the highest point of a curve (of its first one, if several are equally high).
double arc_of_highest_point(const Curve& curve);

} // namespace wrc
