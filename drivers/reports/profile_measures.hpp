/// What is measured on a profile: dimensions, checks of the curve, distance to another profile.
///
/// Units mm, rad. Frame of the profile: lateral positive to the field side; height of a wheel
/// positive towards larger radius, of a rail upwards. A quantity that a profile does not have, for
/// example the flange of half a measurement, is absent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// A curve at one position.
struct ProfilePoint {
  double arc = 0.0;
  double lateral = 0.0;
  double height = 0.0;
  double angle = 0.0;
  double curvature = 0.0;
};
ProfilePoint point_at(const Profile& profile, double arc);
inline bool is_wheel(const Profile& profile) {
  return profile.kind() == WRC_WHEEL;
}
inline std::string kind_name(const Profile& profile) {
  return is_wheel(profile) ? "wheel" : "rail";
}

/// A named length or number, and how it is defined.
struct Dimension {
  std::string key;
  std::string label;
  std::string unit;
  std::optional<double> value;
  std::string definition;
};

/// A part of the curve that stands steeper than it can be written as height over lateral.
struct SteepPart {
  ProfilePoint first;
  ProfilePoint last;
  double steepest_angle = 0.0; ///< the angle of largest magnitude, rad
  bool overhangs = false;      ///< somewhere beyond the vertical
};

struct Checks {
  double largest_kink = 0.0; ///< change of the tangent's direction between two pieces, rad
  ProfilePoint kink_at;
  double largest_step = 0.0; ///< gap between two pieces, mm
  ProfilePoint step_at;
  double smallest_radius = 0.0; ///< of curvature; 0 if the whole curve is straight
  ProfilePoint radius_at;
  std::vector<SteepPart> steep_parts;
};

/// Of a profile with another, each in its own frame: nothing is shifted or turned to fit.
struct Comparison {
  double largest = 0.0; ///< normal distance, positive where the other profile is higher
  ProfilePoint largest_at;
  double rms = 0.0;                   ///< over the arc length that has a counterpart
  double compared = 0.0;              ///< that arc length
  double missing_area = 0.0;          ///< between the profiles where the other one is higher, mm^2
  double added_area = 0.0;            ///< where it is lower
  std::vector<Dimension> differences; ///< dimensions of the profile less those of the other
};

struct Measures {
  std::vector<double> nodes;
  double length = 0.0;
  double least_lateral = 0.0;
  double greatest_lateral = 0.0;
  double least_height = 0.0;
  double greatest_height = 0.0;
  std::vector<Dimension> dimensions;
  Checks checks;
};

/// Above this inclination a part counts as steep.
inline constexpr double steep_angle = 75.0; // degrees

/// Points `spacing` apart along the arc, both ends included.
std::vector<ProfilePoint> equal_points(const Profile& profile, double spacing);
/// Points of every piece from its begin to its end: kinks and steps show as two points.
std::vector<ProfilePoint> piece_points(const Profile& profile);

/// `flange_back` is the lateral coordinate of the inner face of a wheel.
Measures measure(const Profile& profile, double flange_back);
/// Throws Failure if the profiles are of different kinds or nowhere side by side.
Comparison compare(const Profile& profile, const Profile& other);
/// Normal distance from each point to a profile, positive where that is higher; NaN beyond its
/// ends.
std::vector<double> distances_to(const Profile& other, const std::vector<ProfilePoint>& points);
/// The dimensions of one less those of the other, of the same kind; absent if one does not have it.
std::vector<Dimension> differences(const Measures& measures, const Measures& other);

} // namespace driver
