#include "geometry/curve_graph.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/constants.hpp"
#include "profile/crown.hpp"

namespace wrc {
namespace {

bool is_graph_piece(const Curve& curve, std::size_t piece) {
  const double length = curve.starts()[piece + 1] - curve.starts()[piece];
  return curve.at(piece, 0.0).tangent_lateral >= min_tangent_lateral &&
         curve.at(piece, 0.5 * length).tangent_lateral >= min_tangent_lateral &&
         curve.at(piece, length).tangent_lateral >= min_tangent_lateral;
}

} // namespace

CurveGraph::Pieces CurveGraph::grow(const Curve& curve, double seed_arc) {
  const std::size_t seed = curve.piece_at(seed_arc);
  if (!is_graph_piece(curve, seed)) {
    throw_invalid_argument("profile", "lateral coordinate does not increase at its reference point",
                           "a profile that is not vertical there");
  }
  Pieces pieces{seed, seed};
  while (pieces.first > 0 && is_graph_piece(curve, pieces.first - 1)) {
    --pieces.first;
  }
  while (pieces.last + 1 < curve.piece_count() && is_graph_piece(curve, pieces.last + 1)) {
    ++pieces.last;
  }
  return pieces;
}

CurveGraph::CurveGraph(Curve curve, double seed_arc)
    : curve_(std::move(curve)), pieces_(grow(curve_, seed_arc)),
      heights_(curve_, pieces_.first, pieces_.last) {
  laterals_.reserve(pieces_.last - pieces_.first + 2);
  for (std::size_t piece = pieces_.first; piece <= pieces_.last; ++piece) {
    laterals_.push_back(curve_.at(piece, 0.0).lateral);
  }
  const double last_length = curve_.starts()[pieces_.last + 1] - curve_.starts()[pieces_.last];
  laterals_.push_back(curve_.at(pieces_.last, last_length).lateral);
}

CurveGraph CurveGraph::shifted(double lateral, double height) const {
  CurveGraph result = *this;
  result.curve_ = curve_.moved(0.0, lateral, height);
  for (double& place : result.laterals_) {
    place += lateral;
  }
  result.heights_ = heights_.shifted(lateral, height);
  return result;
}

CurvePoint CurveGraph::at_lateral(double lateral) const {
  double arc = 0.0;
  return at_lateral(lateral, arc);
}

CurvePoint CurveGraph::at_lateral(double lateral, double& arc) const {
  lateral = std::clamp(lateral, lateral_begin(), lateral_end());
  const auto above = std::upper_bound(laterals_.begin() + 1, laterals_.end() - 1, lateral);
  const auto index = static_cast<std::size_t>(above - laterals_.begin()) - 1;
  const std::size_t piece = pieces_.first + index;
  const double start = curve_.starts()[piece];
  const double length = curve_.starts()[piece + 1] - start;
  const double width = laterals_[index + 1] - laterals_[index];
  double distance = std::clamp(length * (lateral - laterals_[index]) / width, 0.0, length);
  CurvePoint point = curve_.at(piece, distance);
  for (int iteration = 0; iteration < graph_newton_limit; ++iteration) {
    const double next =
        std::clamp(distance + (lateral - point.lateral) / point.tangent_lateral, 0.0, length);
    const double change = std::abs(next - distance);
    distance = next;
    point = curve_.at(piece, distance);
    if (change <= 1e-9 * length) {
      break; // Newton converges quadratically: what is left is far below rounding
    }
  }
  arc = start + distance;
  return point;
}

double CurveGraph::sharpest_ridge(double lateral_first, double lateral_last) const {
  double sharpest = 0.0;
  const auto nodes = laterals_.begin() + 1;
  const auto first = std::lower_bound(nodes, laterals_.end() - 1, lateral_first);
  for (auto node = first; node != laterals_.end() - 1 && *node <= lateral_last; ++node) {
    const std::size_t piece = pieces_.first + static_cast<std::size_t>(node - laterals_.begin());
    const CurvePoint before =
        curve_.at(piece - 1, curve_.starts()[piece] - curve_.starts()[piece - 1]);
    const CurvePoint after = curve_.at(piece, 0.0);
    sharpest = std::max(sharpest, before.tangent_height * after.tangent_lateral -
                                      before.tangent_lateral * after.tangent_height);
  }
  return std::asin(std::min(sharpest, 1.0));
}

double arc_of_crown(const Curve& curve) {
  std::vector<double> heights;
  for (std::size_t piece = 0; piece < curve.piece_count(); ++piece) {
    heights.push_back(curve.at(piece, 0.0).height);
  }
  const std::size_t best = crown_among(heights);
  // The top lies where the tangent turns downwards, next to the highest node.
  double low = curve.starts()[best > 0 ? best - 1 : 0];
  double high = curve.starts()[std::min(best + 1, curve.piece_count())];
  if (curve.at(low).tangent_height <= 0.0) {
    return low;
  }
  if (curve.at(high).tangent_height >= 0.0) {
    return high;
  }
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) {
      return middle;
    }
    (curve.at(middle).tangent_height > 0.0 ? low : high) = middle;
  }
}

} // namespace wrc
