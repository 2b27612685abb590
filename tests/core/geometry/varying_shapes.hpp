/// Rails and sections in closed form that vary along the track.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "profile/curve.hpp"
#include "profile/sliced_profile.hpp"

namespace wrc::test {

constexpr double crown = 300.0; ///< radius, mm
constexpr double half_width = 30.0;

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

} // namespace wrc::test
