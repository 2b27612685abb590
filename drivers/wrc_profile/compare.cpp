// Normal distance of two profiles in the same frame: for points of the first, the nearest point of
// the second.
#include <algorithm>
#include <cmath>

#include "support/scene.hpp"
#include "wrc_profile/measures.hpp"

namespace driver {
namespace {

constexpr double comparison_spacing = 0.1; // mm
/// Steps of the golden section: the bracket of two spacings shrinks to 1e-9 mm, where the distance,
/// flat at its minimum, is exact to rounding.
constexpr int golden_steps = 40;
constexpr double golden_ratio = 0.61803398874989485;

double distance_between(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(a.lateral - b.lateral, a.height - b.height);
}

struct Foot {
  ProfilePoint point;
  bool at_end = false; ///< the other profile ends before the counterpart of the point
};

Foot find_foot(const Profile& other, const std::vector<ProfilePoint>& coarse,
               const ProfilePoint& point) {
  const auto nearer = [&point](const ProfilePoint& a, const ProfilePoint& b) {
    return distance_between(a, point) < distance_between(b, point);
  };
  const auto nearest = std::min_element(coarse.begin(), coarse.end(), nearer);
  double first = nearest == coarse.begin() ? nearest->arc : (nearest - 1)->arc;
  double last = nearest + 1 == coarse.end() ? nearest->arc : (nearest + 1)->arc;
  for (int k = 0; k < golden_steps; ++k) {
    const double reach = golden_ratio * (last - first);
    if (distance_between(other.at(last - reach), point) <
        distance_between(other.at(first + reach), point)) {
      last = first + reach;
    } else {
      first = last - reach;
    }
  }
  const ProfilePoint foot = other.at(0.5 * (first + last));
  // At an end of the curve the connecting line need not be normal to it: then there is no
  // counterpart, unless the point lies beside the end.
  const double along = (point.lateral - foot.lateral) * std::cos(foot.angle) +
                       (point.height - foot.height) * std::sin(foot.angle);
  const bool beyond = (foot.arc < 0.5 * comparison_spacing && along < -1e-6) ||
                      (foot.arc > coarse.back().arc - 0.5 * comparison_spacing && along > 1e-6);
  return {foot, beyond};
}

} // namespace

Comparison compare(const Profile& profile, const Profile& other) {
  if (profile.is_wheel() != other.is_wheel()) {
    throw Failure("--compare " + other.text("name") + ": is a " + other.kind_name() +
                  "; allowed is a " + profile.kind_name() + " as " + profile.text("name") + " is");
  }
  const auto points = equal_points(profile, comparison_spacing);
  const auto coarse = equal_points(other, comparison_spacing);
  Comparison result;
  double squares = 0.0;
  std::size_t count = 0;
  for (const ProfilePoint& point : points) {
    const Foot foot = find_foot(other, coarse, point);
    if (foot.at_end) {
      continue;
    }
    // Along the normal that points to larger height, or on overhanging parts to the outside.
    const double distance = (foot.point.height - point.height) * std::cos(foot.point.angle) -
                            (foot.point.lateral - point.lateral) * std::sin(foot.point.angle);
    squares += distance * distance;
    ++count;
    if (std::abs(distance) > std::abs(result.largest)) {
      result.largest = distance;
      result.largest_at = point;
    }
  }
  if (count == 0) {
    throw Failure("--compare " + other.text("name") + ": lies nowhere beside " +
                  profile.text("name") + "; allowed are profiles in the same frame");
  }
  result.rms = std::sqrt(squares / static_cast<double>(count));
  result.compared =
      profile.length() * static_cast<double>(count) / static_cast<double>(points.size());
  return result;
}

} // namespace driver
