/// What times are compared with, and medians of them.
#pragma once

#include <vector>

#include "support/statistics.hpp"
#include "support/stopwatch.hpp"
#include "wrc_benchmark/problem.hpp"

namespace benchmark {

using driver::median;
using driver::ProcessorStopwatch;
using driver::quantile;
using driver::Stopwatch;
/// Stage by stage.
Times median(const std::vector<Times>& times);
inline std::vector<double> totals(const std::vector<Times>& times) {
  return driver::all_of(times, &Times::total);
}

/// One padded transform and its inverse (transform.hpp), sampled again and again between the
/// solutions it is compared with.
class Yardstick {
public:
  explicit Yardstick(const GridSize& grid) : grid_(grid) {}
  void sample();
  /// Median of all samples; samples once if there are none.
  double milliseconds();

private:
  [[nodiscard]] double measure() const;
  GridSize grid_;
  std::vector<double> samples_;
};

} // namespace benchmark
