#include "scene/solve_scene.hpp"

#include <algorithm>
#include <cmath>
#include <future>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "creep/creep_forces.hpp"
#include "creep/free_pitch.hpp"
#include "creep/friction.hpp"
#include "creep/patch_coefficients.hpp"
#include "creep/total_force.hpp"
#include "derivatives/steady_error.hpp"
#include "results/contact_damage.hpp"
#include "results/make_wheel_result.hpp"
#include "results/wheel_state.hpp"
#include "scene/constants.hpp"
#include "scene/model_choice.hpp"
#include "scene/surface_cache.hpp"
#include "scene/total_load.hpp"
#include "wheel/solve_wheel.hpp"

namespace wrc {

ShearConstants shear_constants_of(const Scene& scene, const SceneSide& side) {
  ShearConstants constants = shear_constants(scene.wheel_material, scene.rail_material);
  constants.difference_parameter = effective_difference(
      constants.difference_parameter, smallest_friction(side.friction), scene.accuracy);
  return constants;
}

namespace {

WheelRequest request_of(const Scene& scene, double load) {
  WheelRequest request;
  static_cast<WheelOptions&>(request) = scene;
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  request.yielding = yielding_bodies_of(scene);
  if (scene.vertical) {
    request.vertical = scene.vertical;
  } else if (scene.load_of == LoadOf::normal) {
    request.normal_load = load;
  } else {
    request.vertical_load = load;
  }
  request.creep_forces = (scene.has_creepages() || scene.motion) &&
                         scene.creep.value_or(CreepModel::full) == CreepModel::full;
  request.stresses = scene.damage.stress;
  return request;
}

EquilibriumRequest equilibrium_request_of(const Scene& scene) {
  EquilibriumRequest request;
  request.lateral = scene.lateral;
  request.yaw = scene.yaw;
  request.roll = scene.roll;
  request.left = scene.side != SideChoice::right;
  request.right = scene.side != SideChoice::left;
  request.near_tolerance = scene.near_tolerance;
  return request;
}

/// What it needs besides the creepages.
CreepRequest creep_options_of(const Scene& scene, const SceneSide& side) {
  CreepRequest request;
  request.model = scene.creep.value_or(CreepModel::full);
  request.friction = side.friction;
  request.accuracy = scene.accuracy;
  request.element_limit = scene.most_elements();
  request.pitch_is_free = scene.motion.has_value() && scene.pitch_is_free;
  request.derivatives = scene.derivatives;
  request.slip = scene.slip;
  request.material = shear_constants_of(scene, side);
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  return request;
}

CreepRequest creep_request_of(const Scene& scene, const SceneSide& side) {
  const bool given = scene.has_creepages();
  if (given ? !side.creepages : !scene.motion) {
    return {};
  }
  CreepRequest request = creep_options_of(scene, side);
  if (given) {
    request.creepages = *side.creepages;
    request.speed = scene.motion ? std::abs(scene.motion->speed) : 0.0;
  } else {
    request.motion = scene.motion;
    request.motion->standstill_speed = scene.standstill_speed;
    request.motion->acceleration = scene.acceleration;
    request.nominal_radius = scene.nominal_radius();
    request.rail_velocity = side.velocity;
    request.rail_slope = side.slope;
    request.time_step = scene.time_step;
    const std::size_t index = &side == &scene.right ? 1 : 0;
    request.history = scene.history ? &scene.history->wheels[index] : nullptr;
  }
  return request;
}

/// One wheel of a scene.
struct WheelTask {
  const Scene& scene;
  const SceneSide& side;
  const SideSurfaces& surfaces;
  const ModelChoice& model;
  double mirror; ///< 1 for the left wheel, -1 for the right one

  /// With a load on the normal pressures.
  [[nodiscard]] WheelSolution solve(const SideEquilibrium& equilibrium, double load,
                                    NormalSolver& solver) const {
    const WheelRequest request = request_of(scene, load);
    return model.approximate && scene.until == Module::mechanics
               ? solve_wheel_approximately(*surfaces.wheel, *surfaces.rail, equilibrium, request,
                                           *model.approximate)
               : solve_wheel(*surfaces.wheel, *surfaces.rail, equilibrium, request, solver);
  }

