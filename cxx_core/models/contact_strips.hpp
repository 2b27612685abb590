/// Wheel and rail in strips along the rail: where the wheel comes nearest to each, and how both
/// bend there.
///
/// A rail is prismatic, so on a strip of constant y the least vertical gap lies on the wheel's
/// contact locus (geometry/wheel_surface.hpp), yawed wheels included. With the slope m of the wheel
/// profile, m' its derivative, and t the locus' angle, a sin t - b cos t = c(m) gives
/// dt/ds = c'/(a cos t + b sin t), and from it how the locus moves and turns along the profile.
/// Lowering the wheel changes the gap of every strip by as much, so a depth needs no new strips.
/// Units mm and rad; track frame, left-hand side; curvatures in 1/mm. Thread rule: immutable.
#pragma once

#include <cmath>
#include <optional>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"

namespace wrc {

struct ContactStrip {
  double s = 0.0;        ///< on the wheel
  Vector3 rail;          ///< the point below the wheel's nearest one
  double distance = 0.0; ///< vertical, with the wheelset's centre at height 0
  double rail_slope = 0.0;
  double lateral_rate = 0.0;      ///< dy/ds
  double longitudinal_rate = 0.0; ///< dx/ds
  /// Curvature of the wheel along the rail, > 0.
  double longitudinal_curvature = 0.0;
  /// Curvature of wheel and rail together, > 0 where they part: of the wheel's outline, seen along
  /// the rail, against the rail.
  double lateral_curvature = 0.0;
};

class ContactStrips {
public:
  /// The surfaces must outlive the strips.
  ContactStrips(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose)
      : wheel_(wheel), rail_(rail), pose_(pose) {}

  /// None beyond the ends of a profile, and where the wheel is no nearer there than beside.
  [[nodiscard]] std::optional<ContactStrip> at(double s) const;

private:
  const WheelSurface& wheel_;
  const RailSurface& rail_;
  LocusPose pose_;
};

} // namespace wrc
