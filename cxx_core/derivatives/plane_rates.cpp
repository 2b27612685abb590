#include "derivatives/plane_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/value_with_rates.hpp"
#include "patches/patch_finder.hpp"
#include "remesh/constants.hpp"

namespace wrc {
namespace {

/// Variables: the motions, and along the profile. Indices, not a tuning constant.
constexpr std::size_t lateral = 0;
constexpr std::size_t vertical = 1;
constexpr std::size_t roll = 2;
constexpr std::size_t yaw = 3;
constexpr std::size_t along = 4;

using ByPlace = WithRates<5>;
using Rated = WithRates<motion_count>;

class MovingPlaces {
public:
  using Real = Rated;
  using Place = patch_finding::LocusSample<Rated>;

  MovingPlaces(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose)
      : wheel_(wheel), rail_(rail.graph().heights()),
        sin_yaw_(sin(ByPlace::variable(pose.yaw, yaw))),
        cos_yaw_(cos(ByPlace::variable(pose.yaw, yaw))),
        lateral_(ByPlace::variable(pose.lateral, lateral)),
        sin_roll_(sin(ByPlace::variable(pose.roll, roll))),
        cos_roll_(cos(ByPlace::variable(pose.roll, roll))) {}

  [[nodiscard]] Place place_of(const DistanceSample& sample, double limit) const {
    const Meeting meeting = meet(sample.wheel.lateral);
    Place place = place_of(meeting, {});
    set_values(place, sample.wheel, sample.distance, limit - sample.distance, sample.rail_slope,
               -sample.by_y);
    return place;
  }

  [[nodiscard]] Place place_of(const ContactCandidate& contact, double penetration) const {
    const Meeting meeting = meet(contact.wheel.lateral);
    std::array<double, motion_count> moves{};
    const double by_place = meeting.sine.rates[along];
    if (std::abs(meeting.sine.value) < kink_sine && by_place != 0.0) {
      for (std::size_t motion = 0; motion < motion_count; ++motion) {
        moves[motion] = -meeting.sine.rates[motion] / by_place;
      }
    }
    Place place = place_of(meeting, moves);
    place.steepness = 0.0;
    set_values(place, contact.wheel, contact.distance, penetration, std::tan(contact.rail_angle),
               0.0);
    return place;
  }

  [[nodiscard]] Rated yaw_tangent() const { return rated(sin_yaw_) / rated(cos_yaw_); }

private:
  /// Wheel and rail at a point of the profile.
  struct Meeting {
    ByPlace s, x, y, rail, distance, slope, curvature, steepness;
    ByPlace sine; ///< of the angle from the rail's to the wheel's tangent, times a factor
  };

  [[nodiscard]] Meeting meet(double s) const {
    const HeightPoint profile = wheel_.graph().heights().at(s);
    Meeting meeting;
    meeting.s = ByPlace::variable(s, along);
    const ByPlace height = ByPlace::of(profile.height, profile.slope, meeting.s);
    const ByPlace slope = ByPlace::of(profile.slope, profile.second, meeting.s);
    // The angle of the locus, as in geometry/wheel_surface.hpp.
    const ByPlace b = sin_yaw_ * sin_roll_;
    const ByPlace c = -sin_yaw_ * cos_roll_ * slope;
    const ByPlace square = cos_yaw_ * cos_yaw_ + b * b;
    const ByPlace root = sqrt(std::max<ByPlace>(square - c * c, 0.0));
    const ByPlace sine = (cos_yaw_ * c + b * root) / square;
    const ByPlace cosine = (cos_yaw_ * root - b * c) / square;

    const ByPlace rho = wheel_.radius() + height;
    const ByPlace across = wheel_.taping_line() + meeting.s;
    const ByPlace forward = rho * sine;
    const ByPlace down = rho * cosine;
    const ByPlace level = cos_roll_ * across + sin_roll_ * down;
    meeting.x = cos_yaw_ * forward - sin_yaw_ * level;
    meeting.y = lateral_ + sin_yaw_ * forward + cos_yaw_ * level;
    const ByPlace z = ByPlace::variable(0.0, vertical) + sin_roll_ * across - cos_roll_ * down;

    const HeightPoint rail = rail_.at(meeting.y.value);
    meeting.rail = ByPlace::of(rail.height, rail.slope, meeting.y);
    meeting.distance = z - meeting.rail;
    meeting.slope = ByPlace::of(rail.slope, rail.second, meeting.y);
    meeting.curvature = 1.0 / (rho * sqrt(1.0 + slope * slope));
    const ByPlace normal_y = sin_yaw_ * sine + cos_yaw_ * (sin_roll_ * cosine - cos_roll_ * slope);
    const ByPlace normal_z = -(sin_roll_ * slope + cos_roll_ * cosine);
    meeting.sine = normal_y + meeting.slope * normal_z;
    meeting.steepness = meeting.sine / normal_z;
    return meeting;
  }

