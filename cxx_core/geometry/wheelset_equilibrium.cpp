#include "geometry/wheelset_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/error.hpp"
#include "geometry/constants.hpp"
#include "geometry/varying_search.hpp"
#include "profile/constants.hpp"

namespace wrc {
namespace {

/// The permitted range of pose.roll, rad (not a tuning constant).
constexpr double max_roll = 0.2;
/// Derivative of a side's least distance with respect to the side's own roll. A point fixed in the
/// wheelset moves by d(y, z) / d roll = (-cos(yaw) z', y'), with (y', z') its position before the
/// yaw is applied.
double roll_derivative(const SideSearch& search, const LocusSpot& spot, const Pose& pose,
                       const Rotation& rotation) {
  const ContactCandidate contact = search.candidate(spot);
  const Vector3 place = contact.wheel.position;
  const double y = rotation.cos_yaw * (place.y - pose.lateral) - rotation.sin_yaw * place.x;
  return y + std::tan(contact.rail_angle) * rotation.cos_yaw * place.z;
}

/// A least distance found by either search.
struct Least {
  double distance = 0.0;
  LocusSpot on_locus;
  VaryingSearch::Spot on_chain;
};

/// For a wheel that does not meet its rail: throws if the rail has a gap below the axle.
void refuse_gap(const RailSurface& rail) {
  if (const double distance = rail.distance_along(); distance > 0.0) {
    throw Error(ErrorCode::no_contact,
                "the wheel is over a gap of the rail at " + short_text_of(rail.along()) +
                    " mm along it: the nearest part is " + short_text_of(distance) +
                    " mm away, which the wheel does not reach");
  }
}

/// The search for a side: along the contact locus, or over places where a body varies.
class EitherSearch {
public:
  explicit EitherSearch(const WheelAndRail& pair) : rail_(pair.rail) {
    if (pair.is_prismatic_along(along_track)) {
      constant_.emplace(pair.wheel, pair.rail);
    } else {
      varying_.emplace(pair.wheel, pair.rail);
    }
  }

  [[nodiscard]] bool varies() const { return varying_.has_value(); }
  [[nodiscard]] bool try_scan(const Pose& pose) {
    return varying_ ? varying_->try_scan(pose) : constant_->try_scan(pose);
  }
  void scan(const Pose& pose) {
    if (!try_scan(pose)) {
      refuse_gap(rail_);
      throw_off_the_rail(pose, rail_.is_prismatic_along(along_track)
                                   ? ""
                                   : "; where slices rise or fall by more than 1:" +
                                         text_of(1.0 / steepest_along) +
                                         " along, contact can be missed (wrc_profile names the "
                                         "slices)");
    }
  }
  [[nodiscard]] Least least() const {
    return varying_ ? of(varying_->least()) : of(constant_->least_spots(0.0).front());
  }
  [[nodiscard]] std::optional<Least> follow(const Pose& pose, const Least& from) {
    if (varying_) {
      const auto spot = varying_->follow(pose, from.on_chain);
      return spot ? std::optional(of(*spot)) : std::nullopt;
    }
    const auto spot = constant_->follow(pose, from.on_locus);
    return spot ? std::optional(of(*spot)) : std::nullopt;
  }
  [[nodiscard]] double by_roll(const Least& least, const Pose& pose) const {
    return varying_ ? varying_->by_roll(least.on_chain)
                    : roll_derivative(*constant_, least.on_locus, pose, Rotation(pose));
  }
  /// Of the pose scanned last.
  [[nodiscard]] std::vector<ContactScan> scans(double near_tolerance) {
    if (varying_) {
      return varying_->scans(near_tolerance);
    }
    std::vector<ContactScan> scans;
    scans.push_back(contacts_of(*constant_, near_tolerance));
    return scans;
  }

private:
  static Least of(const LocusSpot& spot) { return {spot.distance, spot, {}}; }
  static Least of(const VaryingSearch::Spot& spot) { return {spot.point.gap.value, {}, spot}; }

  const RailSurface& rail_;
  std::optional<SideSearch> constant_;
  std::optional<VaryingSearch> varying_;
};

/// Searches the roll at which the least distances of both wheels agree. It does not use
/// base/root_bracket.hpp: each value costs a global search of both wheels (14 us), of which a
/// bracket of +-0.02 rad needs 9.5 on average, 142 us; Newton's method on contacts followed takes
/// 30 us and one or two of them (S1002 on 60E1, lateral -6.5 to 6.5 mm). At the limits of the roll
/// wheels may be off their rails, so there is no value to begin with.
class RollSearch {
public:
  RollSearch(EitherSearch& left, EitherSearch& right, double lateral, double yaw)
      : left_(left), right_(right), lateral_(lateral), yaw_(yaw) {}

