/// A scene: everything that is requested, with the defaults of the paper's Table 1.
///
/// Values are reached by the keys of a scene file (scene/scene_keys.hpp), which also hold their
/// permitted ranges. Units mm, N, MPa, rad; track frame of geometry/frames.hpp.
/// Thread rule: a plain value.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "half_space/material.hpp"
#include "mechanics/normal_solver.hpp"
#include "profile/profile.hpp"
#include "rolling/rolling_contact.hpp"
#include "scene/convention.hpp"
#include "wheel/creep_forces.hpp"
#include "wheel/wheel_request.hpp"

namespace wrc {

enum class SideChoice { both, left, right };
enum class ModelRequest { automatic, half_space, hertz, kik_piotrowski };

/// As keys and results call it.
constexpr std::string_view name_of(SolverChoice solver) {
  return solver == SolverChoice::paper ? "paper" : "default";
}

struct Scene : WheelOptions {
  Convention convention; ///< of the numbers outside; those here are in mm, y left, z up

  TrackDimensions track;
  std::string rail = "60E1"; ///< name of a built-in profile, or a file
  /// Used instead of `rail` if given, which is then its name.
  std::shared_ptr<const Profile> rail_profile;
  double rail_smoothing = 0.0; ///< wavelength in mm for a rail read from a file; 0: none
  WheelsetDimensions wheelset;
  std::string wheel = "S1002";
  std::shared_ptr<const Profile> wheel_profile; ///< as rail_profile
  double wheel_smoothing = 0.0;

  Material wheel_material{210000.0, 0.3};
  Material rail_material{210000.0, 0.3};

  double lateral = 0.0;
  double yaw = 0.0;
  std::optional<double> roll;     ///< prescribed; solved if not set
  std::optional<double> vertical; ///< prescribed height of the wheelset's centre; solved if not set

  double left_load = 80000.0; ///< vertical force on the left wheel
  double right_load = 80000.0;
  std::optional<double> normal_load; ///< instead: force along the patch's normal, each wheel

  /// Of all patches of a wheel, at their references; without: no creep forces.
  std::optional<Creepages> left_creepages;
  std::optional<Creepages> right_creepages;
  double left_friction = 0.3;
  double right_friction = 0.3;
  /// What creepages follow from where they are not given; with them its speed is that of the power.
  std::optional<Motion> motion;
  std::optional<CreepModel> creep; ///< automatic if not set: full where there are creepages

  SideChoice side = SideChoice::both;
  ModelRequest model = ModelRequest::automatic;
  std::optional<Elements> elements; ///< smooth, but constant with the paper's solver, if not set
  PlannerRigor planner = PlannerRigor::estimate;
  Precision precision = Precision::mixed;
  double near_tolerance = 0.1; ///< contacts listed as near: distance at first touch, mm
  int threads = 1;

  Scene();
};

} // namespace wrc
