#include "scene/solve_scene.hpp"

#include <algorithm>
#include <future>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "scene/model_choice.hpp"
#include "scene/surface_cache.hpp"

namespace wrc {
namespace {

WheelRequest request_of(const Scene& scene, double load) {
  WheelRequest request;
  static_cast<WheelOptions&>(request) = scene;
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  if (scene.vertical) {
    request.vertical = scene.vertical;
  } else if (scene.normal_load) {
    request.normal_load = scene.normal_load;
  } else {
    request.vertical_load = load;
  }
  const CreepModel creep = scene.creep.value_or(CreepModel::full);
  request.creep_forces = (scene.left_creepages || scene.right_creepages || scene.motion) &&
                         (creep == CreepModel::full || creep == CreepModel::fastsim_strips);
  request.elements = scene.elements.value_or(
      scene.solver == SolverChoice::paper ? Elements::constant : Elements::smooth);
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

/// `mirror`: 1 for the left wheel, -1 for the right one.
CreepRequest creep_request_of(const Scene& scene, double mirror) {
  const bool left = mirror > 0.0;
  const auto& creepages = left ? scene.left_creepages : scene.right_creepages;
  CreepRequest request;
  const bool given = scene.left_creepages || scene.right_creepages;
  if (given ? !creepages : !scene.motion) {
    return request;
  }
  request.model = scene.creep.value_or(CreepModel::full);
  if (given) {
    request.creepages = *creepages;
    request.speed = scene.motion ? std::abs(scene.motion->speed) : 0.0;
  } else {
    request.motion = scene.motion;
    request.nominal_radius = scene.wheelset.radius;
  }
  request.friction = left ? scene.left_friction : scene.right_friction;
  request.accuracy = scene.accuracy;
  request.material = shear_constants(scene.wheel_material, scene.rail_material);
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  return request;
}

/// The displacement of one patch by another is interpolated; boxes nearly in touch spoil that.
void warn_of_residuals(WheelResult& wheel, double accuracy) {
  if (!wheel.details.interaction || wheel.patches.empty()) {
    return;
  }
  const Residuals& residuals = residuals_of(wheel);
  const double worst = std::max(-residuals.least_gap, residuals.complementarity);
  if (worst > accuracy) {
    wheel.warnings.push_back(
        "patches nearly in touch: the displacement they cause at each other is off by " +
        short_text_of(worst) + " of the largest displacement, more than the accuracy of " +
        text_of(accuracy));
  }
}

/// A scene with what is the same for both wheels.
struct SceneTask {
  const Scene& scene;
  const SceneSurfaces& surfaces;
  const ModelChoice& model;

  [[nodiscard]] WheelSolution solve(const SideEquilibrium& side, double load,
                                    NormalSolver& solver) const {
    const WheelRequest request = request_of(scene, load);
    return model.approximate && scene.until == Module::mechanics
               ? solve_wheel_approximately(*surfaces.wheel, *surfaces.rail, side, request,
                                           *model.approximate)
               : solve_wheel(*surfaces.wheel, *surfaces.rail, side, request, solver);
  }

  /// `mirror`: 1 for the left wheel, -1 for the right one.
  [[nodiscard]] WheelResult complete(WheelSolution solution, const SideEquilibrium& side,
                                     double mirror, RollingSolver& rolling,
                                     StageMilliseconds& time) const {
    time.remesh += 1e3 * solution.times.remesh;
    time.mechanics += 1e3 * solution.times.mechanics;
    WheelResult result =
        make_wheel_result(std::move(solution), surfaces.wheel, surfaces.rail, side, mirror);
    result.model = model.name;
    result.model_reason = model.reason;
    warn_of_residuals(result, scene.accuracy);
    const CreepRequest creep = creep_request_of(scene, mirror);
    if (creep.model != CreepModel::none && result.solved) {
      const Stopwatch watch;
      solve_creep_forces(result, creep, rolling);
      time.rolling += watch.milliseconds();
    }
    return result;
  }
};

} // namespace

/// Kept, and shared between threads.
struct SceneSolver::Shared {
  SurfaceCache surfaces;
  LinePlans estimated;
  LinePlans measured{PlannerRigor::measure};
};

struct SceneSolver::State {
  std::shared_ptr<Shared> shared = std::make_shared<Shared>();
  std::optional<NormalSolver> left;
  std::optional<NormalSolver> right;
  std::optional<RollingSolver> rolling;
  PlannerRigor planner = PlannerRigor::estimate; ///< of the solvers
  Precision precision = Precision::mixed;

