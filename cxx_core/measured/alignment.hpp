/// The motion that lays measured points on a nominal profile, where they are not worn.
///
/// Least squares of the distances along the nominal's normals over rotation and two shifts, by
/// Gauss-Newton steps. Points count with Tukey's biweight (Beaton and Tukey, Technometrics 16,
/// 1974), whose bound falls in stages from 5 mm to 0.2 mm as long as half of the points stay
/// within it: worn parts drop out. Points beyond the ends of the nominal do not count. Units mm and
/// rad. From afar it begins at several turns, with the highest point or the middle of the points on
/// that of the nominal. Does not know otherwise: points that begin far from the nominal, by more
/// than about 5 mm or 5 degrees. Thread rule: no state.
#pragma once

#include <optional>
#include <span>

#include "profile/curve.hpp"

namespace wrc {

/// Rotation about the origin, anticlockwise in (lateral, height), then a shift.
struct RigidMotion {
  double rotation = 0.0; ///< rad
  Position shift{0.0, 0.0};

  [[nodiscard]] Position of(const Position& point) const;
};

struct Alignment {
  RigidMotion motion;
  double deviation = 0.0; ///< rms of the points that count, along normals, mm
  double bound = 0.0;     ///< that they are within, mm
  double share = 0.0;     ///< of the points beside the nominal that count
  double beside = 0.0;    ///< share of the points beside it
};

/// None if the points do not determine the motion: too few beside the nominal, or a straight line.
std::optional<Alignment> alignment_to(const Curve& nominal, std::span<const Position> points,
                                      const RigidMotion& start = {});
/// Of points that lie anywhere, turned by up to 30 degrees: the alignment with the smallest bound.
std::optional<Alignment> alignment_from_afar(const Curve& nominal,
                                             std::span<const Position> points);

} // namespace wrc
