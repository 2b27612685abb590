#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

#include "handles.hpp"

namespace {

constexpr int32_t most_threads = 1024;

/// Solves scenes as long as there are any; each by itself.
void solve_waiting(wrc_scene* const* scenes, int64_t count, std::atomic<int64_t>& next,
                   wrc_status* statuses) noexcept {
  std::optional<wrc::SceneSolver> solver; // made under the guard
  for (int64_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) {
    wrc_scene* scene = scenes[i];
    statuses[i] = wrc::guard(scene, [&] {
      if (!solver) {
        solver.emplace();
      }
      solver->forget_positions();
      return scene->take_result(solver->solve(scene->scene));
    });
  }
}

} // namespace

extern "C" {

wrc_status wrc_solver_create(wrc_solver** solver) {
  return wrc::create(solver);
}

void wrc_solver_destroy(wrc_solver* solver) {
  delete solver;
}

const char* wrc_solver_error(const wrc_solver* solver) {
  return solver == nullptr ? "solver = NULL: a handle must be given" : solver->error.c_str();
}

wrc_status wrc_solver_solve(wrc_solver* solver, wrc_scene* scene) {
  return wrc::guard(solver, [&] {
    wrc::require_pointer(scene, "scene");
    return wrc::guard(scene,
                      [&] { return scene->take_result(solver->solver.solve(scene->scene)); });
  });
}

wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles) {
  return wrc::guard(solver, [&] {
    if (profiles != 0) {
      solver->solver.forget();
    } else {
      solver->solver.forget_positions();
    }
    return WRC_OK;
  });
}

wrc_status wrc_solve_batch(wrc_scene* const* scenes, int64_t count, int32_t threads,
                           wrc_status* statuses) {
  if (count < 0 || threads < 1 || threads > most_threads || (count > 0 && scenes == nullptr)) {
    return WRC_INVALID_ARGUMENT;
  }
  try {
    std::vector<wrc_scene*> ordered(scenes, scenes + count);
    std::sort(ordered.begin(), ordered.end());
    if (std::adjacent_find(ordered.begin(), ordered.end()) != ordered.end() ||
        (count > 0 && ordered.front() == nullptr)) {
      return WRC_INVALID_ARGUMENT;
    }
    std::vector<wrc_status> own(statuses == nullptr ? static_cast<std::size_t>(count) : 0);
    wrc_status* results = statuses == nullptr ? own.data() : statuses;
    std::atomic<int64_t> next{0};
    std::vector<std::thread> others;
    const auto most = std::min<int64_t>(threads, count);
    others.reserve(static_cast<std::size_t>(std::max<int64_t>(most, 1)));
    try {
      for (int64_t i = 1; i < most; ++i) {
        others.emplace_back(solve_waiting, scenes, count, std::ref(next), results);
      }
    } catch (...) {
      // Fewer threads than asked for: the same results, later.
    }
    solve_waiting(scenes, count, next, results);
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
