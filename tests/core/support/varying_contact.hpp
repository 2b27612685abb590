/// A left wheel on a left rail of which either varies, solved without files.
///
/// Roll is prescribed. Units mm, N, MPa, rad; left-hand frame (geometry/frames.hpp).
#pragma once

#include <memory>
#include <utility>

#include "geometry/varying_shapes.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "half_space/material.hpp"
#include "results/make_wheel_result.hpp"
#include "wheel/solve_wheel.hpp"

namespace wrc::test {

inline const double steel = combined_modulus({210000.0, 0.3}, {210000.0, 0.3});

struct LeftBodies {
  std::shared_ptr<const WheelSurface> wheel;
  std::shared_ptr<const RailSurface> rail;

  LeftBodies(WheelSurface of_wheel, RailSurface of_rail)
      : wheel(std::make_shared<const WheelSurface>(std::move(of_wheel))),
        rail(std::make_shared<const RailSurface>(std::move(of_rail))) {}
};

inline WheelRequest under_load(double load, AccuracyOf accuracy_of = AccuracyOf::pressures,
                               double accuracy = 1e-3) {
  WheelRequest request;
  request.combined_modulus = steel;
  request.vertical_load = load;
  request.accuracy_of = accuracy_of;
  request.accuracy = accuracy;
  return request;
}

inline SideEquilibrium equilibrium_of(const LeftBodies& bodies, const Pose& pose = {}) {
  EquilibriumRequest request;
  request.lateral = pose.lateral;
  request.yaw = pose.yaw;
  request.roll = pose.roll;
  request.right = false;
  const WheelAndRail pair{*bodies.wheel, *bodies.rail};
  return *find_equilibrium(pair, pair, request).left;
}

inline WheelResult solve_left(const LeftBodies& bodies, const WheelRequest& request,
                              const Pose& pose = {}) {
  const SideEquilibrium equilibrium = equilibrium_of(bodies, pose);
  NormalSolver solver;
  return make_wheel_result(solve_wheel(*bodies.wheel, *bodies.rail, equilibrium, request, solver),
                           bodies.wheel, bodies.rail, equilibrium, 1.0);
}

} // namespace wrc::test
