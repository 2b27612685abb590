/// What the benchmark prints: one JSON object, or tables with a legend.
#pragma once

#include <optional>
#include <vector>

#include "wrc_benchmark/motion_cases.hpp"
#include "wrc_benchmark/row.hpp"
#include "wrc_benchmark/service_case.hpp"

namespace benchmark {

struct Report {
  std::vector<Row> rows; ///< of all cases but service
  std::vector<ServiceRow> service;
  std::optional<Batch> batch; ///< its rows are among those above
};

void print_json(const Report& report);
void print_tables(const Report& report);

} // namespace benchmark
