/// A profile that loses material, a wheel's by wear, or of both what a groove takes: points along
/// its curve, each of which loses a depth along its normal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

class WornProfile {
public:
  /// Points of a profile, `spacing` mm apart along the curve.
  WornProfile(const Profile& profile, double spacing);

  /// Notes an area in mm^2 that is worn off at position s, distributed to the two points beside it.
  void add(double s, double area);
  /// Takes off what was noted times `factor`, smoothed over some points; what is taken off is the
  /// area noted, exactly: normals cross where the profile is curved.
  void wear(double factor);
  /// Depths along the normals at lateral positions in order, linear between them.
  struct Groove {
    std::vector<double> lateral;
    std::vector<double> depth;
  };
  /// Takes them off as they are, the largest where several overlap.
  void take_off(const std::vector<Groove>& grooves);
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
  [[nodiscard]] std::size_t point_before(double lateral) const;
  [[nodiscard]] std::vector<double> smoothed() const;
  [[nodiscard]] Points moved(const std::vector<double>& depth) const;
  static double area_between(const Points& outer, const Points& inner);

  double spacing_;
  std::int32_t kind_;
  Points fresh_;
  Points now_;
  std::vector<double> noted_;
};

} // namespace driver
