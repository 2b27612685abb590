#include "geometry/curve_graph.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace wrc {
namespace {

/// Least d lateral / d arc that still counts as a graph: cos of 89.4 degrees.
constexpr double least_tangent_lateral = 0.01;
constexpr int newton_limit = 30;

bool is_graph_piece(const Curve& curve, std::size_t piece) {
  const double length = curve.starts()[piece + 1] - curve.starts()[piece];
  return curve.at(piece, 0.0).tangent_lateral >= least_tangent_lateral &&
         curve.at(piece, 0.5 * length).tangent_lateral >= least_tangent_lateral &&
         curve.at(piece, length).tangent_lateral >= least_tangent_lateral;
}

} // namespace

CurveGraph::CurveGraph(Curve curve, double seed_arc) : curve_(std::move(curve)) {
  const std::size_t seed = curve_.piece_at(seed_arc);
  if (!is_graph_piece(curve_, seed)) {
    throw_invalid_argument("profile", "lateral coordinate does not grow at its reference place",
                           "a profile that is not vertical there");
  }
  first_piece_ = seed;
  std::size_t last_piece = seed;
  while (first_piece_ > 0 && is_graph_piece(curve_, first_piece_ - 1)) {
    --first_piece_;
  }
  while (last_piece + 1 < curve_.piece_count() && is_graph_piece(curve_, last_piece + 1)) {
    ++last_piece;
  }
  laterals_.reserve(last_piece - first_piece_ + 2);
  for (std::size_t piece = first_piece_; piece <= last_piece; ++piece) {
    laterals_.push_back(curve_.at(piece, 0.0).lateral);
  }
  const double last_length = curve_.starts()[last_piece + 1] - curve_.starts()[last_piece];
  laterals_.push_back(curve_.at(last_piece, last_length).lateral);
}

CurvePoint CurveGraph::at_lateral(double lateral) const {
  double arc = 0.0;
  return at_lateral(lateral, arc);
}

CurvePoint CurveGraph::at_lateral(double lateral, double& arc) const {
  lateral = std::clamp(lateral, lateral_begin(), lateral_end());
  const auto above = std::upper_bound(laterals_.begin() + 1, laterals_.end() - 1, lateral);
  const auto index = static_cast<std::size_t>(above - laterals_.begin()) - 1;
  const std::size_t piece = first_piece_ + index;
  const double start = curve_.starts()[piece];
  const double length = curve_.starts()[piece + 1] - start;
  const double width = laterals_[index + 1] - laterals_[index];
  double distance = std::clamp(length * (lateral - laterals_[index]) / width, 0.0, length);
  CurvePoint point = curve_.at(piece, distance);
  for (int iteration = 0; iteration < newton_limit; ++iteration) {
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

double arc_of_highest_point(const Curve& curve) {
  std::size_t best = 0;
  for (std::size_t piece = 1; piece < curve.piece_count(); ++piece) {
    if (curve.at(piece, 0.0).height > curve.at(best, 0.0).height) {
      best = piece;
    }
  }
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
