/// Elements with pressure, row by row, and which of them belong together.
///
/// A run is a stretch of a row with p > 0 throughout. Runs of neighbouring rows that touch by an
/// edge or a corner (8-neighbours) belong to one region; its first run stands for it.
/// Order of elements: that of base/grid.hpp. Thread rule: pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

/// Elements of a row under pressure without interruption; `last` is the one after them.
struct Run {
  std::size_t row;
  std::size_t first;
  std::size_t last;
  std::size_t region; ///< index of a run before it in the same region, or its own
};

/// All runs, row by row; each a region of its own at first.
std::vector<Run> find_runs(const Grid& grid, std::span<const double> pressure);

/// Joins runs of neighbouring rows that touch by an edge or a corner.
void join_neighbours(std::vector<Run>& runs);

/// The run that stands for a region, with the way to it shortened.
std::size_t root_of_run(std::vector<Run>& runs, std::size_t run);

/// Throws Error(invalid_argument) for a pressure span of another size than the grid.
void check_pressure_size(const Grid& grid, std::span<const double> pressure);

} // namespace wrc