  /// Replaces a result under another load, whose cost counts, too.
  void take(WheelSolution solution, const SideEquilibrium& equilibrium, StageMilliseconds& time,
            std::optional<SceneWheel>& wheel) const {
    time.remesh += 1e3 * solution.times.remesh;
    time.mechanics += 1e3 * solution.times.mechanics;
    WheelResult result =
        make_wheel_result(std::move(solution), surfaces.wheel, surfaces.rail, equilibrium, mirror);
    result.model = model.name;
    result.model_reason = model.reason;
    if (wheel) {
      result.iterations += wheel->iterations;
      result.convolutions += wheel->convolutions;
      result.solutions += wheel->solutions;
    }
    wheel.emplace(std::move(result));
  }
};

/// Wheels whose normal contact is solved and that have creep forces.
std::vector<DrivenWheel> driven_wheels(const Scene& scene, SceneResult& result) {
  std::vector<DrivenWheel> wheels;
  for (const auto& [wheel, side] :
       {std::pair(&result.left, &scene.left), {&result.right, &scene.right}}) {
    const CreepRequest request = creep_request_of(scene, *side);
    if (*wheel && (*wheel)->solved && request.model != CreepModel::none) {
      wheels.push_back({&**wheel, request});
    }
  }
  return wheels;
}

/// With derivatives by positions, if they are requested.
void solve_creep_forces_of(SceneWheel& wheel, const CreepRequest& request, RollingSolver& solver) {
  solve_creep_forces(wheel, request, solver, request.derivatives ? wheel.sensitivities() : nullptr);
}

/// Creep forces under the loads of now, of those wheels that these are new to.
void solve_creep_forces_of(const Scene& scene, const WheelLoads& loads, RollingSolver& solver,
                           SceneResult& result) {
  const Stopwatch watch;
  std::vector<DrivenWheel> wheels = driven_wheels(scene, result);
  if (wheels.empty()) {
    return;
  }
  const bool moving = wheels.front().request.motion.has_value();
  if (moving && scene.pitch_is_free) {
    const FreePitch found = solve_free_pitch(wheels, scene.torque, solver);
    result.pitch = found.rate;
    result.pitch_is_saturated = found.saturated;
    result.pitch_is_ambiguous = found.ambiguous;
  } else {
    if (moving) {
      result.pitch = scene.motion->pitch.value_or(scene.motion->speed / scene.nominal_radius());
    }
    for (DrivenWheel& driven : wheels) {
      if (moving) {
        driven.request.motion->pitch = result.pitch;
      }
      driven.request.derivatives = scene.derivatives && !loads.are_sought();
      const bool left = driven.wheel->details.mirror > 0.0;
      if (loads.is_open(left ? 0 : 1)) {
        solve_creep_forces_of(left ? *result.left : *result.right, driven.request, solver);
      }
    }
  }
  result.time.rolling += watch.milliseconds();
}

/// The displacement of one patch by another is interpolated; boxes nearly in touch spoil that.
void warn_of_residuals(SceneWheel& wheel, double accuracy) {
  if (!wheel.details.interaction || wheel.patches.empty()) {
    return;
  }
  const Residuals& residuals = wheel.residuals();
  const double worst = std::max(-residuals.least_gap, residuals.complementarity);
  if (worst > accuracy) {
    wheel.warnings.push_back(
        {WarningClass::close_patches,
         "patches almost touch: the displacement that they cause in each other is off by " +
             short_text_of(worst) + " of the largest displacement, more than the accuracy of " +
             text_of(accuracy),
         worst / accuracy});
  }
}

void warn_of_pitch(const Scene& scene, const SceneResult& result, WheelResult& wheel) {
  if (result.pitch_is_saturated) {
    wheel.warnings.push_back({WarningClass::torque_exceeded,
                              "motion.torque = " + text_of(scene.torque) +
                                  " N mm: more than friction can transmit; the wheels slide"});
  }
  if (result.pitch_is_ambiguous) {
    wheel.warnings.push_back(
        {WarningClass::torque_ambiguous,
         "friction falls with slip: another pitch rate, with more slip, also balances the "
         "torque; this is the one with the least slip"});
  }
}

/// What a wheel's result lacks once its load and the pitch rate are found: make_wheel_result and
/// solve_creep_forces have filled in the rest. Each act reads what those before it have written.
void complete_wheel(const Scene& scene, const WheelLoads& loads, RollingSolver& solver,
                    SceneResult& result, SceneWheel& wheel) {
  wheel.steels = text_of(scene.wheel_steel, scene.rail_steel);
  warn_of_residuals(wheel, scene.accuracy);
  if (!wheel.solved) {
    return;
  }
  const SceneSide& side = wheel.details.mirror > 0.0 ? scene.left : scene.right;
  CreepRequest creep = creep_request_of(scene, side);
  Stopwatch watch;
  if (creep.model != CreepModel::none) {
    if (creep.motion) {
      creep.motion->pitch = result.pitch;
    }
    // Left out while loads or a pitch rate were searched.
    if (creep.derivatives && (loads.are_sought() || (creep.motion && scene.pitch_is_free))) {
      solve_creep_forces_of(wheel, creep, solver);
    }
    warn_of_creep_forces(wheel, creep);
    warn_of_pitch(scene, result, wheel);
  }
  if (scene.kalker) {
    find_patch_coefficients(wheel, creep_options_of(scene, side), solver);
  }
  const bool rolls = creep.model != CreepModel::none || scene.kalker;
  result.time.rolling += rolls ? watch.milliseconds() : 0.0;
  watch = {};
  wheel.total = total_force(wheel);
  add_up_forces(wheel);
  wheel.state = wheel_state(wheel);
  warn_of_pressure(wheel);
  if (scene.damage.any()) {
    find_damage(wheel, damage_request_of(scene));
    result.time.damage += watch.milliseconds();
  }
}

/// With noisy profiles: what their spread needs, should it be requested.
void keep_noise(const Scene& scene, const SceneSurfaces& surfaces, SceneResult& result) {
  const bool left = result.left.has_value();
  const bool right = result.right.has_value();
  if ((left && (surfaces.left.wheel_doubt.valid() || surfaces.left.rail_doubt.valid())) ||
      (right && (surfaces.right.wheel_doubt.valid() || surfaces.right.rail_doubt.valid()))) {
    result.noise.emplace(NoisyScene{scene, surfaces.left.wheel_doubt, surfaces.left.rail_doubt,
                                    surfaces.right.wheel_doubt, surfaces.right.rail_doubt});
  }
}

double longest_contact(const SceneResult& result) {
  double longest = 0.0;
  for (const std::optional<SceneWheel>* wheel : {&result.left, &result.right}) {
    for (std::size_t i = 0; *wheel && i < (*wheel)->patches.size(); ++i) {
      longest = std::max(longest, 2.0 * (*wheel)->patches[i].semi_axis_longitudinal);
    }
  }
  return longest;
}

/// What all contact forces of the wheels carry.
WheelNumbers totals_of(const SceneResult& result) {
  WheelNumbers totals{};
  for (std::size_t i = 0; i < totals.size(); ++i) {
    const std::optional<SceneWheel>& wheel = i == 0 ? result.left : result.right;
    totals[i] = wheel && wheel->solved ? total_force(*wheel).force.z : 0.0;
  }
  return totals;
}

} // namespace

/// Kept, and shared between threads.
struct SceneSolver::Shared {
  std::shared_ptr<SurfaceCache> surfaces = std::make_shared<SurfaceCache>();
  LinePlans estimated;
  LinePlans measured{PlannerRigor::measure};
};

struct SceneSolver::State {
  std::shared_ptr<Shared> shared = std::make_shared<Shared>();
  std::optional<NormalSolver> left;
  std::optional<NormalSolver> right;
  std::optional<RollingSolver> rolling;
  SolverOptions options;

