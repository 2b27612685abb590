/// The whole way of a scene: profiles, geometry, remesh, mechanics, and the results by name.
///
/// Results are in the track frame (geometry/frames.hpp), both sides alike; only along a profile
/// (`s_wheel`, `t_rail`) and across a patch (`lateral`) positive means to the field side.
/// Units mm, N, MPa, rad; times in ms. Thread rule: functions of the results are pure, but for
/// residuals_of.
#pragma once

#include <memory>
#include <optional>
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

/// What fields and outlines are computed from when they are asked for.
struct SideDetails {
  double mirror = 1.0;   ///< +1 on the left, -1 on the right: from the side's left-hand frame
  ContactFrame frame;    ///< left-hand frame of the side
  Pose pose;             ///< likewise
  double vertical = 0.0; ///< height of the wheelset's centre under load
  std::vector<double> undeformed_distance;
  std::vector<double> pressure;
  double combined_modulus = 0.0;
  std::optional<double> normal_load; ///< of the normal contact problem; or approach 0 is given
  double problem_approach = 0.0;     ///< answer to that problem
  std::shared_ptr<const WheelSurface> wheel;
  std::shared_ptr<const RailSurface> rail;
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
  std::optional<Residuals> residuals; ///< once asked for, see residuals_of
  Grid grid;                          ///< no elements without contact
  std::vector<PatchResult> patches;   ///< largest normal force first
  std::vector<std::string> warnings;
  SideDetails details;
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

/// A scene by itself: a pure function.
SceneResult solve_scene(const Scene& scene);

/// Solves scenes one after the other and keeps what the next one can use.
///
/// Profiles, influence coefficients, transform plans and memory are kept; they change no bit of a
/// result. Positions, depths and extents of the last contact are kept too and serve as the start of
/// the next solution; results then agree with those of solve_scene within the accuracy asked. Every
/// contact search is global all the same, so a jump of the contact is never missed.
/// A profile read from a file is kept by its name: forget() after the file has changed.
/// Thread rule: one object serves one thread at a time.
class SceneSolver {
public:
  SceneSolver();
  ~SceneSolver();
  SceneSolver(SceneSolver&&) noexcept;
  SceneSolver& operator=(SceneSolver&&) noexcept;

  /// On failure what is kept from earlier scenes stays usable.
  SceneResult solve(const Scene& scene);
  /// The next solution starts without positions of earlier ones: bit for bit that of solve_scene.
  void forget_positions();
  /// Drops everything, profiles included.
  void forget();

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// KKT residuals of a side in double precision, by a convolution of its own; computed once.
const Residuals& residuals_of(SideResult& side);

/// All scalar results by name ("left.pmax", "left.patches.0.angle", ...), in a fixed order.
std::vector<std::string> number_names(const SceneResult& result);
/// One of them; residuals are computed when they are first asked for. None of that name: nothing.
std::optional<double> number_value(SceneResult& result, std::string_view name);
/// All texts by name ("model", "left.warnings.0", ...).
std::vector<std::pair<std::string, std::string>> text_values(const SceneResult& result);
/// A field by name ("left.pressure", "right.rail_y", ...), computed now: per element of the side's
/// grid, or along an outline (wheel and rail in the plane of the contact, for a picture). Nothing
/// if there is none of that name.
std::optional<std::vector<double>> field_values(const SceneResult& result, std::string_view name);

} // namespace wrc
