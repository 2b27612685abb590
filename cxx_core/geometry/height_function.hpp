/// Height over the lateral coordinate of the part of a curve that is a graph.
///
/// A curve is given over its arc length; the height over a lateral coordinate would take Newton's
/// method at each point. This table holds it as polynomials of its own: quintic Hermite
/// interpolation in the lateral coordinate (profile/quintic.hpp) with height, slope and second
/// derivative from the curve, h' = y'/x', h'' = (y'' x' - y' x'') / x'^3. Each piece of the curve
/// is one polynomial, halved along its arc until the curve is met to 1e-12 mm along its normal: on
/// steep flanks that takes several. Kinks and steps between pieces of the curve stay where they
/// are, since no polynomial reaches across. A piece is found in constant time from a table of equal
/// intervals. Units and frame are those of the curve. Thread rule: immutable, safe to share. Not
/// known here: overhanging parts, which belong to the curve only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "profile/curve.hpp"

namespace wrc {

struct HeightPoint {
  double height;
  double slope;  ///< d height / d lateral
  double second; ///< d^2 height / d lateral^2, 1/mm
};

class HeightFunction {
public:
  /// One polynomial; fills a cache line.
  struct Piece {
    double start; ///< lateral coordinate
    Quintic coefficients;
    double end; ///< where the next piece starts
  };

  /// From the pieces first to last of a curve, along which the lateral coordinate grows.
  HeightFunction(const Curve& curve, std::size_t first_piece, std::size_t last_piece);

  /// The same curve somewhere else, its table shifted with it.
  [[nodiscard]] HeightFunction shifted(double lateral, double height) const;

  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] bool covers(double lateral) const { return lateral >= begin_ && lateral <= end_; }

  /// All pieces, ascending. One more follows the last: a height of minus infinity, for points
  /// outside the curve.
  [[nodiscard]] std::span<const Piece> pieces() const { return {pieces_.data(), piece_count()}; }
  [[nodiscard]] std::size_t piece_count() const { return pieces_.size() - 1; }

  /// Index of the piece over a lateral coordinate; the first or last one beyond the ends, the first
  /// one for what is not a number.
  [[nodiscard]] std::size_t piece_at(double lateral) const {
    const double interval = (lateral - begin_) * intervals_per_length_;
    const double last = static_cast<double>(first_in_interval_.size() - 1);
    const auto slot =
        interval > 0.0 ? static_cast<std::size_t>(std::min(interval, last)) : std::size_t{0};
    return walk(first_in_interval_[slot], lateral);
  }
  /// The polynomial of a piece, also beyond its ends.
  [[nodiscard]] HeightPoint at(std::size_t piece, double lateral) const {
    const QuinticValues values =
        evaluate(pieces_[piece].coefficients, lateral - pieces_[piece].start);
    return {values.value, values.first, values.second};
  }
  /// Over a lateral coordinate, which is clamped to the range.
  [[nodiscard]] HeightPoint at(double lateral) const {
    const double inside = std::clamp(lateral, begin_, end_);
    return at(piece_at(inside), inside);
  }

private:
  /// The piece over a lateral coordinate, searched from a piece nearby.
  [[nodiscard]] std::size_t walk(std::size_t piece, double lateral) const {
    while (piece + 1 < piece_count() && lateral >= pieces_[piece].end) {
      ++piece;
    }
    while (piece > 0 && lateral < pieces_[piece].start) {
      --piece;
    }
    return piece;
  }

  void add(const Curve& curve, std::size_t curve_piece, double from, double to, int halvings);

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_in_interval_;
  double begin_ = 0.0;
  double end_ = 0.0;
  double intervals_per_length_ = 0.0;
};

} // namespace wrc
