/// What is measured: one row of the benchmark.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace benchmark {

struct GridSize {
  std::int64_t lateral = 256;
  std::int64_t longitudinal = 128;

  [[nodiscard]] std::int64_t count() const { return lateral * longitudinal; }
  [[nodiscard]] std::string text() const {
    return std::to_string(lateral) + 'x' + std::to_string(longitudinal);
  }
};

/// Milliseconds by stage; what belongs to no stage is set-up.
struct Times {
  double setup = 0.0;
  double geometry = 0.0;
  double remesh = 0.0;
  double mechanics = 0.0;
  double total = 0.0;
};

struct Row {
  std::string case_name;
  std::string motion; ///< vehicle-step: how the scene changes from step to step
  GridSize grid;
  std::string method;
  std::string state; ///< "cold-process", "cold" or "warm"
  int wheels = 1;    ///< wheels solved; 0: a gap is given, there is no wheel
  int threads = 1;
  double accuracy = 0.0;            ///< asked
  std::optional<double> tolerance;  ///< of the iteration, if it is set by hand
  double fill = 0.0;                ///< share of elements under pressure
  double iterations = 0.0;          ///< a wheel, all grids together
  std::optional<double> error_p;    ///< largest, relative to pmax, on the same grid
  std::optional<double> error_pmax; ///< relative, against closed form or finer grid
  Times times;                      ///< medians
  double min_ms = 0.0;              ///< least total
  std::optional<double> percentile_90_ms;
  std::optional<double> worst_ms;
  double fft_pair_ms = 0.0;
  std::optional<double> memory_mb;
  int repeats = 0; ///< solutions behind the medians

  [[nodiscard]] double pairs() const { return times.mechanics / fft_pair_ms; }
  [[nodiscard]] double total_pairs() const { return times.total / fft_pair_ms; }
};

} // namespace benchmark
