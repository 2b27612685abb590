/// Rows of the cases that have a grid of their own: every method in every state.
#pragma once

#include <string>
#include <vector>

#include "wrc_benchmark/problem.hpp"

namespace benchmark {

struct Plan {
  std::vector<std::string> methods{"default", "paper"};
  double accuracy = 1e-4; ///< asked: largest error of p relative to pmax
  int repeat = 15;        ///< warm solutions; fewer where they take seconds
};

/// 0 wheels for a given gap.
std::unique_ptr<Problem> make_problem(const std::string& case_name, const GridSize& grid,
                                      int wheels);

std::vector<Row> measure(const std::string& case_name, const GridSize& grid, int wheels,
                         const Plan& plan);

} // namespace benchmark
