#include "pressure/pressure_runs.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace wrc {

void check_pressure_size(const Grid& grid, std::span<const double> pressure) {
  if (pressure.size() != grid.element_count()) {
    throw_invalid_argument("pressure.size", static_cast<double>(pressure.size()),
                           "must be the grid's " + std::to_string(grid.element_count()) +
                               " elements");
  }
}

std::vector<Run> find_runs(const Grid& grid, std::span<const double> pressure) {
  std::vector<Run> runs;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double* values = pressure.data() + row * grid.longitudinal_count;
    std::size_t column = 0;
    while (column < grid.longitudinal_count) {
      if (!(values[column] > 0.0)) {
        ++column;
        continue;
      }
      const std::size_t first = column;
      while (column < grid.longitudinal_count && values[column] > 0.0) {
        ++column;
      }
      runs.push_back({row, first, column, runs.size()});
    }
  }
  return runs;
}

std::size_t root_of_run(std::vector<Run>& runs, std::size_t run) {
  while (runs[run].region != run) {
    runs[run].region = runs[runs[run].region].region;
    run = runs[run].region;
  }
  return run;
}

void join_neighbours(std::vector<Run>& runs) {
  std::size_t above = 0;
  for (std::size_t below = 0; below < runs.size(); ++below) {
    while (runs[above].row + 1 < runs[below].row ||
           (runs[above].row + 1 == runs[below].row && runs[above].last < runs[below].first)) {
      ++above;
    }
    for (std::size_t run = above;
         runs[run].row + 1 == runs[below].row && runs[run].first <= runs[below].last; ++run) {
      const std::size_t one = root_of_run(runs, run);
      const std::size_t other = root_of_run(runs, below);
      runs[std::max(one, other)].region = std::min(one, other);
    }
  }
}

} // namespace wrc
