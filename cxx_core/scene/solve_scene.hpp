/// The pipeline of a scene: profiles, geometry, remesh, mechanics, and the results by name.
///
/// Results are in the track frame (geometry/frames.hpp), the same for both wheels; only along a
/// profile
/// (`s_wheel`, `t_rail`) and across a patch (`lateral`) positive means to the field side.
/// Units mm, N, MPa, rad, by name also others (keys/convention.hpp); times in ms. Thread rule:
/// functions of the results are pure, except number_names and number_value, which keep what they
/// have computed (scene_wheel.hpp).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "keys/scene.hpp"
#include "scene/number_ids.hpp"
#include "scene/scene_result.hpp"
#include "scene/scene_warnings.hpp"

namespace wrc {

/// Elastic constants of a wheel and its rail: of like bodies where the difference of theirs is too
/// small to change a result (half_space/material.hpp).
ShearConstants shear_constants_of(const Scene& scene, const SceneSide& side);

/// A scene by itself: a pure function.
SceneResult solve_scene(const Scene& scene, const SolverOptions& options = {});

class SurfaceCache; // scene/surface_cache.hpp

/// Solves scenes one after the other and keeps what saves time and changes no bit of a result:
/// profiles, surfaces, influence coefficients, transform plans and memory. A profile read from a
/// file is kept by its name: forget() after the file has changed. Thread rule: one object serves
/// one thread at a time.
class SceneSolver {
public:
  SceneSolver();
  /// With surfaces that outlive it.
  explicit SceneSolver(std::shared_ptr<SurfaceCache> surfaces);
  ~SceneSolver();
  SceneSolver(SceneSolver&&) noexcept;
  SceneSolver& operator=(SceneSolver&&) noexcept;

  /// Bit for bit the result of solve_scene with its options, whatever was solved before.
  SceneResult solve(const Scene& scene);
  /// Creep forces of a patch of a result of this scene at other creepages, those at the patch's
  /// reference in the track frame.
  CreepResult solve_creep(const Scene& scene, const WheelResult& wheel, const PatchResult& patch,
                          const Creepages& creepages, bool derivatives);
  /// From the next solution on.
  void set_options(const SolverOptions& options);
  /// Drops everything that is kept; options stay.
  void forget();
  /// Another one, for another thread: both share profiles, influence coefficients and plans; the
  /// options are copied, and either may be used, cleared or destroyed at any time.
  [[nodiscard]] SceneSolver beside() const;

private:
  struct Shared;
  struct State;
  std::unique_ptr<State> state_;
};

/// All scalar results by name ("left.pmax", "left.patches.0.angle", ...), in a fixed order.
std::vector<std::string> number_names(SceneResult& result);
/// One of them; not-a-number, or none, if the result has no such number. Residuals and
/// sensitivities are computed when first requested, contact areas and regions each time.
double number_value(SceneResult& result, const NumberId& id, const Convention& convention = {});
std::optional<double> number_value(SceneResult& result, std::string_view name,
                                   const Convention& convention = {});
/// "N mm/s", "N m/s"; "1" if there is none.
std::string number_unit(const NumberId& id, Units units);
/// All texts by name ("model", "warnings.0", "left.warnings.0", ...).
std::vector<std::pair<std::string, std::string>> text_values(const SceneResult& result,
                                                             const Convention& convention = {});
/// A field by name ("left.patches.0.pressure", "right.rail_y", ...), computed now: per element of a
/// patch's grid ("left.pressure" is short for that of the first patch), or along an outline (wheel
/// and rail in the plane of the contact, for a picture). None if there is no such name. Lobes are
/// found when the first of their fields is requested.
std::optional<std::vector<double>> field_values(SceneResult& result, std::string_view name,
                                                const Convention& convention = {});
/// Whether a solution may have a field of this name.
bool names_field(std::string_view name);
/// Those of the left wheel and of its first patch.
std::vector<std::string> possible_field_names();

} // namespace wrc
