/// Rails and wheels in closed form that vary along the track and around the circumference.
///
/// Rails lie level, with the origin of their profiles 750 mm from the track centre, at height 0;
/// wheels have their taping lines there.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "measured/sliced_profile_reader.hpp"
#include "profile/curve.hpp"

namespace wrc::test {

constexpr double crown = 300.0; ///< radius, mm
constexpr double half_width = 30.0;

/// Turned about the y axis, > 0 raises what is ahead.
inline Vector3 tilted(const Vector3& vector, double angle) {
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  return {cosine * vector.x - sine * vector.z, vector.y, sine * vector.x + cosine * vector.z};
}

/// The curve (y + shift, height(y)) for |y| <= half_width of a function with two derivatives.
struct Height {
  double value;
  double first;
  double second;
};

inline Curve curve_of(const std::function<Height(double)>& height, double step = 0.25) {
  const auto end_at = [&](double y) {
    const Height z = height(y);
    const double speed = std::hypot(1.0, z.first);
    const double curvature = z.second / (speed * speed * speed);
    return Curve::End{
        y, z.value, 1.0 / speed, z.first / speed, -curvature * z.first / speed, curvature / speed};
  };
  const auto speed_at = [&](double y) { return std::hypot(1.0, height(y).first); };
  std::vector<Curve::Piece> pieces;
  const int count = static_cast<int>(std::lround(2.0 * half_width / step));
  for (int i = 0; i < count; ++i) {
    const double from = -half_width + step * i;
    const double to = from + step;
    const double length = step / 6.0 * // Simpson's rule, to 1e-12 mm
                          (speed_at(from) + 4.0 * speed_at(0.5 * (from + to)) + speed_at(to));
    pieces.push_back({end_at(from), end_at(to), length});
  }
  return Curve(pieces);
}

/// A crown of radius 300 mm, its height multiplied.
inline Height crown_at(double y, double factor = 1.0) {
  const double root = std::sqrt(crown * crown - y * y);
  return {factor * (root - crown), -factor * y / root,
          -factor * crown * crown / (root * root * root)};
}

inline SlicedProfile profile_of(const std::vector<double>& places,
                                const std::function<Curve(double)>& curve_at) {
  SlicedProfile profile;
  profile.name = "rail";
  for (const double x : places)
    profile.slices.push_back({x, curve_at(x)});
  return profile;
}

inline std::vector<double> places_every(double begin, double end, double step) {
  std::vector<double> places;
  for (int i = 0; i <= std::lround((end - begin) / step); ++i)
    places.push_back(begin + step * i);
  return places;
}

inline constexpr TrackDimensions level_track{1435.0, 14.0, 0.0, 750.0};
inline constexpr WheelsetDimensions wheelset{1360.0, 70.0, 460.0};

inline Profile first_of(const SlicedProfile& sliced, ProfileKind kind) {
  Profile profile;
  profile.name = sliced.name;
  profile.kind = kind;
  profile.curve = sliced.slices.front().curve;
  return profile;
}

inline RailSurface rail_of(const SlicedProfile& sliced, double along = 0.0,
                           const TrackDimensions& track = level_track,
                           const RailDisplacement& displacement = {}) {
  return RailSurface(sliced_rail(sliced, 0.0), sliced.slices.front().curve, track)
      .posed(displacement, along);
}

/// A crown under a height that depends on the place alone.
inline SlicedProfile crown_along(const std::vector<double>& places,
                                 const std::function<double(double)>& height) {
  const Curve level = curve_of([](double y) { return crown_at(y); });
  return profile_of(places, [&](double x) { return level.moved(0.0, 0.0, height(x)); });
}

/// A crown turned by an angle about the y axis, > 0 rises ahead, through the origin.
inline SlicedProfile tilted_crown(const std::vector<double>& places, double angle) {
  const Curve section = curve_of([&](double y) { return crown_at(y, 1.0 / std::cos(angle)); });
  return profile_of(places, [&](double x) { return section.moved(0.0, 0.0, x * std::tan(angle)); });
}

struct SlicedWheel {
  std::shared_ptr<const SlicedSurface> slices;
  double radius;
};

inline WheelSurface wheel_of(const SlicedWheel& wheel, double pitch = 0.0) {
  WheelsetDimensions dimensions = wheelset;
  dimensions.radius = wheel.radius;
  return WheelSurface(wheel.slices, dimensions, pitch);
}

/// A profile with harmonics, on a radius of 460 mm.
inline WheelSurface wavy_wheel(const Curve& profile, std::vector<RadiusHarmonic> harmonics,
                               double pitch = 0.0) {
  return wheel_of({sliced_wheel(profile, wheelset.radius, std::move(harmonics)), wheelset.radius},
                  pitch);
}

/// A cylinder, lower by a depth that depends on the angle, with slices `step` apart up to `end`.
inline SlicedWheel flattened_cylinder(double radius, double end, double step,
                                      const std::function<double(double)>& depth) {
  const SlicedProfile profile = profile_of(places_every(-end, end, step), [&](double theta) {
    return curve_of([&](double) { return Height{-depth(theta), 0.0, 0.0}; });
  });
  return {sliced_wheel(profile, radius), radius};
}

/// Depth of a chord of this length about angle 0 in a circle.
inline double chord_depth(double theta, double radius, double length) {
  const double half = std::asin(0.5 * length / radius);
  return std::abs(theta) < half ? radius - radius * std::cos(half) / std::cos(theta) : 0.0;
}

/// A rounded flat: half a wave of the cosine between -half and half.
inline double rounded_depth(double theta, double depth, double half) {
  return std::abs(theta) < half ? 0.5 * depth * (1.0 + std::cos(std::numbers::pi * theta / half))
                                : 0.0;
}

} // namespace wrc::test
