/// A wheel profile that wears: points along its curve, each of which loses a depth along its
/// normal.
#pragma once

#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

class WornProfile {
public:
  /// Points of a wheel, `spacing` mm apart along the curve.
  WornProfile(const Profile& profile, double spacing);

  /// Notes an area in mm^2 that is worn off at position s, distributed to the two points beside it.
  void add(double s, double area);
  /// Takes off what was noted times `factor`, smoothed over some points; what is taken off is the
  /// area noted, exactly: normals cross where the profile is curved.
  void wear(double factor);
  /// Forgets what was noted.
  void clear() { noted_.assign(noted_.size(), 0.0); }

  /// The greatest depth that the areas noted stand for, mm.
  [[nodiscard]] double noted_depth() const;
  [[nodiscard]] Profile profile() const;
  /// Area between the profile as new and now, mm^2.
  [[nodiscard]] double missing_area() const;
  /// Distance from the profile as new, along its normal, mm.
  [[nodiscard]] std::vector<double> depths() const;
  [[nodiscard]] const wrcontact::Profile::Points& fresh() const { return fresh_; }
  [[nodiscard]] const wrcontact::Profile::Points& points() const { return now_; }

private:
  using Points = wrcontact::Profile::Points;
  [[nodiscard]] std::vector<double> smoothed() const;
  [[nodiscard]] Points moved(const std::vector<double>& depth) const;
  static double area_between(const Points& outer, const Points& inner);

  double spacing_;
  Points fresh_;
  Points now_;
  std::vector<double> noted_;
};

} // namespace driver