  void prepare_solvers();
  void solve_wheels(const Scene& scene, const SceneSurfaces& surfaces, const ModelChoice& model,
                    const WheelsetEquilibrium& equilibrium, const WheelLoads& loads,
                    SceneResult& result);
  void solve_contact(const Scene& scene, const SceneSurfaces& surfaces, const ModelChoice& model,
                     const WheelsetEquilibrium& equilibrium, SceneResult& result);
  void find_steady_errors(const Scene& scene, const SceneSurfaces& surfaces, SceneResult& result);
  SceneResult solve(const Scene& scene);
};

void SceneSolver::State::prepare_solvers() {
  if (rolling) {
    return;
  }
  const std::shared_ptr<LinePlans> plans(
      shared, options.planner == PlannerRigor::measure ? &shared->measured : &shared->estimated);
  left.emplace(plans, options.precision);
  right.emplace(plans, options.precision);
  rolling.emplace(plans);
}

/// Normal contact of those wheels whose load is new: the right one on a thread of its own, if there
/// is one for it.
void SceneSolver::State::solve_wheels(const Scene& scene, const SceneSurfaces& surfaces,
                                      const ModelChoice& model,
                                      const WheelsetEquilibrium& equilibrium,
                                      const WheelLoads& loads, SceneResult& result) {
  const WheelTask left_task{scene, scene.left, surfaces.left, model, 1.0};
  const WheelTask right_task{scene, scene.right, surfaces.right, model, -1.0};
  std::future<WheelSolution> other;
  if (loads.is_open(1)) {
    const bool beside = scene.threads > 1 && loads.is_open(0);
    other = std::async(beside ? std::launch::async : std::launch::deferred,
                       [&] { return right_task.solve(*equilibrium.right, loads.load(1), *right); });
  }
  if (loads.is_open(0)) {
    left_task.take(left_task.solve(*equilibrium.left, loads.load(0), *left), *equilibrium.left,
                   result.time, result.left);
  }
  if (loads.is_open(1)) {
    right_task.take(other.get(), *equilibrium.right, result.time, result.right);
  }
}

/// Normal contact and creep forces under the given or unknown loads, and results derived from them.
void SceneSolver::State::solve_contact(const Scene& scene, const SceneSurfaces& surfaces,
                                       const ModelChoice& model,
                                       const WheelsetEquilibrium& equilibrium,
                                       SceneResult& result) {
  WheelLoads loads(scene, equilibrium.left.has_value(), equilibrium.right.has_value());
  do {
    solve_wheels(scene, surfaces, model, equilibrium, loads, result);
    solve_creep_forces_of(scene, loads, *rolling, result);
    loads.take(totals_of(result));
  } while (loads.any_open());
  for (std::optional<SceneWheel>* wheel : {&result.left, &result.right}) {
    if (*wheel) {
      complete_wheel(scene, loads, *rolling, result, **wheel);
    }
  }
  if (result.left && result.right) {
    result.rolling_radius_difference =
        result.left->rigid_contact.rolling_radius - result.right->rigid_contact.rolling_radius;
  }
}

/// Of creep forces with derivatives, once everything else is found. Where profiles vary, forces are
/// solved a little behind on the path as well; where they cannot be, as before the first slice, the
/// error is known only of a wheel on profiles that do not vary.
void SceneSolver::State::find_steady_errors(const Scene& scene, const SceneSurfaces& surfaces,
                                            SceneResult& result) {
  if (!scene.steady_errors || !scene.derivatives || !scene.motion || scene.motion->speed == 0.0 ||
      scene.history) {
    return;
  }
  std::optional<SceneResult> behind;
  const std::array<bool, 2> is_prismatic{surfaces.left.pair().is_prismatic_along(along_track),
                                         surfaces.right.pair().is_prismatic_along(along_track)};
  const double distance =
      is_prismatic[0] && is_prismatic[1] ? 0.0 : path_step * longest_contact(result);
  if (distance > 0.0) {
    Scene before = scene;
    before.derivatives = false;
    before.damage = {};
    before.along -= std::copysign(distance, scene.motion->speed);
    before.pitch -= result.pitch.value_or(0.0) * distance / std::abs(scene.motion->speed);
    try {
      behind = solve(before);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::out_of_memory) {
        throw;
      }
    }
  }
  for (const bool side : {false, true}) {
    std::optional<SceneWheel> SceneResult::*const member =
        side ? &SceneResult::right : &SceneResult::left;
    std::optional<SceneWheel>& wheel = result.*member;
    const WheelRates* const rates = wheel && wheel->solved ? wheel->sensitivities() : nullptr;
    if (rates == nullptr || (distance > 0.0 && !behind && !is_prismatic[side])) {
      continue;
    }
    const std::optional<SceneWheel>* other = behind ? &((*behind).*member) : nullptr;
    wrc::find_steady_errors(
        *wheel, *rates,
        other != nullptr && *other ? std::optional(WheelBehind{**other, distance}) : std::nullopt);
    warn_of_steady_forces(*wheel, scene.accuracy);
  }
}

