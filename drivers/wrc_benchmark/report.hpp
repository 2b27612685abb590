/// What the benchmark prints: one JSON object, or tables with a legend.
#pragma once

#include <optional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "wrc_benchmark/motion_cases.hpp"
#include "wrc_benchmark/problem.hpp"
#include "wrc_benchmark/rolling_case.hpp"

namespace benchmark {

struct Report {
  std::vector<Row> rows; ///< of all cases but service
  std::vector<ServiceRow> service;
  std::vector<RollingRow> rolling;
  std::optional<Batch> batch; ///< its rows are among those above
};

nlohmann::json json_of(const Report& report);
void print_tables(const Report& report);

} // namespace benchmark