  /// A point that moves along the profile.
  static Place place_of(const Meeting& meeting, const std::array<double, motion_count>& moves) {
    const auto moved = [&moves](const ByPlace& number) {
      Rated result(number.value);
      for (std::size_t motion = 0; motion < motion_count; ++motion) {
        result.rates[motion] = number.rates[motion] + moves[motion] * number.rates[along];
      }
      return result;
    };
    return {moved(meeting.x),         moved(meeting.y),         moved(meeting.rail),
            moved(meeting.s),         -moved(meeting.distance), moved(meeting.slope),
            moved(meeting.curvature), moved(meeting.steepness)};
  }

  /// A quantity that is the same all along the profile.
  static Rated rated(const ByPlace& number) {
    Rated result(number.value);
    std::copy_n(number.rates.begin(), motion_count, result.rates.begin());
    return result;
  }

  /// To the last bit those of the scan, so that patches are the same.
  static void set_values(Place& place, const LocusPlace& wheel, double distance, double penetration,
                         double slope, double steepness) {
    place.x.value = wheel.position.x;
    place.y.value = wheel.position.y;
    place.z.value = wheel.position.z - distance;
    place.s.value = wheel.lateral;
    place.penetration.value = penetration;
    place.slope.value = slope;
    place.steepness.value = steepness;
    place.curvature.value = wheel.normal_curvature;
  }

  const WheelSurface& wheel_;
  const HeightFunction& rail_;
  ByPlace sin_yaw_;
  ByPlace cos_yaw_;
  ByPlace lateral_;
  ByPlace sin_roll_;
  ByPlace cos_roll_;
};

ByMotion<double> rates_of(const Rated& number) {
  return {number.rates[lateral], number.rates[vertical], number.rates[roll], number.rates[yaw]};
}

} // namespace

ByMotion<double> MovingPatches::coupling_weight_rate(std::size_t i, std::size_t j,
                                                     Interaction interaction) const {
  if (interaction == Interaction::all) {
    const double turned = found.patches[i].angle - found.patches[j].angle;
    return by_motion([&](std::size_t motion) {
      const double rate = rates[i].angle[motion] - rates[j].angle[motion];
      return std::cos(turned) > 0.0 ? -std::sin(turned) * rate : 0.0;
    });
  }
  double least = 1.0;
  ByMotion<double> rate;
  for (std::size_t k = std::min(i, j); k < std::max(i, j); ++k) {
    if (found.links[k] < least) {
      least = found.links[k];
      rate = link_rates[k];
    }
  }
  return rate;
}

MovingPatches find_moving_patches(const WheelSurface& wheel, const RailSurface& rail,
                                  const Pose& pose, const ContactScan& scan, double depth,
                                  const PatchOptions& options) {
  const MovingPlaces places(wheel, rail, pose);
  patch_finding::PatchFinder finder(scan, depth, options, places);
  MovingPatches result{finder.find(), {}, {}};
  for (std::size_t k = 0; k < result.found.patches.size(); ++k) {
    if (k > 0) {
      result.link_rates.push_back(rates_of(finder.link(k - 1)));
    }
    const patch_finding::Moments<Rated>& moments = finder.moments(k);
    const patch_finding::Lobe<Rated>& lobes = finder.lobes(k);
    result.rates.push_back({rates_of(finder.angle(k)), rates_of(moments.x / moments.weight),
                            rates_of(moments.y / moments.weight), rates_of(lobes.x_first),
                            rates_of(lobes.x_last), rates_of(lobes.y_first),
                            rates_of(lobes.y_last)});
  }
  return result;
}

} // namespace wrc