  void prepare_solvers(const Scene& scene);
  void solve_wheels(const SceneTask& task, const WheelsetEquilibrium& equilibrium,
                    SceneResult& result);
  SceneResult solve(const Scene& scene);
};

void SceneSolver::State::prepare_solvers(const Scene& scene) {
  const bool others = planner != scene.planner || precision != scene.precision;
  LinePlans* plans =
      scene.planner == PlannerRigor::measure ? &shared->measured : &shared->estimated;
  for (std::optional<NormalSolver>* solver : {&left, &right}) {
    if (others || !*solver) {
      solver->emplace(std::shared_ptr<LinePlans>(shared, plans), scene.precision);
    }
  }
  if (others || !rolling) {
    rolling.emplace(std::shared_ptr<LinePlans>(shared, plans));
  }
  planner = scene.planner;
  precision = scene.precision;
}

/// The right wheel on a thread of its own, if there is one for it.
void SceneSolver::State::solve_wheels(const SceneTask& task, const WheelsetEquilibrium& equilibrium,
                                      SceneResult& result) {
  std::future<WheelSolution> other;
  if (equilibrium.right) {
    const bool beside = task.scene.threads > 1 && equilibrium.left;
    other = std::async(beside ? std::launch::async : std::launch::deferred, [&] {
      return task.solve(*equilibrium.right, task.scene.right_load, *right);
    });
  }
  if (equilibrium.left) {
    result.left = task.complete(task.solve(*equilibrium.left, task.scene.left_load, *left),
                                *equilibrium.left, 1.0, *rolling, result.time);
  }
  if (equilibrium.right) {
    result.right = task.complete(other.get(), *equilibrium.right, -1.0, *rolling, result.time);
  }
  if (result.left && result.right) {
    result.rolling_radius_difference =
        result.left->rigid_contact.rolling_radius - result.right->rigid_contact.rolling_radius;
  }
}

SceneResult SceneSolver::State::solve(const Scene& scene) {
  const Stopwatch total;
  SceneResult result;
  const SceneSurfaces surfaces = shared->surfaces.get(scene);
  prepare_solvers(scene);
  result.corrections = surfaces.corrections;
  result.time.profile = surfaces.profile_milliseconds;
  result.time.setup = total.milliseconds() - result.time.profile;

  const Stopwatch geometry;
  const WheelsetEquilibrium equilibrium =
      find_equilibrium(*surfaces.wheel, *surfaces.rail, equilibrium_request_of(scene));
  result.roll = equilibrium.roll;
  result.vertical = equilibrium.vertical;
  result.time.geometry = geometry.milliseconds();

  const ModelChoice model = choose_model(scene);
  result.model = model.name;
  result.solver = scene.solver;
  solve_wheels({scene, surfaces, model}, equilibrium, result);
  result.time.total = total.milliseconds();
  return result;
}

SceneSolver::SceneSolver() : state_(new State) {}
SceneSolver::~SceneSolver() = default;
SceneSolver::SceneSolver(SceneSolver&&) noexcept = default;
SceneSolver& SceneSolver::operator=(SceneSolver&&) noexcept = default;

SceneResult SceneSolver::solve(const Scene& scene) {
  return state_->solve(scene);
}

void SceneSolver::forget() {
  *this = SceneSolver();
}

SceneSolver SceneSolver::beside() const {
  SceneSolver other;
  other.state_->shared = state_->shared;
  return other;
}

SceneResult solve_scene(const Scene& scene) {
  return SceneSolver().solve(scene);
}

} // namespace wrc
