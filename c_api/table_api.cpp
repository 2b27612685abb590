#include "batch.hpp"
#include "scene/table.hpp"

extern "C" {

wrc_status wrc_scene_tabulate(wrc_scene* scene, const char* keys, const double* values,
                              const int64_t* counts, const char* results, int32_t threads,
                              const char* path, double* table) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) -> wrc_status {
    wrc::require_pointer(keys, "keys");
    wrc::require_pointer(values, "values");
    wrc::require_pointer(counts, "counts");
    wrc::require_pointer(results, "results");
    if (threads < 1 || threads > wrc::max_threads) {
      wrc::throw_invalid_argument("threads", threads, "must be between 1 and 1024");
    }
    const bool to_file = path != nullptr && *path != '\0';
    if (!to_file) {
      wrc::require_pointer(table, "table");
    }
    const wrc::TableGrid grid(object.scene, keys, values, counts, results);
    std::vector<double> found(grid.cell_count() * grid.result_count());
    const wrc::SceneSolver shared;
    std::vector<std::string> errors(static_cast<std::size_t>(threads));
    std::atomic<std::size_t> next_worker{0};
    const wrc_status status = wrc::run_all(grid.cell_count(), threads, nullptr, [&] {
      std::string& error = errors[next_worker.fetch_add(1)];
      return
          [&, solver = std::optional<wrc::SceneSolver>()](std::size_t cell) mutable -> wrc_status {
            try {
              if (!solver) {
                solver.emplace(shared.beside());
              }
              grid.solve_cell(cell, *solver, found.data() + cell * grid.result_count());
              return WRC_OK;
            } catch (...) {
              return wrc::status_of_current_exception(error);
            }
          };
    });
    if (status != WRC_OK) {
      const auto reason = std::find_if(errors.begin(), errors.end(),
                                       [](const std::string& error) { return !error.empty(); });
      object.error = reason == errors.end() ? "" : *reason;
      return status;
    }
    if (to_file) {
      grid.write(path, wrc_version(), found);
    }
    if (table != nullptr) {
      std::copy(found.begin(), found.end(), table);
    }
    return WRC_OK;
  });
}

} // extern "C"
