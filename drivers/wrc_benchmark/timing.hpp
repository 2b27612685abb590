/// Clock, statistics, and the yardstick.
#pragma once

#include <chrono>
#include <vector>

#include "support/statistics.hpp"
#include "wrc_benchmark/row.hpp"

namespace benchmark {

class Stopwatch {
public:
  /// Milliseconds since it was made or last read.
  double lap() {
    const Clock::time_point now = Clock::now();
    const double milliseconds = 1e3 * std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return milliseconds;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

using driver::median;
using driver::quantile;
/// Stage by stage.
Times median(const std::vector<Times>& times);
std::vector<double> totals(const std::vector<Times>& times);

/// One padded transform and its inverse (wrc_measure_transform), sampled again and again between
/// the solutions it is compared with.
class Yardstick {
public:
  explicit Yardstick(const GridSize& grid) : grid_(grid) {}
  void sample();
  /// Median of all samples; samples once if there are none.
  double milliseconds();

private:
  GridSize grid_;
  std::vector<double> samples_;
};

} // namespace benchmark
