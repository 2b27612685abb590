/// How forces and pressures of a wheel change with the wheelset's position.
///
/// Units mm, N, MPa, rad: forces by N/mm and N/rad, moments by N and N mm/rad. Thread rule: plain
/// values.
#pragma once

#include <optional>
#include <vector>

#include "base/by_motion.hpp"
#include "geometry/frames.hpp"

namespace wrc {

/// Force of the rail on the wheel and its moment about the wheelset's centre.
struct WheelForce {
  Vector3 force;  ///< N, or its rate
  Vector3 moment; ///< N mm, or its rate
};

inline WheelForce operator+(const WheelForce& a, const WheelForce& b) {
  return {a.force + b.force, a.moment + b.moment};
}
inline WheelForce operator*(double s, const WheelForce& a) {
  return {s * a.force, s * a.moment};
}
using ForceRates = ByMotion<WheelForce>;

/// How a patch's elements move in its plane: by `along` + `longitudinal_growth` x, and likewise.
struct ElementMotion {
  double along = 0.0; ///< mm/mm or mm/rad
  double across = 0.0;
  double longitudinal_growth = 0.0; ///< 1/mm or 1/rad
  double lateral_growth = 0.0;
};

/// What lateral position and roll change when the height follows so that the vertical force stays.
struct CondensedRates {
  struct Motion {
    double vertical = 0.0; ///< dz/dq
    WheelForce wheel;      ///< dF/dq and dM/dq; dF_z/dq = 0
  };
  Motion lateral;
  Motion roll;
  Motion yaw;
};

/// How a patch changes with the wheelset's position, left-hand frame of the side.
struct PatchRates {
  ByMotion<double> normal_force;
  ByMotion<ElementMotion> elements;       ///< that follow the contact, the plane fixed
  ByMotion<std::vector<double>> pressure; ///< of these, MPa
  ByMotion<double> angle;                 ///< of the plane
  ByMotion<Vector3> reference;            ///< of the plane's origin, which stays on the rail
  ByMotion<double> gap; ///< of the undeformed distance where it is least, the plane fixed
};

/// How the normal forces change with the wheelset's position, track frame
/// (derivatives/patch_rates.hpp).
struct WheelRates {
  ForceRates force; ///< pairs of it are equal (make_symmetric)
  /// Each motion by itself, as the rates of pressures are from which creep forces follow.
  ForceRates by_pressures;
  std::optional<CondensedRates> at_load;
  std::vector<PatchRates> patches; ///< as solved_patches
};

} // namespace wrc
