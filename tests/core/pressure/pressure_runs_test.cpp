// Runs of elements under pressure and their regions, against a flood fill.
#include "pressure/pressure_runs.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace wrc::test::pressure_runs_test {
namespace {

Grid grid_of(std::size_t rows, std::size_t columns) {
  return {rows, columns, 1.0, 1.0, 0.0, 0.0};
}

/// Region of each element by spreading over all eight neighbours; 0: none.
std::vector<std::size_t> flooded(const Grid& grid, const std::vector<double>& pressure) {
  std::vector<std::size_t> region(pressure.size(), 0);
  std::size_t count = 0;
  for (std::size_t start = 0; start < pressure.size(); ++start) {
    if (!(pressure[start] > 0.0) || region[start] != 0) {
      continue;
    }
    ++count;
    std::vector<std::size_t> open{start};
    region[start] = count;
    while (!open.empty()) {
      const std::size_t here = open.back();
      open.pop_back();
      const std::size_t row = here / grid.longitudinal_count;
      const std::size_t column = here % grid.longitudinal_count;
      for (std::size_t i = row - std::min<std::size_t>(row, 1);
           i <= std::min(row + 1, grid.lateral_count - 1); ++i) {
        for (std::size_t j = column - std::min<std::size_t>(column, 1);
             j <= std::min(column + 1, grid.longitudinal_count - 1); ++j) {
          const std::size_t next = i * grid.longitudinal_count + j;
          if (pressure[next] > 0.0 && region[next] == 0) {
            region[next] = count;
            open.push_back(next);
          }
        }
      }
    }
  }
  return region;
}

TEST(PressureRuns, RunsEndWherePressureDoes) {
  const Grid grid = grid_of(2, 6);
  const std::vector<double> pressure{1.0, 2.0, 0.0, 0.0, 3.0, 4.0, //
                                     0.0, 0.0, 0.0, 5.0, 0.0, 0.0};
  const std::vector<wrc::Run> runs = find_runs(grid, pressure);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].first, 0U);
  EXPECT_EQ(runs[0].last, 2U);
  EXPECT_EQ(runs[1].first, 4U);
  EXPECT_EQ(runs[1].last, 6U);
  EXPECT_EQ(runs[2].row, 1U);
  EXPECT_EQ(runs[2].first, 3U);
  EXPECT_EQ(runs[2].last, 4U);
}

TEST(PressureRuns, CornersJoinAndGapsDoNot) {
  std::vector<wrc::Run> runs =
      find_runs(grid_of(2, 4), std::vector<double>{1, 1, 0, 0, 0, 0, 1, 1});
  join_neighbours(runs);
  EXPECT_EQ(root_of_run(runs, 0), root_of_run(runs, 1)) << "a corner";
  runs = find_runs(grid_of(2, 5), std::vector<double>{1, 1, 0, 0, 0, 0, 0, 0, 1, 1});
  join_neighbours(runs);
  EXPECT_NE(root_of_run(runs, 0), root_of_run(runs, 1)) << "an element between";
  runs = find_runs(grid_of(3, 2), std::vector<double>{1, 1, 0, 0, 1, 1});
  join_neighbours(runs);
  EXPECT_NE(root_of_run(runs, 0), root_of_run(runs, 1)) << "a row between";
}

TEST(PressureRuns, RegionsAreThoseOfAFloodFill) {
  std::mt19937_64 generator(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Grid grid = grid_of(9, 11);
    std::vector<double> pressure(grid.element_count());
    for (double& p : pressure) {
      p = generator() % 100 < 20U + static_cast<unsigned>(trial) % 60U ? 1.0 : 0.0;
    }
    const std::vector<std::size_t> expected = flooded(grid, pressure);
    std::vector<wrc::Run> runs = find_runs(grid, pressure);
    join_neighbours(runs);
    std::map<std::size_t, std::size_t> names; // of a root: the flooded region
    std::map<std::size_t, std::size_t> roots;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::size_t root = root_of_run(runs, r);
      for (std::size_t j = runs[r].first; j < runs[r].last; ++j) {
        const std::size_t region = expected[runs[r].row * grid.longitudinal_count + j];
        EXPECT_EQ(names.emplace(root, region).first->second, region) << trial;
        EXPECT_EQ(roots.emplace(region, root).first->second, root) << trial;
      }
    }
  }
}

TEST(PressureRuns, PressuresOfAnotherGridAreRefused) {
  const std::vector<double> pressure(11);
  expect_error(
      ErrorCode::invalid_argument, [&] { check_pressure_size(grid_of(3, 4), pressure); }, "11",
      "12");
  EXPECT_NO_THROW(check_pressure_size(grid_of(1, 11), pressure));
}

} // namespace
} // namespace wrc::test::pressure_runs_test
