/// Clock, statistics, and the yardstick.
#pragma once

#include <chrono>
#include <utility>
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

/// The same of the processor's time in this process: what else goes on in the machine does not
/// count.
class ProcessorStopwatch {
public:
  double lap() {
    const double now = milliseconds();
    return now - std::exchange(start_, now);
  }

private:
  static double milliseconds();
  double start_ = milliseconds();
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
  /// One during which the process had a processor to itself, as far as there is one: what went by
  /// is then processor time.
  void sample_undisturbed();
  /// Median of all samples; samples once if there are none.
  double milliseconds();

private:
  [[nodiscard]] double measure() const;
  GridSize grid_;
  std::vector<double> samples_;
};

} // namespace benchmark
