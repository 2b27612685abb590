/// The part of a curve that is a graph over its lateral coordinate.
///
/// A wheel pressed down on a rail sees of the rail only what is visible from above, and a wheel's
/// radius is a function of its lateral coordinate only where the profile does not overhang. This
/// class holds that part of a curve, extended from a seed point to both sides until the curve turns
/// steeper than 89.4 degrees. The curve over a given lateral coordinate is found in two ways: by
/// Newton's method on the curve's own polynomials (at_lateral), and from a table of the height that
/// meets the curve to 1e-12 mm (heights), which is what searches and rays use. Units and frame are
/// those of the curve. Thread rule: immutable, safe to share.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/height_function.hpp"
#include "profile/curve.hpp"

namespace wrc {

class CurveGraph {
public:
  /// Takes a copy of the curve. Throws Error(invalid_argument) if the curve is vertical at the
  /// seed.
  CurveGraph(Curve curve, double seed_arc);

  /// The same curve somewhere else.
  [[nodiscard]] CurveGraph shifted(double lateral, double height) const;

  [[nodiscard]] const Curve& curve() const { return curve_; }
  [[nodiscard]] const HeightFunction& heights() const { return heights_; }
  /// The pieces of the curve that belong to the graph.
  [[nodiscard]] std::size_t first_piece() const { return pieces_.first; }
  [[nodiscard]] std::size_t piece_count() const { return laterals_.size() - 1; }
  [[nodiscard]] double lateral_begin() const { return laterals_.front(); }
  [[nodiscard]] double lateral_end() const { return laterals_.back(); }
  [[nodiscard]] double arc_begin() const { return curve_.starts()[pieces_.first]; }
  [[nodiscard]] double arc_end() const { return curve_.starts()[pieces_.last + 1]; }
  [[nodiscard]] bool covers(double lateral) const {
    return lateral >= lateral_begin() && lateral <= lateral_end();
  }
  /// The curve over a lateral coordinate, which is clamped to the graph's range.
  [[nodiscard]] CurvePoint at_lateral(double lateral) const;
  /// The same, also returning the arc length.
  [[nodiscard]] CurvePoint at_lateral(double lateral, double& arc) const;
  /// The largest angle, rad, by which the curve turns downwards between two pieces that meet over a
  /// stretch: 0 unless there is a ridge.
  [[nodiscard]] double sharpest_ridge(double lateral_first, double lateral_last) const;

private:
  struct Pieces {
    std::size_t first;
    std::size_t last;
  };
  static Pieces grow(const Curve& curve, double seed_arc);

  Curve curve_;
  Pieces pieces_;
  std::vector<double> laterals_; ///< at the nodes of the graph's pieces, ascending
  HeightFunction heights_;
};

/// Arc length of the crown of a curve from the gauge to the field side (profile/crown.hpp), of the
/// first of several places that are equally high.
double arc_of_crown(const Curve& curve);

} // namespace wrc
