#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

#include "handles.hpp"

namespace {

constexpr int32_t most_threads = 1024;
constexpr int64_t most_scenes = int64_t{1} << 24;
using SceneInUse = std::unique_ptr<wrc::InUse<wrc::SceneObject>>;

/// All scenes of a batch, or the status that says why they are not available.
wrc_status take_all(wrc_scene* const* scenes, int64_t count, std::vector<SceneInUse>& taken) {
  std::vector<wrc_scene*> ordered(scenes, scenes + count);
  std::sort(ordered.begin(), ordered.end());
  if (std::adjacent_find(ordered.begin(), ordered.end()) != ordered.end()) {
    return WRC_INVALID_ARGUMENT;
  }
  for (int64_t i = 0; i < count; ++i) {
    const auto& scene =
        taken.emplace_back(new wrc::InUse<wrc::SceneObject>(wrc::entry_of(scenes[i])));
    if (!scene->held()) {
      return scene->exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
  }
  return WRC_OK;
}

/// Solves scenes as long as there are any; each by itself.
void solve_waiting(const std::vector<SceneInUse>& scenes, std::atomic<std::size_t>& next,
                   const wrc::SceneSolver& shared, wrc_status* statuses) noexcept {
  std::optional<wrc::SceneSolver> solver; // made under the guard
  for (std::size_t i = next.fetch_add(1); i < scenes.size(); i = next.fetch_add(1)) {
    wrc::SceneObject& scene = scenes[i]->object();
    statuses[i] = wrc::run(scene, [&] {
      if (!solver) {
        solver.emplace(shared.beside());
      }
      return scene.take_result(solver->solve(scene.scene));
    });
  }
}

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

wrc_status wrc_solver_solve(wrc_solver* solver, wrc_scene* scene) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    wrc::require_pointer(scene, "scene");
    const auto posed = wrc::use(scene);
    if (!posed.held()) {
      object.error = std::string("scene: ") + wrc::reason_of(posed);
      return posed.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    return wrc::run(posed.object(), [&] {
      return posed.object().take_result(object.solver.solve(posed.object().scene));
    });
  });
}

wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    if (profiles != 0) {
      object.solver.forget();
    }
    return WRC_OK;
  });
}

wrc_status wrc_solve_batch(wrc_scene* const* scenes, int64_t count, int32_t threads,
                           wrc_status* statuses) {
  if (count < 0 || count > most_scenes || threads < 1 || threads > most_threads ||
      (count > 0 && scenes == nullptr)) {
    return WRC_INVALID_ARGUMENT;
  }
  try {
    std::vector<SceneInUse> taken;
    if (const wrc_status status = take_all(scenes, count, taken); status != WRC_OK) {
      return status;
    }
    const wrc::DefaultFloatingPoint floating_point; // for the threads too
    std::vector<wrc_status> own(statuses == nullptr ? static_cast<std::size_t>(count) : 0);
    wrc_status* results = statuses == nullptr ? own.data() : statuses;
    std::atomic<std::size_t> next{0};
    const wrc::SceneSolver shared;
    std::vector<std::thread> others;
    const auto most = std::min<int64_t>(threads, count);
    others.reserve(static_cast<std::size_t>(std::max<int64_t>(most, 1)));
    try {
      for (int64_t i = 1; i < most; ++i) {
        others.emplace_back(solve_waiting, std::cref(taken), std::ref(next), std::cref(shared),
                            results);
      }
    } catch (...) {
      // Fewer threads than requested: the same results, later.
    }
    solve_waiting(taken, next, shared, results);
    for (std::thread& other : others) {
      other.join();
    }
    const auto* failed =
        std::find_if(results, results + count, [](wrc_status status) { return status != WRC_OK; });
    return failed == results + count ? WRC_OK : *failed;
  } catch (...) {
    return WRC_OUT_OF_MEMORY;
  }
}
}
