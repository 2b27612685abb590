/// The whole way of a scene: profiles, geometry, remesh, mechanics, and the results by name.
///
/// Results are in the track frame (geometry/frames.hpp), both sides alike; only along a profile
/// (`s_wheel`, `t_rail`) and across a patch (`lateral`) positive means to the field side.
/// Units mm, N, MPa, rad; times in ms. Thread rule: solve_scene is a pure function.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.hpp"
#include "scene/side_solution.hpp"

namespace wrc {

/// A place where wheel and rail meet at the first touch.
struct ContactPlace {
  double x = 0.0, y = 0.0, z = 0.0; ///< track frame
  double angle = 0.0;               ///< of the rail's tangent about x, > 0: rises to the left
  double s_wheel = 0.0;
  double w_wheel = 0.0;
  double wheel_angle = 0.0; ///< t of the wheel point about the axle, rad
  double t_rail = 0.0;
  double v_rail = 0.0;         ///< height in the rail profile's own frame
  double rolling_radius = 0.0; ///< at the contact point
  double distance = 0.0;       ///< vertical, at the first touch; 0 for the first contact
};

struct PatchResult {
  double pmax = 0.0;
  double area = 0.0;
  double normal_force = 0.0;
  double approach = 0.0;
  double angle = 0.0;
  ContactPlace centre; ///< of pressure, on the rail's surface
  double semi_axis_longitudinal = 0.0;
  double semi_axis_lateral = 0.0;
};

/// Fields on the grid of a side; one value per element, longitudinal index fastest.
struct SideFields {
  std::vector<double> x, y, z; ///< element centres in the track frame
  std::vector<double> undeformed_distance;
  std::vector<double> pressure;
  std::vector<double> displacement;
};

/// Wheel and rail in the plane x = x of the contact, for a picture: y and z of the track frame.
struct CrossSection {
  std::vector<double> rail_y, rail_z;
  std::vector<double> wheel_y, wheel_z; ///< contact locus of the wheel at its final height
};

struct SideResult {
  ContactPlace rigid_contact;
  std::vector<ContactPlace> near_contacts; ///< further ones, nearest first
  double vertical = 0.0; ///< height of the wheelset's centre at which this wheel first touches
  double pmax = 0.0;
  double pmax_element = 0.0; ///< largest element value
  double area = 0.0;
  double normal_force = 0.0;
  double vertical_force = 0.0; ///< of the rail on the wheel, upwards
  double lateral_force = 0.0;  ///< of the rail on the wheel, to the left
  double approach = 0.0;       ///< along the normal, from the first touch
  double depth = 0.0;          ///< vertical, from the first touch
  double angle = 0.0;          ///< of the patch's plane about x, > 0: rises to the left
  std::optional<double> error_estimate;
  int iterations = 0;
  int regrown = 0;
  double fill = 0.0; ///< share of the elements under pressure
  StopReason stop_reason = StopReason::tolerance_met;
  Residuals residuals;
  Grid grid;
  std::vector<PatchResult> patches; ///< largest normal force first
  std::vector<std::string> warnings;
  SideFields fields;
  CrossSection section;
};

/// Milliseconds by stage; a stage's threads are added up, the total is wall time.
struct StageMilliseconds {
  double profile = 0.0;
  double setup = 0.0;
  double geometry = 0.0;
  double remesh = 0.0;
  double mechanics = 0.0;
  double total = 0.0;
};

struct SceneResult {
  double roll = 0.0;
  double vertical = 0.0; ///< height of the wheelset's centre at the first touch
  std::optional<double> rolling_radius_difference; ///< left - right; with both sides
  std::string model;
  std::string solver;
  std::optional<SideResult> left;
  std::optional<SideResult> right;
  StageMilliseconds time;
  std::vector<std::string> corrections; ///< made to profiles read from files
};

SceneResult solve_scene(const Scene& scene);

/// All scalar results by name ("left.pmax", "left.patches.0.angle", ...), in a fixed order.
std::vector<std::pair<std::string, double>> number_values(const SceneResult& result);
/// All texts by name ("model", "left.warnings.0", ...).
std::vector<std::pair<std::string, std::string>> text_values(const SceneResult& result);
/// A field by name ("left.pressure", "right.rail_y", ...); empty if there is none of that name.
std::span<const double> field_values(const SceneResult& result, std::string_view name);
/// The names that field_values knows, without the side.
std::span<const std::string_view> field_names();

} // namespace wrc
