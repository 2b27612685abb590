/// A wheelset in service: a run over irregular track, step by step, as a vehicle simulation asks
/// for it.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace benchmark {

struct ServicePlan {
  std::vector<double> accuracies{1e-2, 1e-3};
  int steps = 2000;
};

/// One run of one pair of profiles. Processor times of a step: both wheels, keys set and solved.
struct ServiceRow {
  std::string wheel;
  std::string rail;
  std::string accuracy_of; ///< solve.accuracy_of: "forces" or "pressures"
  std::string prescribed;  ///< "load" or "position"
  double accuracy = 0.0;   ///< asked
  int steps = 0;           ///< counted: without the first one, which is cold
  /// One wheel's greatest at the judged steps, relative.
  struct Errors {
    std::optional<double> depth;        ///< none if the position is prescribed
    std::optional<double> normal_force; ///< none if the load is prescribed
    double lateral_force = 0.0;         ///< over the vertical force
    double pmax = 0.0;

    [[nodiscard]] double force() const {
      return std::max(normal_force.value_or(0.0), lateral_force);
    }
  } errors;
  double reference_estimate = 0.0; ///< largest error that the solutions judged against own up to
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

/// Three pairs of profiles, each at the accuracies of the plan, of forces and of pressures, with
/// the load prescribed and with the position prescribed: roll and a height for each wheel at which
/// the same forces come out.
std::vector<ServiceRow> measure_service(const ServicePlan& plan);

} // namespace benchmark
