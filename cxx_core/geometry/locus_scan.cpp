#include "geometry/locus_scan.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {
namespace {

/// Farther out than any rail: where the locus does not exist. (not a tuning constant)
constexpr double nowhere = 1e30;

struct Nodes {
  const double* lateral;
  const double* height;
  const double* slope;
};

void place_nodes(const LocusPose& locus_pose, double taping_line, double radius, const Nodes& nodes,
                 double* __restrict x, double* __restrict y, double* __restrict z,
                 std::size_t count) {
  const LocusPose pose = locus_pose; // a copy that no store can change
  const Rotation& r = pose.rotation;
  for (std::size_t i = 0; i < count; ++i) {
    bool exists = false;
    const LocusAngle angle = pose.angle_at(nodes.slope[i], exists);
    const double rho = radius + nodes.height[i];
    const double forward = rho * angle.sine;
    const double across = taping_line + nodes.lateral[i];
    const double down = rho * angle.cosine;
    const double level = r.cos_roll * across + r.sin_roll * down;
    const double place = pose.lateral + (r.sin_yaw * forward + r.cos_yaw * level);
    x[i] = r.cos_yaw * forward - r.sin_yaw * level;
    y[i] = exists ? place : nowhere;
    z[i] = r.sin_roll * across - r.cos_roll * down;
  }
}

/// Heights above the rail, whose pieces are known; the least of them is returned.
double subtract_rail(const HeightFunction::Piece* __restrict pieces,
                     const std::int32_t* __restrict piece, const double* __restrict y,
                     const double* __restrict z, double* __restrict distance, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const HeightFunction::Piece& under = pieces[piece[i]];
    const double s = y[i] - under.start;
    const Quintic& c = under.coefficients;
    const double height = c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
    distance[i] = z[i] - height;
  }
  double least = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : least)
  for (std::size_t i = 0; i < count; ++i) {
    least = distance[i] < least ? distance[i] : least;
  }
  // A reduction may start from the largest finite number.
  return least < std::numeric_limits<double>::max() ? least
                                                    : std::numeric_limits<double>::infinity();
}

} // namespace

LocusScan::LocusScan(const WheelSurface& wheel, const RailSurface& rail)
    : wheel_(wheel), rail_(rail.graph().heights()), x_(wheel.nodes().lateral.size()), y_(x_.size()),
      z_(x_.size()), distance_(x_.size()), piece_(x_.size()) {}

void LocusScan::choose_nodes(const LocusPose& pose) {
  const auto& laterals = wheel_.nodes().lateral;
  first_ = 0;
  last_ = laterals.size();
  const double scale = pose.rotation.cos_yaw * pose.rotation.cos_roll;
  if (!(scale > 0.0)) {
    return;
  }
  const double reach = wheel_.largest_radius() *
                       (std::abs(pose.rotation.sin_roll) + std::abs(pose.rotation.sin_yaw));
  const double low = (rail_.begin() - reach - pose.lateral) / scale - wheel_.taping_line();
  const double high = (rail_.end() + reach - pose.lateral) / scale - wheel_.taping_line();
  const auto begin = laterals.begin();
  const auto lower = std::lower_bound(begin, laterals.end(), low);
  const auto upper = std::upper_bound(lower, laterals.end(), high);
  // One more to either side, so that the ends of the range are seen to be off the rail.
  first_ = static_cast<std::size_t>(lower - begin) - (lower == begin ? 0 : 1);
  last_ = static_cast<std::size_t>(upper - begin) + (upper == laterals.end() ? 0 : 1);
}

void LocusScan::run(const LocusPose& pose) {
  choose_nodes(pose);
  const ProfileNodes& nodes = wheel_.nodes();
  const std::size_t count = last_ - first_;
  place_nodes(
      pose, wheel_.taping_line(), wheel_.radius(),
      {nodes.lateral.data() + first_, nodes.height.data() + first_, nodes.slope.data() + first_},
      x_.data() + first_, y_.data() + first_, z_.data() + first_, count);
  for (std::size_t node = first_; node < last_; ++node) {
    const double y = y_[node];
    if (rail_.covers(y)) {
      piece_[node] = static_cast<std::int32_t>(rail_.piece_at(y));
    } else {
      piece_[node] = static_cast<std::int32_t>(rail_.piece_count()); // nothing there
    }
  }
  least_ = subtract_rail(rail_.pieces().data(), piece_.data() + first_, y_.data() + first_,
                         z_.data() + first_, distance_.data() + first_, count);
}

double LocusScan::rail_slope(std::size_t node) const {
  return rail_.at(static_cast<std::size_t>(piece_[node]), y_[node]).slope;
}

} // namespace wrc
