#include "wrc_sweep/scene_solver.hpp"

#include <limits>

#include "wrc_sweep/result_names.hpp"

namespace driver {

Row SceneSolver::solve(std::int64_t index) {
  Row row;
  row.scene = index;
  try {
    study_.apply(index, scene_);
  } catch (const Failure& failure) {
    row.status = WRC_INVALID_ARGUMENT;
    row.message = failure.what();
  }
  if (row.status == WRC_OK) {
    row.status = solver_.solve_alone(scene_);
    if (row.status != WRC_OK) {
      row.message = scene_.error();
    }
  }
  if (row.status == WRC_OK || row.status == WRC_NOT_CONVERGED) {
    read_results(row);
  } else {
    row.values.assign(study_.results.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return row;
}

void SceneSolver::read_results(Row& row) const {
  for (const std::string& name : study_.results) {
    row.values.push_back(result_of(scene_, name));
  }
  if (study_.fields.empty()) {
    return;
  }
  for (std::size_t side = 0; side < side_names.size(); ++side) {
    for (std::int32_t index = 0;; ++index) {
      const std::string prefix =
          std::string(side_names[side]) + ".patches." + std::to_string(index) + '.';
      if (!scene_.has_number(prefix + "grid.0")) {
        break;
      }
      PatchFields& patch = row.patches.emplace_back();
      patch.side = static_cast<std::int32_t>(side);
      patch.index = index;
      patch.rows = static_cast<std::int64_t>(scene_.number(prefix + "grid.0"));
      patch.columns = static_cast<std::int64_t>(scene_.number(prefix + "grid.1"));
      for (const std::string& field : study_.fields) {
        patch.values.push_back(scene_.field(prefix + field));
      }
    }
  }
}

} // namespace driver
