#include "geometry/height_function.hpp"

#include <cmath>
#include <limits>

#include "geometry/constants.hpp"

namespace wrc {
namespace {

QuinticValues graph_values(const CurvePoint& point) {
  const double inverse = 1.0 / point.tangent_lateral;
  const double bend =
      point.second_height * point.tangent_lateral - point.tangent_height * point.second_lateral;
  return {point.height, point.tangent_height * inverse, bend * inverse * inverse * inverse};
}

} // namespace

HeightFunction::HeightFunction(const Curve& curve, std::size_t first_piece,
                               std::size_t last_piece) {
  pieces_.reserve(2 * (last_piece - first_piece + 1));
  begin_ = curve.at(first_piece, 0.0).lateral;
  for (std::size_t piece = first_piece; piece <= last_piece; ++piece) {
    const double length = curve.starts()[piece + 1] - curve.starts()[piece];
    add(curve, piece, 0.0, length, 0);
    end_ = curve.at(piece, length).lateral;
  }
  for (std::size_t piece = 0; piece + 1 < pieces_.size(); ++piece) {
    pieces_[piece].end = pieces_[piece + 1].start;
  }
  pieces_.back().end = end_;

  const std::size_t intervals = 2 * pieces_.size();
  intervals_per_length_ = static_cast<double>(intervals) / (end_ - begin_);
  first_in_interval_.reserve(intervals);
  std::size_t piece = 0;
  for (std::size_t interval = 0; interval < intervals; ++interval) {
    const double start = begin_ + static_cast<double>(interval) / intervals_per_length_;
    while (piece + 1 < pieces_.size() && pieces_[piece].end <= start) {
      ++piece;
    }
    first_in_interval_.push_back(static_cast<std::uint32_t>(piece));
  }
  constexpr double nothing = -std::numeric_limits<double>::infinity();
  pieces_.push_back({0.0, {nothing, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0});
}

HeightFunction HeightFunction::shifted(double lateral, double height) const {
  HeightFunction result = *this;
  for (Piece& piece : result.pieces_) {
    piece.start += lateral;
    piece.end += lateral;
    piece.coefficients[0] += height;
  }
  result.begin_ += lateral;
  result.end_ += lateral;
  return result;
}

void HeightFunction::add(const Curve& curve, std::size_t curve_piece, double from, double to,
                         int halvings) {
  const CurvePoint begin = curve.at(curve_piece, from);
  const CurvePoint end = curve.at(curve_piece, to);
  const Quintic trial =
      quintic(graph_values(begin), graph_values(end), end.lateral - begin.lateral);
  bool met = true;
  for (const double share : {0.25, 0.5, 0.75}) {
    const CurvePoint point = curve.at(curve_piece, from + share * (to - from));
    const double off = evaluate(trial, point.lateral - begin.lateral).value - point.height;
    met = met && std::abs(off * point.tangent_lateral) <= position_tolerance;
  }
  if (met || halvings == max_height_halvings) {
    pieces_.push_back({begin.lateral, trial, end.lateral});
    return;
  }
  const double middle = 0.5 * (from + to);
  add(curve, curve_piece, from, middle, halvings + 1);
  add(curve, curve_piece, middle, to, halvings + 1);
}

} // namespace wrc
