/// Pieces and places of a sheet: where it is the same along, where its sections are graphs.
#include <algorithm>
#include <cmath>

#include "geometry/surface_sheet.hpp"

namespace wrc {

std::size_t SurfaceSheet::piece_at(double across) const {
  const auto found = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, across);
  return static_cast<std::size_t>(found - starts_.begin() - 1);
}

double SurfaceSheet::place_at(double share) const {
  const std::span<const double> knots = spline_.knots();
  const double over = share * static_cast<double>(spline_.last_place_knot());
  const std::size_t knot = std::min(static_cast<std::size_t>(over), knots.size() - 2);
  return knots[knot] + (over - static_cast<double>(knot)) * (knots[knot + 1] - knots[knot]);
}

std::pair<std::size_t, std::size_t> SurfaceSheet::ascending_run(std::size_t interval) const {
  const std::size_t stride = starts_.size();
  const double step = spline_.knots()[interval + 1] - spline_.knots()[interval];
  const auto growth = [&](const std::vector<double>& of, std::size_t knot, std::size_t piece) {
    return of[knot * stride + piece + 1] - of[knot * stride + piece];
  };
  std::pair<std::size_t, std::size_t> longest{0, 0};
  std::size_t first = 0;
  for (std::size_t piece = 0; piece + 1 < stride; ++piece) {
    const double least = std::min(growth(begin_lateral_, interval, piece),
                                  growth(begin_lateral_, interval + 1, piece));
    const double bend = std::abs(growth(begin_second_, interval, piece)) +
                        std::abs(growth(begin_second_, interval + 1, piece));
    if (!(least >
          step * step / 12.0 * bend)) { // a cubic's part of second derivatives, and rounding
      first = piece + 1;
    } else if (piece + 1 - first > longest.second - longest.first) {
      longest = {first, piece + 1};
    }
  }
  return longest;
}

double SurfaceSheet::change_from(std::size_t knot, std::size_t interval) const {
  const double step = spline_.knots()[interval + 1] - spline_.knots()[interval];
  const double of_second = step * step / 16.0; // the cubic's part of second derivatives
  double most = 0.0;
  for (std::size_t piece = 0; piece + 1 < starts_.size(); ++piece) {
    const double length = starts_[piece + 1] - starts_[piece];
    const Node& from = node(piece, knot);
    const Node& begin = node(piece, interval);
    const Node& end = node(piece, interval + 1);
    double change = 0.0;
    double power = 1.0;
    for (std::size_t i = 0; i < Quintic{}.size(); ++i) {
      change +=
          power *
          (std::abs(end.lateral[i] - from.lateral[i]) + std::abs(end.height[i] - from.height[i]) +
           of_second * (std::abs(begin.lateral_second[i]) + std::abs(end.lateral_second[i]) +
                        std::abs(begin.height_second[i]) + std::abs(end.height_second[i])));
      power *= length;
    }
    most = std::max(most, change);
  }
  return most;
}

std::vector<Stretch> SurfaceSheet::constant_stretches(double tolerance) const {
  const std::span<const double> knots = spline_.knots();
  std::vector<Stretch> stretches;
  if (!is_whole_) {
    return stretches;
  }
  std::size_t first = 0;
  for (std::size_t interval = 0; interval + 1 < knots.size(); ++interval) {
    if (change_from(first, interval) <= tolerance) {
      if (first == interval) {
        stretches.push_back({knots[first], knots[first]});
      }
      stretches.back().end = knots[interval + 1];
    } else {
      first = interval + 1;
    }
  }
  if (is_periodic() && stretches.size() > 1 && stretches.front().begin == knots.front() &&
      stretches.back().end == knots.back()) { // one around the place where the list begins
    stretches.back().end += stretches.front().end - knots.front();
    stretches.erase(stretches.begin());
  }
  return stretches;
}

double SurfaceSheet::rise_over(double along) const {
  const AlongPlace place = spline_.locate(along);
  double most = 0.0;
  for (std::size_t piece = 0; piece + 1 < starts_.size(); ++piece) {
    const SheetPoint here = at(piece, 0.0, place);
    const double speed = std::hypot(here.across[0], here.across[1]);
    for (std::size_t knot = 0; knot < spline_.knots().size(); ++knot) {
      const Node& other = node(piece, knot);
      most = std::max(most, ((other.height[0] - here.at[1]) * here.across[0] -
                             (other.lateral[0] - here.at[0]) * here.across[1]) /
                                speed);
    }
  }
  return most;
}

double SurfaceSheet::steepest_along() const {
  constexpr int places = 2;
  constexpr std::size_t pieces = 4; // of 0.5 mm
  const std::span<const double> knots = spline_.knots();
  double steepest = 0.0;
  for (std::size_t interval = 0; interval + 1 < knots.size(); ++interval) {
    const auto [first, last] = ascending_[interval];
    for (int place = 0; place < places; ++place) {
      const double along =
          std::lerp(knots[interval], knots[interval + 1], static_cast<double>(place) / places);
      for (std::size_t piece = first; piece < last; piece += pieces) {
        steepest = std::max(steepest, std::abs(graph_of(at(starts_[piece], along)).by_along));
      }
    }
  }
  return steepest;
}

} // namespace wrc
