/// What the stages of a table's making share: the table so far, its solvers, and the tasks that are
/// done.
///
/// Thread rule: `run_stage` starts threads of its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "scene/solve_scene.hpp"
#include "table/finished_tasks.hpp"
#include "table/table_nodes.hpp"
#include "table/table_options.hpp"

namespace wrc {

/// Stages whose tasks take long; a number that was once that of others is not used again.
enum class Stage : std::uint32_t { touch = 0, nodes = 1, fit = 9, map, factor, check };

/// Numbers between 0 and 1, the same everywhere for a seed.
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}
  double next() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  double between(double low, double high) { return low + (high - low) * next(); }

private:
  std::mt19937_64 engine_;
};

struct TableWork {
  const Scene& scene;
  const TableOptions& options;
  const SceneSolver& solver;
  ContactTable table;
  std::optional<FinishedTasks> finished;

  /// Not on the stack, which may be small.
  [[nodiscard]] std::unique_ptr<TableNodes> nodes() {
    return std::make_unique<TableNodes>(scene, solver.beside(), table);
  }

  [[nodiscard]] Progress part_of_progress(double from, double to) const {
    if (!options.progress) {
      return {};
    }
    return [this, from, to](double share) { options.progress(from + share * (to - from)); };
  }

  /// Tasks that each fill in an equal share of `numbers`; finished ones are not done again.
  template <class MakeWorker>
  void run_stage(Stage stage, std::size_t count, std::vector<double>& numbers,
                 const Progress& progress, const MakeWorker& make_worker) {
    const std::size_t share = numbers.size() / count;
    const auto of_stage = static_cast<std::uint32_t>(stage);
    run_tasks(count, options.threads, progress, [&] {
      return [&, work = make_worker()](std::size_t task) mutable {
        const std::span<double> own(numbers.data() + task * share, share);
        if (finished && finished->find(of_stage, task, own)) {
          return;
        }
        work(task, own.data());
        if (finished) {
          finished->add(of_stage, task, own);
        }
      };
    });
  }
};

/// Takes the noise out of linear creep forces along the lateral positions, then fits slopes and
/// forces of free rolling on the tread to those of the full theory (table_fit.cpp).
void fit_table(TableWork& work, const Progress& progress);

/// Fills in the map of errors and what held-out states say (table_errors.cpp).
void measure_table(TableWork& work, const Progress& progress);

} // namespace wrc