SceneResult SceneSolver::State::solve(const Scene& scene) {
  const Stopwatch total;
  SceneResult result;
  const ModelChoice model = choose_model(scene);
  const SceneSurfaces surfaces = shared->surfaces->get(scene);
  prepare_solvers();
  result.key_warnings = KeyWarnings(scene);
  result.corrections = surfaces.corrections;
  result.profile_warnings = surfaces.warnings;
  result.time.profile = surfaces.profile_milliseconds;
  result.time.setup = total.milliseconds() - result.time.profile;

  const Stopwatch geometry;
  const WheelsetEquilibrium equilibrium =
      find_equilibrium(surfaces.left.pair(), surfaces.right.pair(), equilibrium_request_of(scene));
  result.roll = equilibrium.roll;
  result.vertical = equilibrium.vertical;
  result.time.geometry = geometry.milliseconds();

  result.model = model.name;
  result.solver = scene.solver;
  solve_contact(scene, surfaces, model, equilibrium, result);
  find_steady_errors(scene, surfaces, result);
  keep_noise(scene, surfaces, result);
  result.time.total = total.milliseconds();
  return result;
}

SceneSolver::SceneSolver() : state_(new State) {}
SceneSolver::SceneSolver(std::shared_ptr<SurfaceCache> surfaces) : SceneSolver() {
  state_->shared->surfaces = std::move(surfaces);
}
SceneSolver::~SceneSolver() = default;
SceneSolver::SceneSolver(SceneSolver&&) noexcept = default;
SceneSolver& SceneSolver::operator=(SceneSolver&&) noexcept = default;

