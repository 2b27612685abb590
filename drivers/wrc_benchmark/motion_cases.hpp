/// Scenes that change from step to step, as in a vehicle simulation, and many scenes at once.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "wrc_benchmark/problem.hpp"

namespace benchmark {

/// Both wheels of the Table 1 scene, one solver: hunting by 3 mm, and steps of 1 % and 0.1 % of the
/// patch's width. Beside the default method, paper goes through five steps of the hunting only. The
/// yardstick of these rows is that of 256x128, since grids change from step to step.
std::vector<Row> measure_vehicle_steps(const Plan& plan);

struct Batch {
  std::vector<Row> rows; ///< one per number of threads
  double speedup = 0.0;  ///< of two threads
  /// Speed of two threads that only transform, each in its own memory: the most that this machine
  /// allows, with its other load.
  double machine_speedup = 0.0;
  double work_ratio = 0.0; ///< processor time of two threads over that of one
  bool bitwise_equal = false;
};

/// 64 scenes by wrc_solve_batch on one and on two threads, in turns.
Batch measure_batch(int repeat);

/// One run of one pair of profiles. Processor times of a step: both wheels, keys set and solved.
struct ServiceRow {
  std::string wheel;
  std::string rail;
  std::string accuracy_of; ///< solve.accuracy_of: "forces" or "pressures"
  std::string prescribed;  ///< "load" or "position"
  double accuracy = 0.0;   ///< requested
  std::string creep;       ///< forces of it: "none", of "creepages" or of the run's "motion"
  int steps = 0;           ///< counted: without the first one, which is cold
  /// One wheel's largest errors at these steps, relative.
  struct Errors {
    std::optional<double> depth;        ///< none if the position is prescribed
    std::optional<double> normal_force; ///< none if the load is prescribed
    double lateral_force = 0.0;         ///< over the vertical force
    double pmax = 0.0;

    [[nodiscard]] double force() const {
      return std::max(normal_force.value_or(0.0), lateral_force);
    }
  } errors;
  double reference_estimate = 0.0; ///< largest estimated error of the reference solutions
  double solutions_mean = 0.0;     ///< joint solutions of a wheel's patches in a step
  double solutions_max = 0.0;
  /// Milliseconds.
  struct Times {
    double mean = 0.0;
    double median = 0.0;
    double percentile_99 = 0.0;
    double percentile_999 = 0.0;
    double worst = 0.0;
  } times;
  double fft_pair_ms = 0.0; ///< that of 256x128

  [[nodiscard]] double pairs(double Times::*time) const { return times.*time / fft_pair_ms; }
};

/// Three pairs of profiles, each at the accuracies of the plan (or 1e-2 and 1e-3), of forces and of
/// pressures, with the load prescribed and with the position prescribed: roll and a height for each
/// wheel at which the same forces come out.
std::vector<ServiceRow> measure_service(const Plan& plan);

} // namespace benchmark