  /// Root of min d_left - min d_right; both sides have then been scanned there. Odd under the
  /// mirror, so that mirrored scenes give -roll.
  double solve() {
    double roll = 0.0;
    std::optional<double> standing; // a roll with both wheels over their rails
    bool off_the_rail = false;
    for (int iteration = 1; iteration <= max_roll_searches; ++iteration) {
      const Pose pose{lateral_, yaw_, roll};
      if (!scan_both(pose, standing.has_value())) {
        // Large wheels roll off their rails long before the limit: back to where both stood.
        off_the_rail = true;
        (roll < *standing ? low_ : high_) = roll;
        roll = 0.5 * (roll + *standing);
        continue;
      }
      standing = roll;
      const Pair found{left_.least(), right_.least()};
      if (std::abs(found.difference()) <= tolerance()) {
        return roll;
      }
      (found.difference() < 0.0 ? low_ : high_) = roll;
      const double middle = 0.5 * (low_ + high_);
      const double next =
          iteration % roll_halving_period == 0 ? middle : follow(roll, found, middle);
      if (next == roll || !(high_ - low_ > 1e-18) || iteration == max_roll_searches) {
        // No double lies closer to the root, or there is no root within the limits.
        if (std::abs(found.difference()) <= negligible_length) {
          return roll;
        }
        break;
      }
      roll = next;
    }
    throw Error(ErrorCode::no_contact,
                "no roll within +-" + text_of(max_roll) +
                    " rad brings both wheels onto the rails at pose.lateral = " +
                    text_of(lateral_) + " mm, pose.yaw = " + text_of(yaw_) + " rad" +
                    (off_the_rail ? ": a wheel leaves its rail before the other one touches" : "") +
                    "; both wheels must be able to stand on their rails");
  }

private:
  struct Pair {
    Least left;
    Least right;
    [[nodiscard]] double difference() const { return left.distance - right.distance; }
  };

  /// Whether both wheels lie over their rails; if that must be so, throws where not.
  [[nodiscard]] bool scan_both(const Pose& pose, bool may_be_off) {
    if (may_be_off) {
      return left_.try_scan(pose) && right_.try_scan(mirrored(pose));
    }
    left_.scan(pose);
    right_.scan(mirrored(pose));
    return true;
  }

  [[nodiscard]] double tolerance() const {
    return left_.varies() || right_.varies() ? varying_roll_tolerance : position_tolerance;
  }

  [[nodiscard]] double newton_step(double roll, const Pair& spots) const {
    const Pose pose{lateral_, yaw_, roll};
    const double slope =
        left_.by_roll(spots.left, pose) + right_.by_roll(spots.right, mirrored(pose));
    return roll - spots.difference() / slope;
  }

  /// Newton's method on the contacts followed; what is left of them where they are lost.
  [[nodiscard]] double follow(double roll, Pair spots, double middle) {
    double next = newton_step(roll, spots);
    if (!(next > low_ && next < high_)) {
      return middle;
    }
    for (int step = 0; step < followed_contact_steps; ++step) {
      const Pose pose{lateral_, yaw_, next};
      const auto left = left_.follow(pose, spots.left);
      const auto right = right_.follow(mirrored(pose), spots.right);
      if (!left || !right) {
        return next;
      }
      spots = {*left, *right};
      if (std::abs(spots.difference()) <= followed_contact_tolerance) {
        return next;
      }
      const double after = newton_step(next, spots);
      if (!(after > low_ && after < high_) || after == next) {
        return next;
      }
      next = after;
    }
    return next;
  }

  EitherSearch& left_;
  EitherSearch& right_;
  double lateral_;
  double yaw_;
  double low_ = -max_roll;
  double high_ = max_roll;
};

/// A side whose pose has been scanned.
SideEquilibrium settle(EitherSearch& search, const Pose& pose, double near_tolerance) {
  SideEquilibrium side;
  side.pose = pose;
  std::vector<ContactScan> scans =
      search.scans(std::max(near_tolerance, greatest_depth)); // they may be penetrated
  side.scan = std::move(scans.front());
  side.further.assign(std::make_move_iterator(scans.begin() + 1),
                      std::make_move_iterator(scans.end()));
  const std::vector<ContactCandidate>& candidates = side.scan.candidates;
  const double nearest = candidates.front().distance;
  side.vertical = -nearest;
  side.near_count = static_cast<std::size_t>(
      std::count_if(candidates.begin(), candidates.end(), [&](const ContactCandidate& candidate) {
        return candidate.distance <= nearest + near_tolerance;
      }));
  return side;
}

} // namespace

WheelsetEquilibrium find_equilibrium(const WheelAndRail& left_pair, const WheelAndRail& right_pair,
                                     const EquilibriumRequest& request) {
  WheelsetEquilibrium result;
  EitherSearch left(left_pair);
  EitherSearch right(right_pair);
  if (request.roll) {
    result.roll = *request.roll;
  } else {
    RollSearch search(left, right, request.lateral, request.yaw);
    result.roll = search.solve();
  }
  const Pose pose{request.lateral, request.yaw, result.roll};
  const auto settle_side = [&](EitherSearch& search, const Pose& side_pose) {
    if (request.roll) {
      search.scan(side_pose);
    }
    return settle(search, side_pose, request.near_tolerance);
  };
  if (request.left) {
    result.left = settle_side(left, pose);
  }
  if (request.right) {
    result.right = settle_side(right, mirrored(pose));
  }
  if (result.left && result.right) {
    result.vertical = std::max(result.left->vertical, result.right->vertical);
  } else {
    result.vertical = result.left ? result.left->vertical : result.right->vertical;
  }
  return result;
}

} // namespace wrc
