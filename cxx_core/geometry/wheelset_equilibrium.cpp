#include "geometry/wheelset_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace wrc {
namespace {

constexpr double largest_roll = 0.2;
/// The search for the roll goes on until the two least distances agree to this, mm, ...
constexpr double distance_tolerance = 1e-12;
/// ... and accepts this where rounding allows no better.
constexpr double acceptable_distance = 1e-9;
constexpr int iteration_limit = 100;

/// Least distance of a side and its derivative with respect to the side's own roll.
struct LeastDistance {
  double value;
  double derivative;
};

LeastDistance least_distance(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose) {
  const ContactCandidate contact =
      search_contacts(wheel, rail, pose, 0.0, false).candidates.front();
  // A point fixed in the wheelset moves by d(y, z) / d roll = (-cos(yaw) z', y'), with (y', z')
  // its place before the yaw is applied.
  const Rotation rotation(pose);
  const Vector3 from_centre{contact.wheel.position.x, contact.wheel.position.y - pose.lateral,
                            contact.wheel.position.z};
  const double y = rotation.cos_yaw * from_centre.y - rotation.sin_yaw * from_centre.x;
  const double derivative_y = -rotation.cos_yaw * from_centre.z;
  return {contact.distance, y - std::tan(contact.rail_angle) * derivative_y};
}

/// Root of min d_left - min d_right. Odd under the mirror, so that mirrored scenes give -roll.
double solve_roll(const WheelSurface& wheel, const RailSurface& rail, double lateral, double yaw) {
  double low = -largest_roll;
  double high = largest_roll;
  double roll = 0.0;
  for (int iteration = 0; iteration < iteration_limit; ++iteration) {
    const Pose pose{lateral, yaw, roll};
    const LeastDistance left = least_distance(wheel, rail, pose);
    const LeastDistance right = least_distance(wheel, rail, mirrored(pose));
    const double difference = left.value - right.value;
    if (std::abs(difference) <= distance_tolerance) {
      return roll;
    }
    (difference < 0.0 ? low : high) = roll;
    const double slope = left.derivative + right.derivative;
    double next = roll - difference / slope;
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
    }
    if (next == roll || !(high - low > 1e-18) || iteration + 1 == iteration_limit) {
      // No double lies closer to the root, or there is no root within the limits.
      if (std::abs(difference) <= acceptable_distance) {
        return roll;
      }
      break;
    }
    roll = next;
  }
  throw Error(ErrorCode::no_contact,
              "no roll within +-" + text_of(largest_roll) +
                  " rad sets both wheels on the rails at pose.lateral = " + text_of(lateral) +
                  " mm, pose.yaw = " + text_of(yaw) + " rad");
}

SideEquilibrium settle(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose,
                       double near_tolerance) {
  SideEquilibrium side;
  side.pose = pose;
  side.scan = search_contacts(wheel, rail, pose, near_tolerance, true);
  side.vertical = -side.scan.candidates.front().distance;
  return side;
}

} // namespace

WheelsetEquilibrium find_equilibrium(const WheelSurface& wheel, const RailSurface& rail,
                                     const EquilibriumRequest& request) {
  WheelsetEquilibrium result;
  result.roll =
      request.roll ? *request.roll : solve_roll(wheel, rail, request.lateral, request.yaw);
  const Pose pose{request.lateral, request.yaw, result.roll};
  if (request.left) {
    result.left = settle(wheel, rail, pose, request.near_tolerance);
  }
  if (request.right) {
    result.right = settle(wheel, rail, mirrored(pose), request.near_tolerance);
  }
  if (result.left && result.right) {
    result.vertical = std::max(result.left->vertical, result.right->vertical);
  } else {
    result.vertical = result.left ? result.left->vertical : result.right->vertical;
  }
  return result;
}

} // namespace wrc
