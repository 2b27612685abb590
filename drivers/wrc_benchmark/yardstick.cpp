#include "wrc_benchmark/yardstick.hpp"

#include "wrc_benchmark/transform.hpp"

namespace benchmark {

Times median(const std::vector<Times>& times) {
  const auto of = [&times](double Times::*stage) { return median(driver::all_of(times, stage)); };
  return {of(&Times::setup), of(&Times::geometry), of(&Times::remesh), of(&Times::mechanics),
          of(&Times::total)};
}

double Yardstick::measure() const {
  // A sample takes some milliseconds: several small pairs, one large one.
  constexpr std::int64_t large = 1024 * 512;
  const int repeats = grid_.count() >= large ? 1 : 5;
  return measure_transform({2 * grid_.lateral, 2 * grid_.longitudinal}, repeats);
}

void Yardstick::sample() {
  samples_.push_back(measure());
}

double Yardstick::milliseconds() {
  if (samples_.empty()) {
    sample();
  }
  return median(samples_);
}

} // namespace benchmark
