/// Rows of the cases that have a grid of their own: every method in every state.
#pragma once

#include <string>
#include <vector>

#include "wrc_benchmark/problem.hpp"

namespace benchmark {

/// 0 wheels for a given gap.
std::unique_ptr<Problem> make_problem(const std::string& case_name, const GridSize& grid,
                                      int wheels);

std::vector<Row> measure(const std::string& case_name, const GridSize& grid, int wheels,
                         const Plan& plan);

/// What this program does that starts itself with --first-solve: solves once and prints times and
/// memory as JSON.
void print_first_solve(Problem& problem, const Settings& settings);

} // namespace benchmark
