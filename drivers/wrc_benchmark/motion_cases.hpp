/// Scenes that change from step to step, as in a vehicle simulation, and many scenes at once.
#pragma once

#include <string>
#include <vector>

#include "wrc_benchmark/row.hpp"

namespace benchmark {

struct MotionPlan {
  std::vector<std::string> methods{"default", "paper"};
  std::vector<double> accuracies{1e-2, 1e-3}; ///< asked of pmax
  int steps = 200;
};

/// Both wheels of the Table 1 scene, one solver: hunting by 3 mm, and steps of 1 % and 0.1 % of the
/// patch's width. Beside the default method, paper goes through five steps of the hunting only. The
/// yardstick of these rows is that of 256x128, since grids change from step to step.
std::vector<Row> measure_vehicle_steps(const MotionPlan& plan);

struct Batch {
  std::vector<Row> rows; ///< one a number of threads
  double speedup = 0.0;  ///< of two threads
  /// Of two threads that only transform, each on memory of its own: what this machine, with
  /// whatever else goes on in it, has to give.
  double machine_speedup = 0.0;
  double work_ratio = 0.0; ///< processor time of two threads over that of one
  bool bitwise_equal = false;
};

/// 64 scenes by wrc_solve_batch on one and on two threads, in turns.
Batch measure_batch(int repeat);

} // namespace benchmark