SceneResult SceneSolver::solve(const Scene& scene) {
  try {
    return state_->solve(scene);
  } catch (const Error& error) {
    const std::string text = error.what();
    if (scene.convention == Convention{} || text.find(" mm") == std::string::npos) {
      throw;
    }
    throw Error(error.code(), text + " (in mm, N, MPa, y left, z up)");
  }
}

CreepResult SceneSolver::solve_creep(const Scene& scene, const WheelResult& wheel,
                                     const PatchResult& patch, const Creepages& creepages,
                                     bool derivatives) {
  CreepRequest request =
      creep_options_of(scene, wheel.details.mirror > 0.0 ? scene.left : scene.right);
  request.creepages = creepages;
  request.speed = scene.motion ? std::abs(scene.motion->speed) : 0.0;
  request.derivatives = derivatives;
  state_->prepare_solvers();
  std::vector<CreepResult> parts;
  return creep_of_patch(wheel, patch, request, *state_->rolling, parts);
}

void SceneSolver::set_options(const SolverOptions& options) {
  state_->options = options;
  state_->rolling.reset(); // and with it the others
}

void SceneSolver::forget() {
  SceneSolver fresh;
  fresh.set_options(state_->options);
  *this = std::move(fresh);
}

SceneSolver SceneSolver::beside() const {
  SceneSolver other;
  other.set_options(state_->options);
  other.state_->shared = state_->shared;
  return other;
}

SceneResult solve_scene(const Scene& scene, const SolverOptions& options) {
  SceneSolver solver;
  solver.set_options(options);
  return solver.solve(scene);
}

} // namespace wrc
