/// How a table is made.
///
/// Thread rule: a plain value.
#pragma once

#include <filesystem>
#include <string>

#include "base/worker_threads.hpp"
#include "table/contact_table.hpp"

namespace wrc {

struct TableOptions {
  TableRanges ranges;
  /// Error over load beyond which the exact solution is asked where there is a solver; 0: never.
  double tolerance = 0.0;
  double fineness = 1.0; ///< of the nodes in each variable, 0.2 to 4
  int threads = 1;
  Progress progress; ///< with the finished fraction
  /// Keeps what is finished, so that a build that was stopped goes on; empty: none.
  std::filesystem::path resume_file;
  std::string version; ///< of the library: in the table, and whose unfinished files go on
};

} // namespace wrc
