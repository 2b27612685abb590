#include <array>
#include <optional>

#include "batch.hpp"
#include "grid_contact.hpp"

namespace {

constexpr auto solver_text_keys = std::to_array<wrc::TextKey<wrc::SolverOptions>>(
    {{"planner", wrc::set_planner}, {"precision", wrc::set_precision}});

} // namespace

extern "C" {

wrc_status wrc_solver_create(wrc_solver** solver) {
  return wrc::create(solver);
}

void wrc_solver_destroy(wrc_solver* solver) {
  wrc::destroy(solver);
}

const char* wrc_solver_error(const wrc_solver* solver) {
  return wrc::error_of(solver);
}

wrc_status wrc_solver_set_text(wrc_solver* solver, const char* key, const char* value) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    wrc::entry_in(solver_text_keys, "text", "solver", key).set(object.options, key, value);
    object.solver.set_options(object.options);
    return WRC_OK;
  });
}

wrc_status wrc_solver_solve(wrc_solver* solver, wrc_scene* scene) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    return wrc::with_scene(object, scene, [&](wrc::SceneObject& posed) {
      return posed.take_result(object.solver.solve(posed.scene));
    });
  });
}

wrc_status wrc_solver_clear(wrc_solver* solver) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    object.solver.forget();
    return WRC_OK;
  });
}

wrc_status wrc_solve_batch(wrc_scene* const* scenes, int64_t count, int32_t threads,
                           wrc_status* statuses) {
  if (!wrc::is_permitted_batch(count, threads) || (count > 0 && scenes == nullptr)) {
    return WRC_INVALID_ARGUMENT;
  }
  try {
    wrc::HandlesInUse<wrc_scene> taken;
    std::string error;
    if (const wrc_status status = wrc::take_all("scenes", scenes, count, taken, error);
        status != WRC_OK) {
      taken.clear();
      return wrc::refuse_batch(scenes, count, statuses, status, error);
    }
    const wrc::SceneSolver shared;
    return wrc::run_all(taken.size(), threads, statuses, [&] {
      return [&, solver = std::optional<wrc::SceneSolver>()](std::size_t i) mutable {
        wrc::SceneObject& scene = taken[i]->object();
        return wrc::run(scene, [&] {
          if (!solver) { // made under the guard
            solver.emplace(shared.beside());
          }
          return scene.take_result(solver->solve(scene.scene));
        });
      };
    });
  } catch (...) {
    return WRC_OUT_OF_MEMORY;
  }
}
}
