/// The first solution in a fresh process: this program starts itself with --first-solve.
#pragma once

#include "wrc_benchmark/problem.hpp"

namespace benchmark {

struct FirstSolve {
  Times times;
  double memory_mb = 0.0; ///< peak memory minus that before the case's handles were made
};

/// What the child does: solves once and prints times and memory as JSON.
void print_first_solve(Problem& problem, const Settings& settings);

/// Starts a child and reads what it prints. Throws Failure.
FirstSolve run_first_solve(const std::string& case_name, const GridSize& grid, int wheels,
                           const Settings& settings);

} // namespace benchmark
